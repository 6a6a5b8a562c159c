// A window on a lesson, drawn and ready for real mouse and key events.
#pragma once

#include "app/main_window.h"
#include "app/settings.h"
#include "app/work/progress_file.h"
#include "app/work/recovery.h"
#include "lessons/lesson/lesson_start.h"
#include "tests/widgets/handle_position.h"
#include "widgets/lesson/prediction_box.h"
#include "widgets/numbers/number_card.h"
#include "widgets/numbers/number_field.h"
#include "widgets/view/scene_view.h"
#include "widgets/working/working_practice.h"

#include <QDir>
#include <QMenu>
#include <QStandardPaths>
#include <QTest>
#include <QToolButton>

#include <algorithm>

namespace halfspace {

/// Removes what windows have kept for the next start: settings, progress, unsaved work.
inline void forgetStarts() {
  QFile::remove(settingsFile());
  QFile::remove(progressFile());
  QFile::remove(Recovery::standardFolder()); // where a test has put a file in its place
  QDir(Recovery::standardFolder()).removeRecursively();
}

class WindowFixture {
public:
  explicit WindowFixture(const std::string &lesson, LessonLibrary library = readLessons(TEST_LESSONS_FOLDER))
      : WindowFixture(startOf(*library.find(lesson)), std::move(library)) {}
  WindowFixture(Session session, LessonLibrary &&library)
      : window(std::move(library), std::move(session), readSettings(settingsFile())) {
    window.sceneView().setMotion(false);
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

  NumberCard &card() { return *window.findChild<NumberCard *>(); }
  /// The field of a coordinate in the card, after its object is selected.
  NumberField *field(const std::string &name, int axis) {
    if (!card().given().field(name, axis))
      scene().handles().select(name);
    return card().given().field(name, axis);
  }
  WorkingPractice &practice() { return *window.findChild<WorkingPractice *>(); }
  /// The worked lines of the step; all in one block here.
  WorkingBlock &lines() { return *practice().working().blocks().front(); }
  /// Goes to the first step that shows a line and asks no question.
  void goToLine(const std::string &id) {
    const auto &steps = model().lesson().steps;
    const auto shows = [&](const LessonStep &step) {
      return !predictionOf(step) &&
             std::any_of(step.blocks.begin(), step.blocks.end(), [&](const StepBlock &block) {
               const auto *lines = std::get_if<StepLines>(&block);
               return lines && std::find(lines->ids.begin(), lines->ids.end(), id) != lines->ids.end();
             });
    };
    model().setStep(static_cast<int>(std::find_if(steps.begin(), steps.end(), shows) - steps.begin()));
  }
  /// Chooses how much of the lines is blank.
  void chooseFading(const QString &text) {
    for (QAction *choice : practice().findChild<QToolButton *>("fading")->menu()->actions())
      if (choice->text() == text)
        choice->trigger();
  }
  /// Clicks an answer of the step's question.
  void answer(int choice) {
    QTest::mouseClick(window.findChild<PredictionBox *>()->choices()[choice], Qt::LeftButton);
  }
  bool questionIsOpen() const { return window.findChild<PredictionBox *>()->choices().first()->isEnabled(); }
  /// The menus' action with this key.
  QAction *action(const QKeySequence &key) {
    for (QAction *each : window.findChildren<QAction *>())
      if (each->shortcut() == key)
        return each;
    return nullptr;
  }

  /// The last construction's case.
  std::string caseName() { return model().evaluation().lastConstruction()->outcome->told->name; }

  QPoint pixelOf(const Place &place) {
    const double ratio = scene().devicePixelRatioF();
    const auto projected = scene().viewpoint().camera().project(place, scene().screen().size());
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
