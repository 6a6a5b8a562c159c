// A learner's own meshes: opened, put into the scene, copied and removed.
#pragma once

#include "app/panels/messages.h"
#include "app/work/mesh_opener.h"

namespace halfspace {

class FlightPlayer;
class SceneView;
class SessionModel;

/// Edits the scene's meshes; on failure says why and leaves the scene as it is.
class SceneMeshes : public QObject {
  Q_OBJECT
public:
  /// A mesh that is read waits while something is dragged, but not for a flight. All must outlive it.
  SceneMeshes(SessionModel &model, SceneView &scene, const FlightPlayer &player, Messages messages);

  /// Reads a mesh beside the window and puts it into the scene, of the lesson that is open or of one that has
  /// use for it.
  void open(const QString &file) { m_opener.open(file); }
  void askAndOpen();
  /// Gives up a mesh that is still being read.
  void leave() { m_opener.leave(); }

  /// Whether another mesh like the one whose handle is selected can stand beside it.
  [[nodiscard]] bool canCopySelected() const;
  void copySelected();
  /// Those that the lesson begins with stay: its words speak of them.
  [[nodiscard]] bool canRemoveSelected() const;
  void removeSelected();

private:
  void take(const LoadedMesh &mesh);
  /// The first lesson that has use for a mesh.
  void openLessonWithMeshes();
  /// The name of the mesh whose handle is selected; empty for none.
  [[nodiscard]] std::string selected() const;

  SessionModel &m_model;
  SceneView &m_scene;
  Messages m_messages;
  MeshOpener m_opener;
};

} // namespace halfspace
