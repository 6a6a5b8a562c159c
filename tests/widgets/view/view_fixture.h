// The 3D view alone in a window, drawn and ready for real mouse and key events.
#pragma once

#include "lessons/lesson/lesson_start.h"
#include "tests/lessons/scenes.h"
#include "tests/widgets/handle_position.h"
#include "tests/widgets/libraries.h"
#include "tests/widgets/pointer.h"
#include "widgets/typeset/typesetter.h"
#include "widgets/view/scene_view.h"

#include <QLineEdit>
#include <QVBoxLayout>

namespace halfspace::test {

class ViewFixture {
public:
  explicit ViewFixture(const Scene &scene = distanceScene())
      : ViewFixture(libraryOf({scene, Scene{{pointQ()}}})) {}
  explicit ViewFixture(const LessonLibrary &library)
      : ViewFixture(library, startOf(library.lessons.front())) {}
  ViewFixture(LessonLibrary library, Session session)
      : model(std::move(library), std::move(session)), view(model, m_typesetter) {
    auto *layout = new QVBoxLayout(&window);
    layout->addWidget(&view);
    layout->addWidget(&other);
    window.resize(900, 700);
    view.setMotion(false);
    window.show();
    ready = QTest::qWaitForWindowExposed(&window) && QTest::qWaitFor([this] { return view.isValid(); });
    view.setFocus();
  }
  ~ViewFixture() { view.setParent(nullptr); }
  ViewFixture(const ViewFixture &) = delete;
  ViewFixture &operator=(const ViewFixture &) = delete;

  ExactVec3 value(const std::string &object, std::size_t index = 0) {
    return coordinate(*findObject(model.session().scene, object), index);
  }
  QPoint at(const std::string &handle) { return handlePosition(view, handle).value_or(QPoint(-1, -1)); }
  void press(QPoint place, Qt::MouseButton button = Qt::LeftButton,
             Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::mousePress(&view, button, modifiers, place);
  }
  void release(QPoint place, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mouseRelease(&view, button, {}, place);
  }
  /// Presses beside everything, moves, and releases.
  void dragBeside(QPoint way, Qt::MouseButton button = Qt::LeftButton,
                  Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const QPoint from(6, 6);
    press(from, button, modifiers);
    movePointer(view, from + way, button, modifiers);
    release(from + way, button);
  }

private:
  Typesetter m_typesetter;

public:
  SessionModel model;
  QWidget window;
  QLineEdit other;
  SceneView view;
  bool ready = false;
};

} // namespace halfspace::test
