// From a move of the mouse to the drawn frame, in the real window, for every lesson and for scenes of
// Explore: each move is also drawn by bare VTK, one after the other, so that what else the machine does slows
// both alike. Takes the number of moves and, if only one is wanted, a lesson, or `explore-100` for a scene of
// so many entries.
#include "lessons/lesson/explore.h"
#include "lessons/typed/typed_scene.h"
#include "tests/app/window_fixture.h"
#include "tests/bench/bare_window.h"
#include "tests/bench/figure_to_bare.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"
#include "widgets/working/working_block.h"

#include <QApplication>

#include <array>
#include <cmath>
#include <cstdio>

using namespace halfspace;
using namespace halfspace::bench;

namespace {

constexpr int usualMoves = 300;
constexpr int burstMoves = 100;
constexpr int movesPerBurst = 10;
constexpr int patience = 10000; // milliseconds
constexpr double offPath = 60;  ///< how far the drag wanders off its straight way, in pixels

/// The scenes of Explore have so many entries.
constexpr std::array exploreSizes{10, 100, 500};

constexpr double shareGoal = 1;    ///< milliseconds
constexpr double frameGoal = 1.10; ///< times bare VTK

/// Tells how long painting takes: of the lines, and of the window with all that is in it.
class TimedApplication : public QApplication {
public:
  using QApplication::QApplication;

  bool notify(QObject *receiver, QEvent *event) override {
    Durations *durations = durationsFor(receiver, *event);
    if (!durations)
      return QApplication::notify(receiver, event);
    const auto start = Clock::now();
    const bool accepted = QApplication::notify(receiver, event);
    durations->add(millisecondsSince(start));
    return accepted;
  }

  QWidget *window = nullptr; ///< whose painting is measured
  QWidget *lines = nullptr;  ///< likewise
  Durations paint;
  Durations linesPainted;

private:
  Durations *durationsFor(QObject *receiver, const QEvent &event) {
    if (event.type() == QEvent::UpdateRequest && receiver == window)
      return &paint;
    return event.type() == QEvent::Paint && receiver == lines ? &linesPainted : nullptr;
  }
};

/// Everything measured of one lesson.
struct Measured {
  Durations evaluate, panels, linesLaidOut, update, render, share, frame, fromMove, bare, ratio, linesPainted,
      paint;
  int moves = 0;
  int frames = 0;
  int renders = 0;
  bool isKept = false; ///< whether the handle ended where the pointer did
};

/// A scene of Explore: a point to be dragged, and planes, points and distances, of which each third looks at
/// it.
Session exploreSession(int entries) {
  std::string lines = "Q = (3, 2, 4)\n";
  for (int i = 1; i < entries; ++i) {
    const std::string number = std::to_string(i);
    const std::string place = std::to_string(i * 7 % 11) + ", " + std::to_string(i * 5 % 13) + ", ";
    if (i % 3 == 1)
      lines += "A" + number + " = (" + place + std::to_string(i % 7) + ")\n";
    else if (i % 3 == 2)
      lines += "M" + number + " = (Q + A" + std::to_string(i - 1) + ")/2\n";
    else
      lines += "g" + number + " = line(A" + std::to_string(i - 2) + ", M" + std::to_string(i - 1) + ")\n";
  }
  return {exploreId, 0, *readTypedScene(lines, "")};
}

/// One drag of the first handle of a session that can be grabbed.
class Drag {
public:
  Drag(Session session, LessonLibrary library, TimedApplication &application)
      : m_application(application), m_fixture(std::move(session), std::move(library)),
        m_set(labelSetter(m_typesetter.fonts())), m_paint(labelPainter(m_typesetter)) {
    showMost();
    waitForQuiet();
    m_bare = std::make_unique<BareWindow>(view());
    m_handle = firstHandle();
    QObject::connect(&view().drawing(), &SceneDrawing::frameDrawn, &view(),
                     [this](const FrameTimes &times) { take(times); });
    countRenders(view(), m_measured.renders);
    m_lines = &m_fixture.lines();
    m_application.window = &m_fixture.window;
    m_application.lines = m_lines;
  }

