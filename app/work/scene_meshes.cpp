#include "app/work/scene_meshes.h"

#include "lessons/object/kinds/mesh.h"
#include "lessons/scene/file/large_meshes.h"
#include "lessons/scene/target_mesh.h"
#include "widgets/flight/flight_player.h"
#include "widgets/text/figures.h"
#include "widgets/view/scene_view.h"

#include <QFileDialog>

#include <algorithm>

namespace halfspace {
namespace {

/// So many digits of a side of the box around a mesh are told.
constexpr int sideDigits = 4;

/// A list, so that each number can have a form of its own in languages where the count decides it.
QString leftOutWords(const LoadedMesh &mesh) {
  QStringList parts;
  if (mesh.degenerate > 0)
    parts << SceneMeshes::tr("%1 without an area", nullptr, formOf(mesh.degenerate))
                 .arg(counted(mesh.degenerate));
  if (mesh.repeated > 0)
    parts << SceneMeshes::tr("%1 that stand there twice", nullptr, formOf(mesh.repeated))
                 .arg(counted(mesh.repeated));
  if (mesh.broken > 0)
    parts << SceneMeshes::tr("%1 broken", nullptr, formOf(mesh.broken)).arg(counted(mesh.broken));
  return parts.isEmpty() ? QString() : " " + SceneMeshes::tr("Left out: %1.").arg(parts.join(", "));
}

} // namespace

SceneMeshes::SceneMeshes(SessionModel &model, SceneView &scene, const FlightPlayer &player, Messages messages)
    : m_model(model), m_scene(scene), m_messages(messages), m_opener(messages.window(), [&model, &player] {
        return model.history().inGesture() && !player.state().isPlaying;
      }) {
  connect(&m_opener, &MeshOpener::opened, this, &SceneMeshes::take);
  connect(&m_opener, &MeshOpener::failed, this,
          [this](const QString &sentence) { m_messages.complain(sentence); });
}

void SceneMeshes::askAndOpen() {
  const QString file = QFileDialog::getOpenFileName(&m_messages.window(), tr("Open mesh"), {},
                                                    tr("Meshes (*.stl *.obj *.ply)"));
  if (!file.isEmpty())
    open(file);
}

void SceneMeshes::openLessonWithMeshes() {
  const std::vector<Lesson> &lessons = m_model.library().lessons;
  const auto found = std::find_if(lessons.begin(), lessons.end(),
                                  [](const Lesson &lesson) { return takesMeshes(lesson.scene); });
  if (found != lessons.end())
    m_model.openLesson(found->id);
}

void SceneMeshes::take(const LoadedMesh &mesh) {
  if (!isExplore(m_model) && !takesMeshes(m_model.session().scene))
    openLessonWithMeshes();
  const Scene &scene = m_model.session().scene;
  const auto edits = isExplore(m_model) ? editsForMesh(scene, mesh.shape) : editsForTarget(scene, mesh.shape);
  const QString refusal =
      m_model.history().editTogether(edits, tr("Open %1").arg(QString::fromStdString(mesh.name)));
  if (!refusal.isEmpty())
    return m_messages.complain(refusal);
  m_messages.say(tr("%1: %2, %3 × %4 × %5 of the file's units.")
                     .arg(QString::fromStdString(mesh.name), trianglesInWords(mesh.triangles),
                          measuredText(mesh.size.x, sideDigits), measuredText(mesh.size.y, sideDigits),
                          measuredText(mesh.size.z, sideDigits)) +
                 leftOutWords(mesh) +
                 (isTooLargeToWrite(Object(MeshObject{{}, {1, 0, 0}, 1, mesh.shape}))
                      ? " " + tr("Too large to be saved with the session.")
                      : QString()));
}

std::string SceneMeshes::selected() const {
  std::string name = ownerOf(m_scene.handles().selection().selectedId());
  const Object *object = findObject(m_model.session().scene, name);
  return object && kindOf(*object) == MeshObject::kind ? name : std::string();
}

bool SceneMeshes::canCopySelected() const {
  return !selected().empty() && takesMeshes(m_model.session().scene);
}

void SceneMeshes::copySelected() {
  const auto copy = copyOfMesh(m_model.session().scene, selected());
  if (!copy)
    return m_messages.complain(
        tr("There is no room for one more mesh: a ray is held against eight at the most."));
  const QString refusal = m_model.history().editTogether(copy->edits, tr("Another mesh"));
  if (!refusal.isEmpty())
    return m_messages.complain(refusal);
  m_scene.handles().select(copy->name + ".P");
  m_scene.setFocus(); // else the keys would go on with a number of the other
}

bool SceneMeshes::canRemoveSelected() const {
  const std::string mesh = selected();
  return !mesh.empty() && !findObject(m_model.lesson().scene, mesh);
}

void SceneMeshes::removeSelected() {
  const QString refusal = m_model.history().editTogether(
      editsToRemoveMesh(m_model.session().scene, selected()), tr("Remove the mesh"));
  if (!refusal.isEmpty())
    m_messages.complain(refusal);
}

} // namespace halfspace
