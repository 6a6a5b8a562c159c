#include "app/menus/camera_actions.h"

#include "widgets/session_model.h"
#include "widgets/view/scene_view.h"

#include <QActionGroup>
#include <QMenu>

namespace halfspace {

CameraActions::CameraActions(const SessionModel &model, SceneView &scene, QObject *parent)
    : QObject(parent), m_model(model), m_scene(scene), m_planeViews(new QActionGroup(this)),
      m_alongCourse(new QActionGroup(this)) {
  m_fit = add(tr("&Fit"), "F", &SceneView::fit);
  m_home = add(tr("&Home"), "H", &SceneView::goHome);
  addPrevious();
  addAxisViews();
  addPlaneViews();
  addCourses();
  addOrthographic();
  connect(&model, &SessionModel::outcomeChanged, this, &CameraActions::enable);
  enable();
}

void CameraActions::addTo(QMenu &menu) const {
  for (QAction *action : m_all)
    menu.addAction(action);
}

QAction *CameraActions::add(const QString &text, const char *key) {
  auto *action = new QAction(text, this);
  action->setShortcut(QKeySequence(key));
  m_all.push_back(action);
  return action;
}

QAction *CameraActions::add(const QString &text, const char *key, void (SceneView::*look)()) {
  QAction *action = add(text, key);
  connect(action, &QAction::triggered, &m_scene, look);
  return action;
}

void CameraActions::addPrevious() {
  QAction *previous = add(tr("Pre&vious View"), "V", &SceneView::showPreviousView);
  previous->setObjectName("previousView");
  const auto enablePrevious = [this, previous] { previous->setEnabled(m_scene.hasPreviousView()); };
  connect(&m_scene, &SceneView::previousViewsChanged, this, enablePrevious);
  enablePrevious();
}

void CameraActions::addAxisViews() {
  const auto addView = [this](const QString &text, const char *key, AxisView view) {
    connect(add(text, key), &QAction::triggered, &m_scene, [this, view] { m_scene.setAxisView(view); });
  };
  addView(tr("From the &Front (x)"), "1", AxisView::Front);
  addView(tr("From the &Right (y)"), "2", AxisView::Right);
  addView(tr("From the &Top (z)"), "3", AxisView::Top);
}

void CameraActions::addPlaneViews() {
  m_alongPlane = add(tr("Along the &Plane"), "4", &SceneView::lookAlongPlane);
  QAction *face = add(tr("Fa&ce the Plane"), "7", &SceneView::facePlane);
  face->setObjectName("facePlane");
  m_planeViews->addAction(m_alongPlane);
  m_planeViews->addAction(face);
}

void CameraActions::addCourses() {
  const auto addCourse = [this](const QString &text, const char *key, const char *name, AlongCourse way) {
    QAction *action = add(text, key);
    connect(action, &QAction::triggered, &m_scene, [this, way] { m_scene.lookAlongCourse(way); });
    action->setObjectName(name);
    m_alongCourse->addAction(action);
  };
  addCourse(tr("&Down the Ray or Line"), "5", "downCourse", AlongCourse::Down);
  addCourse(tr("&Against the Ray or Line"), "8", "againstCourse", AlongCourse::Against);
}

void CameraActions::addOrthographic() {
  QAction *orthographic = add(tr("&Orthographic"), "O");
  orthographic->setCheckable(true);
  connect(orthographic, &QAction::triggered, &m_scene, &SceneView::setOrthographic);
  connect(&m_scene, &SceneView::orthographicChanged, orthographic, &QAction::setChecked);
}

void CameraActions::enable() {
  m_planeViews->setEnabled(showsPlane(m_model.figure()));
  m_alongCourse->setEnabled(firstCourse(m_model.shown().figure).has_value());
}

} // namespace halfspace
