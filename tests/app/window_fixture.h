// A window on a lesson, drawn and ready for real mouse and key events.
#pragma once

#include "app/main_window.h"
#include "widgets/view/scene_view.h"

#include <QStandardPaths>
#include <QTest>

namespace halfspace {

class WindowFixture {
public:
  explicit WindowFixture(const std::string &lesson) : window(readLessons(TEST_LESSONS_FOLDER)) {
    window.sceneView().setMotion(false);
    window.model().openLesson(lesson);
    window.model().startWith(window.model().session());
    window.show();
    ready = QTest::qWaitForWindowExposed(&window) && QTest::qWaitFor([&] { return scene().isValid(); });
    scene().setFocus();
  }

  SceneView &scene() { return window.sceneView(); }
  SessionModel &model() { return window.model(); }

  /// The exact value of a coordinate, by its full or short name.
  ExactVec3 value(const std::string &name) {
    const auto id = findCoordinate(model().session().scene, name);
    return id ? coordinate(*findObject(model().session().scene, id->object), id->index) : ExactVec3(-999);
  }

  /// The last construction's case.
  std::string caseName() { return model().evaluation().lastConstruction()->outcome->told->name; }

  QPoint pixelOf(const Place &place) {
    const double ratio = scene().devicePixelRatioF();
    const auto projected = scene().camera().project(place, scene().pixelSize());
    return projected ? QPoint(qRound(projected->x / ratio), qRound(projected->y / ratio)) : QPoint(-1, -1);
  }

  /// Moves the pointer with the left button down, in a few steps as a hand does.
  void moveTo(const QPoint &to, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const QPoint from = m_pointer;
    for (int step = 1; step <= 5; ++step) {
      const QPoint at = from + (to - from) * step / 5;
      QMouseEvent move(QEvent::MouseMove, at, scene().mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                       modifiers);
      QCoreApplication::sendEvent(&scene(), &move);
      QTest::qWait(5);
    }
    m_pointer = to;
  }
  void press(const QPoint &at, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    m_pointer = at;
    QTest::mousePress(&scene(), Qt::LeftButton, modifiers, at);
  }
  void release(Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::mouseRelease(&scene(), Qt::LeftButton, modifiers, m_pointer);
  }
  void drag(const QPoint &from, const QPoint &to) {
    press(from);
    moveTo(to);
    release();
  }

  MainWindow window;
  bool ready = false;

private:
  QPoint m_pointer;
};

} // namespace halfspace
