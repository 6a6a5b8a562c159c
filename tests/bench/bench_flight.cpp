// The torpedo's flight in the real window, over a field with a mesh of 10^5 triangles: each frame of it is
// also drawn by bare VTK, one after the other, so that what else the machine does slows both alike. Then the
// flight alone: how often it is drawn, and whether it keeps to the clock. And before: for how long the window
// stands still while the mesh is opened.
#include "lessons/construction/parts/shots.h"
#include "lessons/scene/target_mesh.h"
#include "tests/app/window_fixture.h"
#include "tests/bench/bare_window.h"
#include "tests/bench/bumpy_ball.h"
#include "tests/bench/figure_to_bare.h"
#include "tests/bench/heartbeat.h"
#include "tests/bench/stopwatch.h"
#include "widgets/flight/flight_bar.h"
#include "widgets/flight/flight_player.h"
#include "widgets/mesh_loader.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <QApplication>
#include <QScreen>
#include <QTemporaryDir>

#include <cmath>
#include <cstdio>
#include <thread>

using namespace halfspace;
using namespace halfspace::bench;

namespace {

constexpr std::size_t meshTriangles = 100'000;
constexpr int stepToMove = 6; ///< of the lesson: the whole field is shown, and there is no question
constexpr int usualFrames = 200;
constexpr int warmUp = 20;      ///< frames that are not counted
constexpr int patience = 30000; // milliseconds
constexpr double slow = 0.25;   ///< of the flight's usual speed, so that it lasts
constexpr double frameGoal = 1.15;
constexpr double refreshGoal = 1.05; ///< times the display's own rate
constexpr double leastRefreshes = 0.95;
constexpr double clockGoal = 0.05; ///< of what is flown, off what the clock says
constexpr int untilStill = 500;    ///< milliseconds

/// Tells how long a tick of the flight's clock takes: the scene is evaluated, and the panels are told.
class TimedApplication : public QApplication {
public:
  using QApplication::QApplication;

  bool notify(QObject *receiver, QEvent *event) override {
    if (event->type() != QEvent::Timer || !qobject_cast<FlightPlayer *>(receiver->parent()))
      return QApplication::notify(receiver, event);
    const auto start = Clock::now();
    const bool accepted = QApplication::notify(receiver, event);
    tick = millisecondsSince(start);
    ++ticks;
    return accepted;
  }

  double tick = 0; ///< the last one's duration
  int ticks = 0;
};

/// The times of many frames, in milliseconds.
class Frames {
public:
  void add(double tick, double update, double render, double bare) {
    m_tick.add(tick);
    m_update.add(update);
    m_render.add(render);
    m_whole.add(tick + update + render);
    m_bare.add(bare);
  }

  void print(const std::string &when) const {
    const auto line = [](const char *what, const Durations &durations) {
      std::printf("  %-52s %8.2f %8.2f\n", what, durations.median(), durations.quantile(0.95));
    };
    std::printf("  %-52s %8s %8s\n", (when + ", milliseconds").c_str(), "median", "95 %");
    line("tick: the scene evaluated, the panels told", m_tick);
    line("update of the scene", m_update);
    line("render", m_render);
    line("whole frame", m_whole);
    line("bare VTK, whole frame", m_bare);
    printGoal(when + ": whole frame / bare VTK (medians)", m_whole.median() / m_bare.median(), frameGoal);
  }

private:
  Durations m_tick, m_update, m_render, m_whole, m_bare;
};

class Flight {
public:
  explicit Flight(TimedApplication &application)
      : m_application(application), m_fixture("photon-torpedo"), m_set(labelSetter(m_typesetter.fonts())),
        m_paint(labelPainter(m_typesetter)) {
    m_fixture.model().setStep(stepToMove);
    openMesh();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the bar of the step before
    m_bar = m_fixture.window.findChild<FlightBar *>();
    m_bare = std::make_unique<BareWindow>(view());
    QObject::connect(&view().drawing(), &SceneDrawing::frameDrawn, &view(),
                     [this](const FrameTimes &times) { take(times); });
    countRenders(view(), m_renders);
  }

  [[nodiscard]] bool isReady() const { return m_hasMesh && m_bar; }

  /// Each frame beside bare VTK's of the same moment.
  void fly(int frames) {
    play();
    for (int i = -warmUp; i < frames; ++i) {
      if (!m_bar->state().isPlaying)
        play();
      const int before = m_frames;
      const auto start = Clock::now();
      while (m_frames == before && millisecondsSince(start) < patience)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
      quiet();
      const BarePicture picture =
          bareOf(view().drawn().pictureContent(), themes().front(),
                 {view().viewpoint().camera(), view().screen().size(), 1}, m_set, m_paint);
      const double bare = m_bare->draw(picture);
      quiet();
      if (i < 0)
        continue;
      (hasExploded() ? m_explosion : m_flight).add(m_application.tick, m_lastUpdate, m_lastRender, bare);
    }
    emit m_bar->playToggled(false);
    std::printf("\na flight over %zu triangles, view of %d x %d pixels\n", meshTriangles,
                view().screen().size().width, view().screen().size().height);
    m_flight.print("on its way");
    m_explosion.print("explosion");
  }

