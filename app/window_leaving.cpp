// What becomes of unsaved work: kept while it is made, asked about when the window closes, back at the next
// start.
#include "app/main_window.h"
#include "app/panels/unfinished_input.h"
#include "app/standard_streams.h"
#include "lessons/scene/file/session_file.h"

#include <QCloseEvent>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <algorithm>

namespace halfspace {

bool MainWindow::hasChanges() const {
  // After another lesson was opened the history is not clean, though nothing need have changed.
  return !m_model.history().isClean() && (belongsToFile() || m_model.isChanged());
}

bool MainWindow::hasLeftSessions() const {
  const auto &left = m_model.leftSessions();
  return std::any_of(left.begin(), left.end(),
                     [this](const auto &each) { return each.first != m_model.session().lesson; });
}

UnsavedWork MainWindow::unsavedWork() const {
  return {m_model.session(), m_model.leftSessions(), belongsToFile() ? m_file : std::nullopt};
}

void MainWindow::prepareUnsaved() {
  const auto typed = m_input.typedChange();
  if (!typed && !hasChanges() && !hasLeftSessions() && !(m_model.inGesture() && m_model.isChanged()))
    return m_recovery.prepare({});
  UnsavedWork work = unsavedWork();
  if (typed)
    if (auto changed = apply(work.session, *typed))
      work.session = std::move(*changed);
  m_recovery.prepare(std::move(work));
}

void MainWindow::keepUnsavedSoon() {
  prepareUnsaved();
  if (!m_keepTimer.isActive())
    m_keepTimer.start();
}

std::optional<Problem> MainWindow::keepOrForget() {
  m_keepTimer.stop();
  std::optional<Problem> problem;
  if (hasChanges() || hasLeftSessions())
    problem = m_recovery.keep(unsavedWork());
  else
    m_recovery.forget();
  prepareUnsaved(); // what is being typed is not kept before it is entered
  const std::optional<Problem> lesser = m_progress.keep();
  if (problem)
    m_messages.warn(tr("Unsaved work cannot be kept for the next start: save it to a file."),
                    QString::fromStdString(problem->text()));
  else if (lesser)
    m_messages.warn(tr("What you have done cannot be kept for the next start."),
                    QString::fromStdString(lesser->text()));
  else
    m_messages.warn({});
  return problem;
}

bool MainWindow::mayLeaveSession() {
  if (!m_input.finishOrAsk())
    return false;
  return !hasChanges() || askToKeepChanges();
}

bool MainWindow::askToKeepChanges() {
  const QString name =
      m_file ? QFileInfo(m_file->path).fileName() : QString::fromStdString(m_model.lesson().title);
  QMessageBox box(QMessageBox::Question, tr("Halfspace"), tr("Save your changes to “%1” first?").arg(name),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setTextFormat(Qt::PlainText);
  const int answer = box.exec();
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

bool MainWindow::askToReplace(const KnownFile &file) {
  QMessageBox box(
      QMessageBox::Warning, tr("Halfspace"),
      tr("Another window or program has changed %1 since you opened it. Replace it with what you see here?")
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

void MainWindow::dropChanges() {
  if (const auto saved = readSession(m_file->text, m_file->path.toStdString()))
    startWith(*saved, KnownFile(*m_file));
}

bool MainWindow::keepForNextStart() {
  while (const auto problem = keepOrForget()) {
    // Only what is on the screen can be saved to a file.
    const bool canSave = hasChanges();
    QMessageBox box(QMessageBox::Warning, tr("Halfspace"),
                    (canSave ? tr("Unsaved work cannot be kept for the next start. Save it to a file?")
                             : tr("Your changes in other lessons cannot be kept for the next start. To keep "
                                  "them, cancel, open these lessons and save each to a file.")) +
                        "\n" + QString::fromStdString(problem->text()),
                    QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setTextFormat(Qt::PlainText);
    if (canSave)
      box.addButton(QMessageBox::Save);
    box.setDefaultButton(canSave ? QMessageBox::Save : QMessageBox::Cancel);
    const int answer = box.exec();
    if (answer == QMessageBox::Discard) {
      m_recovery.forget(); // an older state of it must not come back
      return true;
    }
    if (answer != QMessageBox::Save || !saveAs())
      return false;
  }
  return true;
}

void MainWindow::closeEvent(QCloseEvent *event) {
  event->ignore();
  if (!m_input.finishOrAsk())
    return;
  // What has no file comes back with the next start, without a question.
  if (hasChanges() && belongsToFile()) {
    if (!askToKeepChanges())
      return;
    if (hasChanges())
      dropChanges();
  }
  if (!keepForNextStart())
    return;
  m_meshes.leave();
  m_recovery.leave();
  storeSettings();
  event->accept();
  emit closed();
}

void MainWindow::endWithoutQuestions() {
  static_cast<void>(m_input.finish()); // what cannot be entered is no number
  if (const auto problem = keepOrForget())
    printError(problem->text());
  m_meshes.leave();
  m_recovery.leave();
  storeSettings();
}

void MainWindow::endWhileBusy() {
  if (const auto problem = m_recovery.keepPrepared())
    printError(problem->text());
}

void MainWindow::takeUp(const QString &leftover) {
  if (!m_input.finishOrAsk())
    return;
  // What is unsaved here becomes a leftover itself.
  if (const auto problem = keepOrForget())
    return m_messages.complain(QString::fromStdString(problem->text()));
  const auto work = m_recovery.adopt(leftover);
  if (!work)
    return m_messages.complain(tr("Another window has taken up this work already."));
  m_model.setLeftSessions(work->left);
  startWith(work->session, work->file);
  if (!work->file || work->file->text != writeSession(work->session))
    m_model.history().resetClean();
  const auto drawn = std::make_shared<QMetaObject::Connection>();
  *drawn = connect(m_scene, &SceneView::frameDrawn, this, [this, drawn] {
    disconnect(*drawn);
    m_openedTimer.start();
  });
  m_messages.say(tr("Your unsaved work is back. Edit > Start Over begins the lesson anew."));
}

void MainWindow::offerAgain(const Recovery::Leftover &leftover) {
  const auto answer =
      QMessageBox::question(this, tr("Halfspace"),
                            tr("The program ended while it was opening your unsaved work of %1. Open it "
                               "again? Else it stays in File "
                               "> Unsaved Work.")
                                .arg(QLocale().toString(leftover.written, QLocale::ShortFormat)),
                            QMessageBox::Open | QMessageBox::Cancel, QMessageBox::Cancel);
  if (answer == QMessageBox::Open)
    takeUp(leftover.path);
}

void MainWindow::restoreUnsaved() {
  const auto leftovers = m_recovery.leftovers();
  if (leftovers.empty())
    return;
  if (leftovers.front().endedItsProgram)
    offerAgain(leftovers.front());
  else
    takeUp(leftovers.front().path);
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
    return takeUp(ours->path);
  if (!leftovers.empty())
    m_messages.say(tr("Unsaved work from an earlier run waits in File > Unsaved Work."));
}

void MainWindow::fillUnsavedMenu(QMenu &menu) {
  menu.clear();
  for (const Recovery::Leftover &leftover : m_recovery.leftovers()) {
    const UnsavedWork &work = leftover.work;
    const Lesson *lesson = m_model.library().find(work.session.lesson);
    const QString name = work.file ? QFileInfo(work.file->path).fileName()
                                   : QString::fromStdString(lesson ? lesson->title : work.session.lesson);
    menu.addAction(tr("%1 (%2)").arg(name, QLocale().toString(leftover.written, QLocale::ShortFormat)), this,
                   [this, path = leftover.path] { takeUp(path); });
  }
  if (menu.isEmpty())
    menu.addAction(tr("None"))->setEnabled(false);
}

} // namespace halfspace
