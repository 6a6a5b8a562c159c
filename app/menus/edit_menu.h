// Edit: the history, a fresh start, what goes to the clipboard and comes from there, corners, meshes, and
// what is snapped to.
#pragma once

#include <QMenu>

namespace halfspace {

class FigureExport;
class FreshStart;
class ScenePaste;
class SceneMeshes;
class SceneHandles;
class SceneView;
class SessionHistory;
class SessionModel;
class WorkingCopy;
struct Snapping;

class EditMenu : public QMenu {
  Q_OBJECT
public:
  /// All must outlive it.
  EditMenu(SessionModel &model, SceneView &scene, SceneMeshes &meshes, FreshStart &freshStart,
           const WorkingCopy &working, FigureExport &figures, ScenePaste &paste, QWidget *parent);

private:
  void addHistory(SessionHistory &history);
  void addCopyMenu(const WorkingCopy &working);
  /// For a selected corner of a polygon or a prism.
  void addCornerItems(SceneView &scene);
  /// For a selected mesh.
  void addMeshItems(SceneMeshes &meshes, const SceneHandles &handles);
  void addSnapMenu(Snapping &snapping);
};

} // namespace halfspace
