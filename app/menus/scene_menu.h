// Scene: what is in it, typed or made of what is there.
#pragma once

#include <QMenu>

namespace halfspace {

class FieldPresenter;
class GoOnInExplore;
class ObjectHand;
class SceneMeshes;
class SessionModel;

class SceneMenu : public QMenu {
  Q_OBJECT
public:
  /// All must outlive it.
  SceneMenu(SessionModel &model, GoOnInExplore &goOn, FieldPresenter &field, ObjectHand &hand,
            SceneMeshes &meshes, QWidget *parent);

  /// The tools by which objects are added.
  [[nodiscard]] QMenu &tools() { return *m_add; }

private:
  /// A tool for each sort of object, while Explore is open.
  void addTools(ObjectHand &hand);
  /// Lines of what has no place in the picture where it could be clicked, to be changed and entered.
  void addLines(FieldPresenter &field);

  SessionModel &m_model;
  QMenu *m_add = nullptr;
  QAction *m_goOn; ///< with a lesson's scene in Explore
};

} // namespace halfspace
