// Sessions and pictures in files, and unsaved work that comes back.
#include "app/main_window.h"
#include "app/memory.h"
#include "app/session_files.h"
#include "lessons/session_file.h"
#include "widgets/scene/offscreen.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QMenu>
#include <QMessageBox>
#include <QStatusBar>

#include <algorithm>

namespace halfspace {
namespace {

constexpr int messageTime = 8000; // milliseconds
/// Pictures are made this much finer than the screen shows them.
constexpr double pictureScale = 2;

} // namespace

void MainWindow::startWith(const Session &session, const QString &file) {
  m_file = file.isEmpty() ? QString() : QFileInfo(file).absoluteFilePath();
  m_fileLesson = session.lesson;
  m_model.startWith(session);
  updateTitle();
}

void MainWindow::openFile(const QString &file) {
  const auto session = readSessionFile(file.toStdString());
  if (!session)
    return complain(QString::fromStdString(session.problem().text()));
  startWith(*session, file);
}

bool MainWindow::saveTo(const QString &file) {
  if (const auto problem = writeSessionFile(m_model.session(), file)) {
    complain(QString::fromStdString(problem->text()));
    return false;
  }
  m_file = QFileInfo(file).absoluteFilePath();
  m_fileLesson = m_model.session().lesson;
  m_model.history().setClean();
  m_recovery.forget();
  updateTitle();
  statusBar()->showMessage(tr("Saved."), messageTime);
  return true;
}

bool MainWindow::belongsToFile() const {
  return !m_file.isEmpty() && m_model.session().lesson == m_fileLesson;
}

bool MainWindow::save() { return belongsToFile() ? saveTo(m_file) : saveAs(); }

QString MainWindow::askForFile(const QString &title, const QString &filter, const QString &suffix) {
  QFileDialog dialog(this, title, {}, filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  dialog.selectFile(QString::fromStdString(m_model.session().lesson) + "." + suffix);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

bool MainWindow::saveAs() {
  const QString file = askForFile(tr("Save session"), tr("Halfspace sessions (*.halfspace)"), "halfspace");
  return !file.isEmpty() && saveTo(file);
}

void MainWindow::open() {
  const bool unsaved = !m_model.history().isClean() && (belongsToFile() || m_model.isChanged());
  if (unsaved && !askToKeepChanges())
    return;
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open session"), {}, tr("Halfspace sessions (*.halfspace)"));
  if (!file.isEmpty())
    openFile(file);
}

bool MainWindow::askToKeepChanges() {
  const auto answer =
      QMessageBox::question(this, tr("Halfspace"), tr("Save your changes to this session first?"),
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

std::optional<LabelPicture> MainWindow::pictureOfScene() {
  PictureRequest request;
  request.content = m_scene->pictureContent();
  request.camera = m_scene->camera();
  request.theme = m_theme;
  const PixelSize size = m_scene->pixelSize();
  const double fitting = std::min(pictureScale, double(maxPictureSide) / std::max(size.width, size.height));
  request.pixelRatio = m_scene->designRatio() * fitting;
  request.size = {static_cast<int>(size.width * fitting), static_cast<int>(size.height * fitting)};
  // The picture is drawn in a context of its own; two current ones in a thread clash.
  m_scene->doneCurrent();
  auto picture = drawOffscreen(request, blockingLabelPainter(*m_typesetter));
  returnFreeMemory(); // the context that has ended leaves a hundred megabytes
  if (!picture) {
    complain(QString::fromStdString(picture.problem().text()));
    return {};
  }
  return std::move(*picture);
}

bool MainWindow::savePicture(const QString &file) {
  const auto picture = pictureOfScene();
  if (!picture)
    return false;
  if (const auto problem = writePng(*picture, file.toStdString())) {
    complain(QString::fromStdString(problem->text()));
    return false;
  }
  statusBar()->showMessage(tr("Picture saved."), messageTime);
  return true;
}

void MainWindow::exportPicture() {
  const QString file = askForFile(tr("Save picture"), tr("PNG pictures (*.png)"), "png");
  if (!file.isEmpty())
    savePicture(file);
}

void MainWindow::copyPicture() {
  if (const auto picture = pictureOfScene()) {
    const QImage image(picture->rgba.data(), picture->width, picture->height, picture->width * 4,
                       QImage::Format_RGBA8888);
    QApplication::clipboard()->setImage(image.copy());
    statusBar()->showMessage(tr("Picture copied."), messageTime);
  }
}

UnsavedWork MainWindow::unsavedWork() const {
  return {m_model.session(), m_model.leftSessions(), belongsToFile() ? m_file : QString(), m_progress};
}

void MainWindow::keepUnsaved() {
  if (m_model.history().isClean())
    m_recovery.forget();
  else
    m_recovery.keep(unsavedWork());
}

void MainWindow::takeUp(const Recovery::Leftover &leftover) {
  if (!m_model.history().isClean())
    m_recovery.keepNow(unsavedWork()); // it becomes a leftover itself
  if (!m_recovery.adopt(leftover.path))
    return complain(tr("Another window has taken up this work already."));
  const UnsavedWork &work = leftover.work;
  m_progress = work.progress;
  m_model.setLeftSessions(work.left);
  startWith(work.session, work.file);
  m_model.history().resetClean();
  m_recovery.keepNow(unsavedWork());
  statusBar()->showMessage(tr("Your unsaved work is back. Edit > Start Over begins the lesson anew."),
                           messageTime);
}

void MainWindow::restoreUnsaved() {
  const auto leftovers = m_recovery.leftovers();
  if (!leftovers.empty())
    takeUp(leftovers.front());
}

void MainWindow::offerUnsaved() {
  const auto leftovers = m_recovery.leftovers();
  const auto ours =
      std::find_if(leftovers.begin(), leftovers.end(), [this](const Recovery::Leftover &leftover) {
        return !m_file.isEmpty() && leftover.work.file == m_file;
      });
  if (ours != leftovers.end() &&
      QMessageBox::question(
          this, tr("Halfspace"),
          tr("There are unsaved changes to %1 from a run that was cut off. Go on with them?")
              .arg(QFileInfo(m_file).fileName())) == QMessageBox::Yes)
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
    const QString name = !work.file.isEmpty()
                             ? QFileInfo(work.file).fileName()
                             : QString::fromStdString(lesson ? lesson->title : work.session.lesson);
    menu.addAction(tr("%1 (%2)").arg(name, QLocale().toString(leftover.written, QLocale::ShortFormat)), this,
                   [this, leftover] { takeUp(leftover); });
  }
  if (menu.isEmpty())
    menu.addAction(tr("None"))->setEnabled(false);
}

} // namespace halfspace
