// Scene: what is in it, typed or made of what is there.
#pragma once

#include <QMenu>

namespace halfspace {

class FieldPresenter;
class SessionModel;

class SceneMenu : public QMenu {
  Q_OBJECT
public:
  /// All must outlive it.
  SceneMenu(SessionModel &model, FieldPresenter &field, QWidget *parent);

private:
  SessionModel &m_model;
  QAction *m_goOn; ///< with a lesson's scene in Explore
};

} // namespace halfspace