  /// As fast as it goes, for a few seconds.
  void flyAlone() {
    constexpr int seconds = 3;
    emit m_bar->fire(); // from its start: it must not end meanwhile
    const double from = frameNumber();
    m_frames = m_renders = m_application.ticks = 0;
    const auto start = Clock::now();
    QTest::qWait(seconds * 1000);
    const double passed = millisecondsSince(start) * 1e-3;
    const double flown = frameNumber() - from;
    const double refreshes = QApplication::primaryScreen()->refreshRate() * passed;
    emit m_bar->playToggled(false);
    std::printf(
        "\nalone, %.1f s at %.2f of the usual speed: %d ticks, %d frames, %d renders, %.0f refreshes\n",
        passed, slow, m_application.ticks, m_frames, m_renders, refreshes);
    const double byClock = passed * slow * framesPerSecond;
    std::printf("  frames of the flight, by the clock %.1f, in the scene %.1f\n", byClock, flown);
    printGoal("part of the flight that is off the clock", std::abs(flown / byClock - 1), clockGoal);
    printGoal("renders a refresh of the display", m_renders / refreshes, refreshGoal);
    printLeast("renders a refresh of the display", m_renders / refreshes, leastRefreshes);
    printGoal("renders a frame", double(m_renders) / m_frames, 1);
  }

private:
  SceneView &view() { return m_fixture.scene(); }
  bool hasExploded() {
    return m_fixture.model().evaluation().find("flight")->outcome->told->name == "exploded";
  }
  double frameNumber() { return toDouble(m_fixture.value("frame").x); }

  void openMesh() {
    const QString path = m_folder.filePath("ball.stl");
    QFile file(path);
    const std::string stl = bumpyBall(meshTriangles);
    if (!file.open(QIODevice::WriteOnly) || file.write(stl.data(), static_cast<qint64>(stl.size())) < 0)
      return;
    file.close();
    m_fixture.window.findChild<MeshLoader *>()->setProgram(QCoreApplication::applicationDirPath() +
                                                           "/halfspace");
    double update = 0;
    double render = 0;
    const QMetaObject::Connection frames =
        QObject::connect(&view().drawing(), &SceneDrawing::frameDrawn, &view(), [&](const FrameTimes &times) {
          update = std::max(update, milliseconds(times.update));
          render = std::max(render, milliseconds(times.render));
        });
    const Heartbeat heartbeat;
    m_fixture.window.meshes().open(path);
    m_hasMesh = turnUntil(
        [&] { return findObject(m_fixture.model().session().scene, targetName) != nullptr; }, patience);
    turnUntil([] { return false; }, untilStill); // it is drawn
    QObject::disconnect(frames);
    std::printf("\nevent loop's longest pause until a mesh of %zu triangles is drawn: %.1f ms\n",
                meshTriangles, heartbeat.longestPause());
    std::printf("  of a frame at most: update of the scene %.1f, render by VTK and OpenGL %.1f\n", update,
                render);
  }

  /// Lets the event loop turn without pauses of its own, as long as a heart beats; whether it is done in
  /// time.
  template <class IsDone> static bool turnUntil(IsDone isDone, int milliseconds) {
    const auto start = Clock::now();
    while (!isDone() && millisecondsSince(start) < milliseconds)
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    return isDone();
  }

  /// Both windows begin when what is drawn before is on the screen: else one would pay for the other.
  static void quiet() {
    QCoreApplication::sendPostedEvents();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }

  void play() {
    emit m_bar->speedChanged(slow);
    emit m_bar->playToggled(true);
  }

  void take(const FrameTimes &times) {
    const auto drawn = Clock::now();
    finishDrawing();
    ++m_frames;
    m_lastUpdate = milliseconds(times.update);
    m_lastRender = milliseconds(times.render) + millisecondsSince(drawn);
  }

  TimedApplication &m_application;
  WindowFixture m_fixture;
  QTemporaryDir m_folder;
  FlightBar *m_bar = nullptr;
  bool m_hasMesh = false;
  Typesetter m_typesetter;
  LabelSetter m_set;
  LabelPainter m_paint;
  std::unique_ptr<BareWindow> m_bare;
  Frames m_flight, m_explosion;
  int m_frames = 0;
  int m_renders = 0;
  double m_lastUpdate = 0;
  double m_lastRender = 0;
};

} // namespace

int main(int argc, char **argv) {
  QStandardPaths::setTestModeEnabled(true);
  QSurfaceFormat::setDefaultFormat(SceneView::surfaceFormat());
  TimedApplication application(argc, argv);
  forgetStarts();
  Flight flight(application);
  if (!flight.isReady()) {
    std::printf("The mesh could not be opened.\n");
    return 1;
  }
  flight.fly(argc > 1 ? std::max(10, std::atoi(argv[1])) : usualFrames);
  flight.flyAlone();
}
