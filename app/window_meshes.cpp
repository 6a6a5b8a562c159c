// A learner's own meshes: opened, dropped on the window, and put into the scene.
#include "app/main_window.h"
#include "lessons/object/kinds/mesh.h"
#include "lessons/scene/file/large_meshes.h"
#include "lessons/scene/target_mesh.h"
#include "widgets/text/figures.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLocale>
#include <QMimeData>
#include <QUrl>

#include <algorithm>

namespace halfspace {
namespace {

/// So many digits of a side of the box around a mesh are told.
constexpr int sideDigits = 4;

/// The one local file that is dropped; empty for anything else.
QString fileIn(const QMimeData &data) {
  const QList<QUrl> urls = data.urls();
  return urls.size() == 1 ? urls.front().toLocalFile() : QString();
}

QString leftOutWords(const LoadedMesh &mesh) {
  QStringList parts;
  if (mesh.degenerate > 0)
    parts << MainWindow::tr("%1 without an area").arg(counted(mesh.degenerate));
  if (mesh.repeated > 0)
    parts << MainWindow::tr("%1 that stand there twice").arg(counted(mesh.repeated));
  if (mesh.broken > 0)
    parts << MainWindow::tr("%1 broken").arg(counted(mesh.broken));
  return parts.isEmpty() ? QString() : MainWindow::tr(" Left out: %1.").arg(parts.join(", "));
}

/// A side of the box around a mesh; after ≈ where it has more digits.
QString sideWords(double length) {
  const QString text = roundedText(length, sideDigits);
  return QLocale(QLocale::English).toDouble(text) == length ? text : "≈ " + text;
}

} // namespace

void MainWindow::connectMeshes() {
  setAcceptDrops(true);
  connect(&m_meshes, &MeshOpener::opened, this, &MainWindow::takeMesh);
  connect(&m_meshes, &MeshOpener::failed, this, &MainWindow::complain);
}

void MainWindow::askForMesh() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open mesh"), {}, tr("Meshes (*.stl *.obj *.ply)"));
  if (!file.isEmpty())
    openMesh(file);
}

void MainWindow::openLessonWithMeshes() {
  const std::vector<Lesson> &lessons = m_model.library().lessons;
  const auto found = std::find_if(lessons.begin(), lessons.end(),
                                  [](const Lesson &lesson) { return takesMeshes(lesson.scene); });
  if (found != lessons.end())
    m_model.openLesson(found->id);
}

void MainWindow::takeMesh(const LoadedMesh &mesh) {
  if (!takesMeshes(m_model.session().scene))
    openLessonWithMeshes();
  const QString refusal = m_model.editTogether(editsForTarget(m_model.session().scene, mesh.shape),
                                               tr("Open %1").arg(QString::fromStdString(mesh.name)));
  if (!refusal.isEmpty())
    return m_messages.complain(refusal);
  m_messages.say(tr("%1: %2, %3 × %4 × %5 of the file's units.")
                     .arg(QString::fromStdString(mesh.name), trianglesInWords(mesh.triangles),
                          sideWords(mesh.size.x), sideWords(mesh.size.y), sideWords(mesh.size.z)) +
                 leftOutWords(mesh) +
                 (isTooLargeToWrite(*findObject(m_model.session().scene, targetName))
                      ? tr(" Too large to be saved with the session.")
                      : QString()));
}

std::string MainWindow::selectedMesh() const {
  std::string name = ownerOf(m_scene->selectedHandle());
  const Object *object = findObject(m_model.session().scene, name);
  return object && kindOf(*object) == MeshObject::kind ? name : std::string();
}

void MainWindow::copyMesh() {
  const auto copy = copyOfMesh(m_model.session().scene, selectedMesh());
  if (!copy)
    return m_messages.complain(
        tr("There is no room for one more mesh: a ray is held against eight at the most."));
  const QString refusal = m_model.editTogether(copy->edits, tr("Another mesh"));
  if (!refusal.isEmpty())
    return m_messages.complain(refusal);
  m_scene->selectHandle(copy->name + ".P");
  m_scene->setFocus(); // else the keys would go on with a number of the other
}

void MainWindow::removeMesh() {
  const std::string mesh = selectedMesh();
  const QString refusal =
      m_model.editTogether(editsToRemoveMesh(m_model.session().scene, mesh), tr("Remove the mesh"));
  if (!refusal.isEmpty())
    m_messages.complain(refusal);
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event) {
  if (!fileIn(*event->mimeData()).isEmpty())
    event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent *event) {
  const QString file = fileIn(*event->mimeData());
  if (file.isEmpty())
    return;
  event->setDropAction(Qt::CopyAction); // whoever moves deletes the file
  event->accept();
  if (!file.endsWith(".halfspace") && !file.endsWith(".md"))
    return openMesh(file);
  QTimer::singleShot(0, this, [this, file] { // the other program does not wait for questions
    if (mayLeaveSession())
      openFile(file);
  });
}

} // namespace halfspace