  Measured run(int moves) {
    const QPointF from = m_fixture.pixelOf(shownPlace(m_handle));
    const ExactVec3 wanted = m_handle.at + wayOf();
    const QPointF to = from + m_fixture.pixelOf(shownPlace(m_handle) + toDouble(wayOf())) - from;
    m_fixture.press(from.toPoint());
    waitForQuiet();
    // Warm up, then count.
    m_fixture.model().snapping().step = Rational(1, 100);
    for (int i = 0; i < moves / 10; ++i)
      moveAndDraw(pathAt(from, to, i / (moves / 10.0)));
    m_measured = {};
    m_application.linesPainted = m_application.paint = {};
    for (int i = 0; i < moves; ++i)
      moveAndDraw(pathAt(from, to, double(i) / moves));
    m_measured.linesPainted = m_application.linesPainted;
    m_measured.paint = m_application.paint;
    burst(from, to);
    m_fixture.model().snapping().step = 1;
    move(to);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to.toPoint());
    waitForQuiet();
    const Scene &scene = m_fixture.model().session().scene;
    for (const Handle &handle : handlesOf(scene))
      if (handle.id == m_handle.id)
        m_measured.isKept = handle.at == wanted;
    measureLayout(moves);
    return std::move(m_measured);
  }

  SceneView &view() { return m_fixture.scene(); }
  [[nodiscard]] const std::string &handleId() const { return m_handle.id; }

private:
  /// Goes to the step that shows most.
  void showMost() {
    SessionModel &model = m_fixture.model();
    std::pair<std::size_t, int> most;
    for (int step = 0; step < static_cast<int>(model.lesson().steps.size()); ++step) {
      model.setStep(step);
      most = std::max(most, {model.shown().figure.marks.size(), step});
    }
    model.setStep(most.second);
  }

  Handle firstHandle() {
    for (const Handle &handle : handlesOf(m_fixture.model().session().scene))
      if (handle.motion == Handle::Motion::Coordinate && handlePosition(view(), handle.id))
        return handle;
    return {};
  }

  static ExactVec3 wayOf() { return {2, -1, 0}; }

  static QPointF pathAt(QPointF from, QPointF to, double part) {
    const double angle = 2 * std::acos(-1.0) * part;
    return from + (to - from) * part + QPointF(offPath * std::sin(3 * angle), offPath * std::sin(2 * angle));
  }

  static void waitForQuiet() { QTest::qWait(300); }

  void take(const FrameTimes &times) {
    const auto drawn = Clock::now();
    finishDrawing();
    ++m_measured.frames;
    if (!m_isTimed)
      return;
    m_isTimed = false;
    const double evaluate = milliseconds(times.evaluate);
    const double panels = milliseconds(times.panels);
    const double update = milliseconds(times.update);
    const double render = milliseconds(times.render) + millisecondsSince(drawn);
    m_measured.evaluate.add(evaluate);
    m_measured.panels.add(panels);
    m_measured.update.add(update);
    m_measured.render.add(render);
    m_measured.share.add(evaluate + panels + update);
    m_measured.frame.add(evaluate + panels + update + render);
    m_measured.fromMove.add(millisecondsSince(m_moved));
  }

  void move(QPointF to) {
    ++m_measured.moves;
    QMouseEvent event(QEvent::MouseMove, to, view().mapTo(&m_fixture.window, to.toPoint()),
                      view().mapToGlobal(to.toPoint()), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&view(), &event);
  }

  void moveAndDraw(QPointF to) {
    view().makeCurrent();
    const std::size_t shownBefore = m_application.paint.all.size();
    m_isTimed = true;
    m_moved = Clock::now();
    move(to);
    while (m_isTimed && millisecondsSince(m_moved) < patience)
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
    while (m_application.paint.all.size() == shownBefore && millisecondsSince(m_moved) < patience)
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
    const BarePicture picture =
        bareOf(content(), themes().front(), {view().viewpoint().camera(), view().screen().size(), 1}, m_set,
               m_paint);
    m_measured.bare.add(m_bare->draw(picture));
    if (!m_measured.frame.all.empty())
      m_measured.ratio.add(m_measured.frame.all.back() / m_measured.bare.all.back());
  }

  /// What the view shows of the scene now, with the tools of the handle that is dragged.
  SceneContent content() {
    SceneContent content = view().drawn().pictureContent();
    for (const Handle &handle : handlesOf(m_fixture.model().session().scene)) {
      if (handle.id == m_handle.id) {
        content.gizmo = Gizmo{shownPlace(handle), Gizmo::Mode::Horizontal, true, {}, {}, {}, {}, {}};
        content.dropLine = DropLine{toDouble(handle.at)};
      }
      if (const auto knob = knobOf(handle, false))
        content.knobs.push_back(*knob);
    }
    return content;
  }

