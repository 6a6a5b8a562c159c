// What becomes of unsaved work: kept while it is made, asked about when the window closes, back at the next
// start.
#include "app/main_window.h"
#include "app/standard_streams.h"
#include "lessons/session_file.h"
#include "widgets/inspector.h"

#include <QCloseEvent>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTimer>

#include <algorithm>

namespace halfspace {
namespace {

constexpr int messageTime = 8000; // milliseconds

/// Whether a session is what its file holds.
bool isSaved(const UnsavedWork &work) { return work.file && work.file->text == writeSession(work.session); }

} // namespace

QString MainWindow::finishInput() {
  m_scene->finishDrag();
  return m_inspector->enterTyped();
}

bool MainWindow::hasChanges() const { return !m_model.history().isClean(); }

bool MainWindow::hasLeftSessions() const {
  const auto &left = m_model.leftSessions();
  return std::any_of(left.begin(), left.end(),
                     [this](const auto &each) { return each.first != m_model.session().lesson; });
}

UnsavedWork MainWindow::unsavedWork() const {
  return {m_model.session(), m_model.leftSessions(), belongsToFile() ? m_file : std::nullopt, m_progress};
}

void MainWindow::keepUnsavedSoon() {
  if (!m_keepTimer.isActive())
    m_keepTimer.start();
}

void MainWindow::keepOrForget() {
  if (hasChanges() || hasLeftSessions())
    keepNow(unsavedWork());
  else
    m_recovery.forget();
}

std::optional<Problem> MainWindow::keepNow(const UnsavedWork &work) {
  m_keepTimer.stop();
  auto problem = m_recovery.keep(work);
  if (problem)
    statusBar()->showMessage(tr("Unsaved work cannot be kept for the next start: save it to a file.") + " " +
                             QString::fromStdString(problem->text()));
  return problem;
}

bool MainWindow::askToKeepChanges() {
  const auto answer =
      QMessageBox::question(this, tr("Halfspace"), tr("Save your changes to this session first?"),
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

bool MainWindow::askToReplace(const KnownFile &file) {
  QMessageBox box(
      QMessageBox::Warning, tr("Halfspace"),
      tr("%1 is not any more as it was when you opened or saved it here: another window or program "
         "has written it. Replace it by this session?")
          .arg(QFileInfo(file.path).fileName()),
      QMessageBox::Cancel, this);
  box.setTextFormat(Qt::PlainText);
  const QPushButton *replace = box.addButton(tr("&Replace"), QMessageBox::DestructiveRole);
  QPushButton *elsewhere = box.addButton(tr("Save &As…"), QMessageBox::AcceptRole);
  box.setDefaultButton(elsewhere);
  box.exec();
  if (box.clickedButton() == replace)
    return saveTo(QString(file.path)); // saving changes what is known of the file
  return box.clickedButton() == elsewhere && saveAs();
}

bool MainWindow::askToGoWithout(const QString &refused) {
  return QMessageBox::question(this, tr("Halfspace"), refused + "\n" + tr("Go on without this number?"),
                               QMessageBox::Yes | QMessageBox::Cancel,
                               QMessageBox::Cancel) == QMessageBox::Yes;
}

bool MainWindow::keepForNextStart(bool changesKept) {
  m_keepTimer.stop();
  if (!changesKept && !hasLeftSessions()) {
    m_recovery.forget();
    return true;
  }
  UnsavedWork work = unsavedWork();
  if (!changesKept && work.file)
    if (const auto saved = readSession(work.file->text, work.file->path.toStdString()))
      work.session = *saved;
  const auto problem = keepNow(work);
  if (!problem)
    return true;
  const auto answer =
      QMessageBox::warning(this, tr("Halfspace"),
                           tr("Unsaved work cannot be kept for the next start. Save it to a file?") + "\n" +
                               QString::fromStdString(problem->text()),
                           QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveAs());
}

void MainWindow::closeEvent(QCloseEvent *event) {
  event->ignore();
  if (const QString refused = finishInput(); !refused.isEmpty() && !askToGoWithout(refused))
    return;
  const bool ofFile = belongsToFile();
  if (hasChanges() && ofFile && !askToKeepChanges())
    return;
  // What has no file comes back with the next start, without a question.
  if (!keepForNextStart(hasChanges() && !ofFile))
    return;
  storeSettings();
  event->accept();
}

void MainWindow::endWithoutQuestions() {
  static_cast<void>(finishInput()); // what cannot be entered is no number
  if (!hasChanges() && !hasLeftSessions())
    m_recovery.forget();
  else if (const auto problem = keepNow(unsavedWork()))
    printError(problem->text());
  storeSettings();
}

void MainWindow::takeUp(const Recovery::Leftover &leftover) {
  if (hasChanges() || hasLeftSessions()) {
    // It becomes a leftover itself.
    if (const auto problem = keepNow(unsavedWork()))
      return complain(QString::fromStdString(problem->text()));
  }
  if (!m_recovery.adopt(leftover.path))
    return complain(tr("Another window has taken up this work already."));
  const UnsavedWork &work = leftover.work;
  m_progress = work.progress;
  m_model.setLeftSessions(work.left);
  startWith(work.session, work.file);
  if (!isSaved(work))
    m_model.history().resetClean();
  keepOrForget();
  const auto drawn = std::make_shared<QMetaObject::Connection>();
  *drawn = connect(m_scene, &SceneView::frameDrawn, this, [this, drawn] {
    disconnect(*drawn);
    m_openedTimer.start();
  });
  statusBar()->showMessage(tr("Your unsaved work is back. Edit > Start Over begins the lesson anew."),
                           messageTime);
}

void MainWindow::offerAgain(const Recovery::Leftover &leftover) {
  const auto answer = QMessageBox::question(
      this, tr("Halfspace"),
      tr("The program ended while it was opening your unsaved work of %1. Open it again? It stays in File > "
         "Unsaved Work.")
          .arg(QLocale().toString(leftover.written, QLocale::ShortFormat)),
      QMessageBox::Open | QMessageBox::Cancel, QMessageBox::Cancel);
  if (answer == QMessageBox::Open)
    takeUp(leftover);
}

void MainWindow::restoreUnsaved() {
  const auto leftovers = m_recovery.leftovers();
  if (leftovers.empty())
    return;
  if (!leftovers.front().endedItsProgram)
    return takeUp(leftovers.front());
  QTimer::singleShot(0, this, [this, leftover = leftovers.front()] { offerAgain(leftover); });
}

void MainWindow::offerUnsaved() {
  const auto leftovers = m_recovery.leftovers();
  const auto ours =
      std::find_if(leftovers.begin(), leftovers.end(), [this](const Recovery::Leftover &leftover) {
        return m_file && leftover.work.file && leftover.work.file->path == m_file->path;
      });
  if (ours != leftovers.end() &&
      QMessageBox::question(
          this, tr("Halfspace"),
          tr("There are unsaved changes to %1 from a run that was cut off. Go on with them?")
              .arg(QFileInfo(m_file->path).fileName())) == QMessageBox::Yes)
    return takeUp(*ours);
  if (!leftovers.empty())
    statusBar()->showMessage(tr("Unsaved work from an earlier run waits in File > Unsaved Work."),
                             messageTime);
}

void MainWindow::fillUnsavedMenu(QMenu &menu) {
  menu.clear();
  for (const Recovery::Leftover &leftover : m_recovery.leftovers()) {
    const UnsavedWork &work = leftover.work;
    const Lesson *lesson = m_model.library().find(work.session.lesson);
    const QString name = work.file ? QFileInfo(work.file->path).fileName()
                                   : QString::fromStdString(lesson ? lesson->title : work.session.lesson);
    menu.addAction(tr("%1 (%2)").arg(name, QLocale().toString(leftover.written, QLocale::ShortFormat)), this,
                   [this, leftover] { takeUp(leftover); });
  }
  if (menu.isEmpty())
    menu.addAction(tr("None"))->setEnabled(false);
}

} // namespace halfspace
