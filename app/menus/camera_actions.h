// From where the scene is looked at.
#pragma once

#include <QObject>

#include <vector>

class QAction;
class QActionGroup;
class QMenu;

namespace halfspace {

class SessionModel;
class Viewpoint;
enum class NamedView;

/// The actions that turn and move the camera. Those that need a plane or a ray are disabled where the step
/// shows none.
class CameraActions : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  CameraActions(const SessionModel &model, Viewpoint &viewpoint, QObject *parent = nullptr);

  void addTo(QMenu &menu) const;
  [[nodiscard]] QAction &fit() { return *m_fit; }
  [[nodiscard]] QAction &home() { return *m_home; }
  [[nodiscard]] QAction &alongPlane() { return *m_alongPlane; }

private:
  QAction *add(const QString &text, const char *key, NamedView view);
  QAction *add(const QString &text, const char *key);
  void addPrevious();
  void addAxisViews();
  void addPlaneViews();
  void addCourses();
  void addOrthographic();
  void enable();

  const SessionModel &m_model;
  Viewpoint &m_viewpoint;
  QAction *m_fit = nullptr;
  QAction *m_home = nullptr;
  QAction *m_alongPlane = nullptr;
  QActionGroup *m_planeViews;
  QActionGroup *m_alongCourse;
  std::vector<QAction *> m_all; ///< in the order of the menu
};

} // namespace halfspace
