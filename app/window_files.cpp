// Sessions and pictures in files.
#include "app/main_window.h"
#include "app/memory.h"
#include "app/open_session.h"
#include "app/panels/unfinished_input.h"
#include "lessons/files/read_file.h"
#include "lessons/files/write_file.h"
#include "lessons/scene/file/large_meshes.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/scene/file/shape_text.h"
#include "widgets/scene/offscreen.h"
#include "widgets/scene/png.h"
#include "widgets/text/figures.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QMessageBox>

#include <algorithm>

namespace halfspace {
namespace {

/// Pictures are made this much finer than the screen shows them.
constexpr double pictureScale = 2;

/// What is told of a scene that is saved.
QString savedWords(const Scene &scene) {
  QStringList left;
  for (const std::string &name : largeMeshes(scene))
    left << QString::fromStdString(name);
  if (left.isEmpty())
    return MainWindow::tr("Saved.");
  return MainWindow::tr(
             "Saved, but without %1: a mesh of more than %2 triangles is not kept in a session. Open "
             "its own file again to go on with it.")
      .arg(left.join(", "), counted(mostWrittenTriangles));
}

/// Whether nothing is lost by writing a text to a file: it is gone, as it was when it was last read or
/// written here, or holds that text already.
bool mayReplace(const KnownFile &file, const std::string &text) {
  std::error_code error;
  if (!std::filesystem::exists(file.path.toStdString(), error) && !error)
    return true;
  const auto found = readFile(file.path.toStdString(), maxSessionBytes);
  return found && (*found == file.text || *found == text);
}

} // namespace

void MainWindow::startWith(const Session &session, std::optional<KnownFile> file) {
  m_file = std::move(file);
  m_model.startWith(session);
  updateTitle();
}

void MainWindow::openFile(const QString &file) {
  LessonLibrary library = m_model.library();
  auto opened = openSession(library, file.toStdString());
  if (!opened)
    return m_messages.complain(QString::fromStdString(opened.problem().text()));
  std::optional<KnownFile> known;
  if (opened->text)
    known = KnownFile{QFileInfo(file).absoluteFilePath(), std::move(*opened->text), opened->session.lesson};
  else
    m_model.setLibrary(std::move(library)); // with the lesson
  startWith(opened->session, std::move(known));
}

bool MainWindow::saveTo(const QString &file) {
  const std::string text = writeSession(m_model.session());
  if (const auto problem = writeFile(file.toStdString(), text)) {
    m_messages.complain(tr("The session is not saved.") + "\n" + QString::fromStdString(problem->text()));
    return false;
  }
  m_file = {QFileInfo(file).absoluteFilePath(), text, m_model.session().lesson};
  m_model.history().setClean();
  keepUnsavedSoon();
  updateTitle();
  m_messages.say(savedWords(m_model.session().scene));
  return true;
}

bool MainWindow::belongsToFile() const { return m_file && m_model.session().lesson == m_file->lesson; }

bool MainWindow::save() {
  if (const QString refused = m_input.finish(); !refused.isEmpty()) {
    m_messages.complain(tr("The session is not saved.") + "\n" + refused);
    return false;
  }
  if (!belongsToFile())
    return saveAs();
  return mayReplace(*m_file, writeSession(m_model.session())) ? saveTo(QString(m_file->path))
                                                              : askToReplace(*m_file);
}

QString MainWindow::askForFile(const QString &title, const QString &filter, const QString &suffix) {
  QFileDialog dialog(this, title, {}, filter);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(suffix);
  dialog.selectFile(QString::fromStdString(m_model.session().lesson) + "." + suffix);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

bool MainWindow::saveAs() {
  if (const QString refused = m_input.finish(); !refused.isEmpty()) {
    m_messages.complain(tr("The session is not saved.") + "\n" + refused);
    return false;
  }
  const QString file = askForFile(tr("Save session"), tr("Halfspace sessions (*.halfspace)"), "halfspace");
  return !file.isEmpty() && saveTo(file);
}

void MainWindow::open() {
  if (!mayLeaveSession())
    return;
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open"), {}, tr("Sessions and lessons (*.halfspace *.md)"));
  if (!file.isEmpty())
    openFile(file);
}

std::optional<LabelPicture> MainWindow::pictureOfScene() {
  PictureRequest request;
  request.content = m_scene->pictureContent();
  request.camera = m_scene->camera();
  request.theme = m_look.theme();
  const PixelSize size = m_scene->pixelSize();
  const double fitting = std::min(pictureScale, double(maxPictureSide) / std::max(size.width, size.height));
  request.pixelRatio = m_scene->designRatio() * fitting;
  request.size = {static_cast<int>(size.width * fitting), static_cast<int>(size.height * fitting)};
  // The picture is drawn in a context of its own; two current ones in a thread clash.
  m_scene->doneCurrent();
  const Typesetter &typesetter = m_panels.typesetter();
  auto picture = OffscreenPainter(labelSetter(typesetter.fonts()), labelPainter(typesetter)).draw(request);
  returnFreeMemory(); // the context that has ended leaves a hundred megabytes
  if (!picture) {
    m_messages.complain(QString::fromStdString(picture.problem().text()));
    return {};
  }
  return std::move(*picture);
}

bool MainWindow::savePicture(const QString &file) {
  const auto picture = pictureOfScene();
  if (!picture)
    return false;
  if (const auto problem = writePng(*picture, file.toStdString())) {
    m_messages.complain(QString::fromStdString(problem->text()));
    return false;
  }
  m_messages.say(tr("Picture saved."));
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
    m_messages.say(tr("Picture copied."));
  }
}

} // namespace halfspace
