#include "app/menus/camera_actions.h"

#include "widgets/session_model.h"
#include "widgets/view/viewpoint.h"

#include <QActionGroup>
#include <QMenu>

namespace halfspace {

CameraActions::CameraActions(const SessionModel &model, Viewpoint &viewpoint, QObject *parent)
    : QObject(parent), m_model(model), m_viewpoint(viewpoint), m_planeViews(new QActionGroup(this)),
      m_alongCourse(new QActionGroup(this)) {
  m_fit = add(tr("&Fit"), "F", NamedView::Fit);
  m_home = add(tr("&Home"), "H", NamedView::Home);
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

QAction *CameraActions::add(const QString &text, const char *key, NamedView view) {
  QAction *action = add(text, key);
  connect(action, &QAction::triggered, &m_viewpoint, [this, view] { m_viewpoint.show(view); });
  return action;
}

void CameraActions::addPrevious() {
  QAction *previous = add(tr("Pre&vious View"), "V");
  previous->setObjectName("previousView");
  connect(previous, &QAction::triggered, &m_viewpoint, &Viewpoint::showPrevious);
  const auto enablePrevious = [this, previous] { previous->setEnabled(!m_viewpoint.previous().isEmpty()); };
  connect(&m_viewpoint.previous(), &PreviousViews::changed, this, enablePrevious);
  enablePrevious();
}

void CameraActions::addAxisViews() {
  add(tr("From the &Front (x)"), "1", NamedView::Front);
  add(tr("From the &Right (y)"), "2", NamedView::Right);
  add(tr("From the &Top (z)"), "3", NamedView::Top);
}

void CameraActions::addPlaneViews() {
  m_alongPlane = add(tr("Along the &Plane"), "4", NamedView::AlongPlane);
  QAction *face = add(tr("Fa&ce the Plane"), "7", NamedView::FacingPlane);
  face->setObjectName("facePlane");
  m_planeViews->addAction(m_alongPlane);
  m_planeViews->addAction(face);
}

void CameraActions::addCourses() {
  const auto addCourse = [this](const QString &text, const char *key, const char *name, NamedView view) {
    QAction *action = add(text, key, view);
    action->setObjectName(name);
    m_alongCourse->addAction(action);
  };
  addCourse(tr("&Down the Ray or Line"), "5", "downCourse", NamedView::DownCourse);
  addCourse(tr("&Against the Ray or Line"), "8", "againstCourse", NamedView::AgainstCourse);
}

void CameraActions::addOrthographic() {
  QAction *orthographic = add(tr("&Orthographic"), "O");
  orthographic->setCheckable(true);
  orthographic->setChecked(m_viewpoint.camera().orthographic);
  connect(orthographic, &QAction::triggered, &m_viewpoint, &Viewpoint::setOrthographic);
  connect(&m_viewpoint, &Viewpoint::orthographicChanged, orthographic, &QAction::setChecked);
}

void CameraActions::enable() {
  m_planeViews->setEnabled(showsPlane(m_model.figure()));
  m_alongCourse->setEnabled(firstCourse(m_model.shown().figure).has_value());
}

} // namespace halfspace