  /// More moves than frames.
  void burst(QPointF from, QPointF to) {
    for (int i = 0; i < burstMoves; ++i) {
      move(pathAt(from, to, double(i) / burstMoves));
      if (i % movesPerBurst == 0)
        QCoreApplication::processEvents();
    }
  }

  /// New lines every time, as in a drag.
  void measureLayout(int moves) {
    for (int move = 1; move <= moves; ++move) {
      const Working working = workingOf(evaluate(sceneMoved(Rational(move, 100))));
      const auto start = Clock::now();
      m_lines->setWorking(working);
      m_measured.linesLaidOut.add(millisecondsSince(start));
    }
  }

  /// The scene with the handle a little off.
  Scene sceneMoved(const Rational &shift) {
    const Session &session = m_fixture.model().session();
    const Object &object = *findObject(session.scene, m_handle.object);
    const Edit move =
        ChangeObject{m_handle.object, movedTo(object, m_handle, m_handle.at + ExactVec3(shift, 0, 0))};
    return *apply(session.scene, move);
  }

  TimedApplication &m_application;
  WindowFixture m_fixture;
  WorkingBlock *m_lines = nullptr;
  Typesetter m_typesetter;
  LabelSetter m_set;
  LabelPainter m_paint;
  std::unique_ptr<BareWindow> m_bare;
  Handle m_handle;
  Measured m_measured;
  bool m_isTimed = false; ///< whether the next frame is measured
  Clock::time_point m_moved;
};

void print(const char *what, const Durations &durations) {
  std::printf("  %-52s %8.2f %8.2f\n", what, durations.median(), durations.quantile(0.95));
}

void print(const Measured &measured) {
  std::printf("  %-52s %8s %8s\n", "milliseconds", "median", "95 %");
  print("evaluate", measured.evaluate);
  print("panels: lines, numbers and words laid out", measured.panels);
  print("of these the lines", measured.linesLaidOut);
  print("update of the scene", measured.update);
  print("our share: evaluate, panels and update", measured.share);
  print("render", measured.render);
  print("whole frame", measured.frame);
  print("bare VTK, whole frame", measured.bare);
  print("whole frame / bare VTK, move by move", measured.ratio);
  print("from the mouse's move to the drawn frame", measured.fromMove);
  print("painting and putting together of the window", measured.paint);
  print("of these painting of the lines", measured.linesPainted);
  std::printf("  %d moves, %d frames, %d renders\n", measured.moves, measured.frames, measured.renders);
}

void printGoal(const std::string &goal, double figure, bool isMet) {
  std::printf("  %-60s %8.2f  %s\n", goal.c_str(), figure, isMet ? "met" : "missed");
}

void printGoals(const Measured &measured) {
  const double ratio = measured.frame.median() / measured.bare.median();
  printGoal("our share at most 1 ms (median)", measured.share.median(), measured.share.median() <= shareGoal);
  printGoal("whole frame at most 1.10 x bare VTK (medians)", ratio, ratio <= frameGoal);
  printGoal("drags whose end was lost: 0", measured.isKept ? 0 : 1, measured.isKept);
  printGoal("frames a move: at most 1", double(measured.frames) / measured.moves,
            measured.frames <= measured.moves);
  printGoal("renders a frame: 1", double(measured.renders) / measured.frames,
            measured.renders == measured.frames);
}

} // namespace

int main(int argc, char **argv) {
  QStandardPaths::setTestModeEnabled(true);
  QSurfaceFormat::setDefaultFormat(SceneView::surfaceFormat());
  TimedApplication application(argc, argv);
  const int moves = argc > 1 ? std::max(10, std::atoi(argv[1])) : usualMoves;
  const LessonLibrary library = readLessons(TEST_LESSONS_FOLDER);
  std::vector<std::pair<std::string, Session>> sessions;
  for (const Lesson &lesson : library.lessons)
    sessions.emplace_back(lesson.id, startOf(lesson));
  for (const int entries : exploreSizes)
    sessions.emplace_back("explore-" + std::to_string(entries), exploreSession(entries));
  for (const auto &[name, session] : sessions) {
    if (argc > 2 && name != argv[2])
      continue;
    Drag drag(session, library, application);
    const Measured measured = drag.run(moves);
    std::printf("\n%s, dragging %s, view of %d x %d pixels\n", name.c_str(), drag.handleId().c_str(),
                drag.view().screen().size().width, drag.view().screen().size().height);
    print(measured);
    printGoals(measured);
    std::fflush(stdout);
    application.window = application.lines = nullptr;
  }
}
