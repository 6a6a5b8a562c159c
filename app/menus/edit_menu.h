// Edit: the history, a fresh start, corners, meshes, and what is snapped to.
#pragma once

#include <QMenu>

namespace halfspace {

class FreshStart;
class SceneMeshes;
class SceneHandles;
class SceneView;
class SessionHistory;
class SessionModel;
struct Snapping;

class EditMenu : public QMenu {
  Q_OBJECT
public:
  /// All must outlive it.
  EditMenu(SessionModel &model, SceneView &scene, SceneMeshes &meshes, FreshStart &freshStart,
           QWidget *parent);

private:
  void addHistory(SessionHistory &history);
  /// For a selected corner of a polygon or a prism.
  void addCornerItems(SceneView &scene);
  /// For a selected mesh.
  void addMeshItems(SceneMeshes &meshes, const SceneHandles &handles);
  void addSnapMenu(Snapping &snapping);
};

} // namespace halfspace
