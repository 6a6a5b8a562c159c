// A learner's own meshes: opened, dropped on the window, and put into the scene.
#include "app/main_window.h"
#include "lessons/scene/large_meshes.h"
#include "lessons/scene/target_mesh.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLocale>
#include <QMimeData>
#include <QProgressDialog>
#include <QUrl>

namespace halfspace {
namespace {

/// The lesson in which a mesh is shown that is opened in one that has no use for it.
constexpr const char *meshLesson = "photon-torpedo";
/// What takes longer, in milliseconds, shows a bar.
constexpr int longestSilence = 400;
/// The bar's steps.
constexpr int wholeProgress = 1000;

/// The one local file that is dropped; empty for anything else.
QString fileIn(const QMimeData &data) {
  const QList<QUrl> urls = data.urls();
  return urls.size() == 1 ? urls.front().toLocalFile() : QString();
}

QString leftOutWords(const LoadedMesh &mesh) {
  QStringList parts;
  if (mesh.degenerate > 0)
    parts << MainWindow::tr("%n without an area", nullptr, static_cast<int>(mesh.degenerate));
  if (mesh.repeated > 0)
    parts << MainWindow::tr("%n that stand there twice", nullptr, static_cast<int>(mesh.repeated));
  if (mesh.broken > 0)
    parts << MainWindow::tr("%n broken", nullptr, static_cast<int>(mesh.broken));
  return parts.isEmpty() ? QString() : MainWindow::tr(" Left out: %1.").arg(parts.join(", "));
}

} // namespace

void MainWindow::connectMeshes() {
  setAcceptDrops(true);
  connect(&m_meshLoader, &MeshLoader::progressed, this, &MainWindow::showMeshProgress);
  connect(&m_meshLoader, &MeshLoader::loaded, this, [this](const LoadedMesh &mesh) {
    endMeshProgress();
    takeMesh(mesh);
  });
  connect(&m_meshLoader, &MeshLoader::failed, this, [this](const QString &sentence) {
    endMeshProgress();
    complain(sentence);
  });
  connect(&m_meshLoader, &MeshLoader::cancelled, this, &MainWindow::endMeshProgress);
}

void MainWindow::askForMesh() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open mesh"), {}, tr("Meshes (*.stl *.obj *.ply)"));
  if (!file.isEmpty())
    openMesh(file);
}

void MainWindow::openMesh(const QString &file) { m_meshLoader.start(file); }

void MainWindow::showMeshProgress(double part, const QString &what) {
  if (!m_meshProgress) {
    m_meshProgress = new QProgressDialog(this);
    m_meshProgress->setObjectName("meshProgress");
    m_meshProgress->setWindowTitle(tr("Open mesh"));
    m_meshProgress->setMinimumDuration(longestSilence);
    m_meshProgress->setAutoReset(false);
    m_meshProgress->setAutoClose(false);
    connect(m_meshProgress, &QProgressDialog::canceled, &m_meshLoader, &MeshLoader::cancel);
  }
  m_meshProgress->setLabelText(what);
  m_meshProgress->setRange(0, part < 0 ? 0 : wholeProgress);
  if (part >= 0)
    m_meshProgress->setValue(static_cast<int>(part * wholeProgress));
}

void MainWindow::endMeshProgress() {
  if (!m_meshProgress)
    return;
  m_meshProgress->disconnect(&m_meshLoader); // closing it would cancel the next
  m_meshProgress->reset();                   // or it would be shown after its silence
  m_meshProgress->hide();
  m_meshProgress->deleteLater();
  m_meshProgress = nullptr;
}

void MainWindow::takeMesh(const LoadedMesh &mesh) {
  if (!takesMeshes(m_model.session().scene))
    m_model.openLesson(meshLesson);
  m_model.beginGesture(tr("Open %1").arg(QString::fromStdString(mesh.name)));
  for (const Edit &edit : editsForTarget(m_model.session().scene, mesh.shape))
    m_model.moveGesture(edit);
  m_model.endGesture();
  const Object *target = findObject(m_model.session().scene, targetName);
  if (!target || target->shape() != mesh.shape)
    return complain(tr("The scene has no room for a mesh named “%1”.").arg(targetName));
  const auto side = [](double length) { return QString::number(length, 'g', 4); };
  const QString triangles = mesh.triangles == 1
                                ? tr("1 triangle")
                                : tr("%1 triangles").arg(QLocale().toString(qulonglong(mesh.triangles)));
  say(tr("%1: %2, %3 × %4 × %5 of the file's units.")
          .arg(QString::fromStdString(mesh.name), triangles, side(mesh.size.x), side(mesh.size.y),
               side(mesh.size.z)) +
      leftOutWords(mesh) +
      (isTooLargeToWrite(*target) ? tr(" Too large to be saved with the session.") : QString()));
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event) {
  if (!fileIn(*event->mimeData()).isEmpty())
    event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent *event) {
  const QString file = fileIn(*event->mimeData());
  if (file.isEmpty())
    return;
  event->acceptProposedAction();
  if (!file.endsWith(".halfspace"))
    return openMesh(file);
  if (!hasChanges() || askToKeepChanges())
    openFile(file);
}

} // namespace halfspace
