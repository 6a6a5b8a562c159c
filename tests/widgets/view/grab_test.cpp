// What is seen is what is grabbed: every handle of every lesson, pressed all over what is drawn of it, with
// each of the handles selected.
#include "tests/widgets/view/view_fixture.h"
#include "widgets/picture/design_scale.h"
#include "widgets/picture/shapes/gizmo_shape.h"
#include "widgets/picture/shapes/mark_shapes.h"
#include "widgets/picture/shapes/mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <numbers>
#include <numeric>

using namespace halfspace;
using namespace halfspace::test;

namespace {

/// As much of a window of 1280×800 as the scene has.
constexpr QSize viewSize(840, 730);

/// How much of what is drawn is pressed: not its very rim, where a pixel is half of something else.
constexpr double withinRim = 0.75;

/// So few of all places that are pressed may lie under another handle.
constexpr double mostCoveredPart = 0.05;

/// A place of what is drawn of a handle.
struct Spot {
  glm::dvec2 pixel; ///< a whole one, as a mouse presses
  Place at;         ///< in the scene, on the middle line of what is drawn
};

/// What is drawn of a handle, looked up among the marks of the figure; not as the hand itself does it.
class Drawn {
public:
  Drawn(SceneView &view, const Figure &figure, const Handle &handle)
      : m_camera(view.viewpoint().camera()), m_size(view.screen().size()),
        m_scale(designScale(m_camera, m_size, 1)) {
    const Mark *mark = findMark(figure, handle.id);
    if (const auto *point = mark ? std::get_if<PointMark>(mark) : nullptr)
      addBall(point->at, ballRadius(*point) * m_scale / m_camera.unitsPerPixel(point->at, m_size));
    else if (const auto *arrow = mark ? std::get_if<ArrowMark>(mark) : nullptr)
      addHead(*arrow);
    else
      addKnob(handle);
  }

  [[nodiscard]] const std::vector<Spot> &spots() const { return m_spots; }
  /// Whether a pixel lies on it, and its place there is nearer to the eye than another.
  [[nodiscard]] bool covers(const Spot &other) const {
    return std::any_of(m_discs.begin(), m_discs.end(), [&](const Disc &disc) {
      const double aside = glm::distance(disc.center.pixel, other.pixel);
      const double nearer = glm::dot(other.at - disc.center.at, m_camera.viewDirection());
      return aside <= disc.radius && nearer > -std::sqrt(disc.radius * disc.radius - aside * aside) *
                                                  m_camera.unitsPerPixel(disc.center.at, m_size);
    });
  }

private:
  struct Disc {
    Spot center;
    double radius;
  };

  [[nodiscard]] Spot spotAt(Place at) const {
    return {glm::round(glm::dvec2(m_camera.project(at, m_size).value())), at};
  }
  [[nodiscard]] static Spot beside(const Spot &spot, glm::dvec2 way) {
    return {glm::round(spot.pixel + way), spot.at};
  }
  void addAround(const Spot &center, double radius) {
    m_discs.push_back({center, radius});
    for (int i = 0; i < 8; ++i) {
      const double angle = i * std::numbers::pi / 4;
      m_spots.push_back(
          {center.pixel + glm::dvec2(std::cos(angle), std::sin(angle)) * radius * withinRim, center.at});
    }
  }
  void addBall(Place at, double radius) {
    m_spots.push_back(spotAt(at));
    addAround(spotAt(at), radius);
  }
  /// The tip, and places along the head and to both sides of its middle line.
  void addHead(const ArrowMark &arrow) {
    const Place way = shownVector(arrow);
    const double length = glm::length(way);
    const ArrowHead head = headOfArrow(length, arrowRadius * m_scale);
    const Place tip = arrow.from + way;
    for (int i = 0; i <= 4; ++i) {
      const double part = 0.225 * i;
      const Spot middle = spotAt(tip - way / length * head.length * part);
      const glm::dvec2 along = middle.pixel - spotAt(arrow.from).pixel;
      const glm::dvec2 side = glm::normalize(glm::dvec2(along.y, -along.x));
      const double radius = head.radius * part / m_camera.unitsPerPixel(middle.at, m_size);
      m_discs.push_back({middle, radius});
      m_spots.push_back(middle);
      if (i > 0)
        for (const double toSide : {1.0, -1.0})
          m_spots.push_back(beside(middle, side * toSide * radius * withinRim));
    }
  }
  void addKnob(const Handle &handle) {
    const Knob knob = knobOf(handle, false).value();
    addBall(knob.at, knobBall);
    for (const Place &direction : knobDirections(knob, m_camera))
      for (const double way : {1.0, -1.0})
        m_spots.push_back(spotAt(knob.at + direction * way * knobReach * withinRim *
                                               m_camera.unitsPerPixel(knob.at, m_size)));
  }

  Camera m_camera;
  PixelSize m_size;
  double m_scale;
  std::vector<Spot> m_spots;
  std::vector<Disc> m_discs;
};

/// Presses, and takes it back; tells which handle it grabbed.
std::string grabbedAt(ViewFixture &fixture, const std::string &selected, glm::dvec2 pixel) {
  fixture.view.handles().select(selected);
  fixture.press({qRound(pixel.x), qRound(pixel.y)});
  const std::string grabbed =
      fixture.model.history().inGesture() ? fixture.view.handles().selection().selectedId() : "nothing";
  QTest::keyClick(&fixture.view, Qt::Key_Escape);
  fixture.release({qRound(pixel.x), qRound(pixel.y)});
  return grabbed;
}

/// Whether it is the handle, or one that stands where that does: two vectors from one point.
bool isAtThePlaceOf(const std::vector<Handle> &handles, const std::string &id, const Handle &handle) {
  return std::any_of(handles.begin(), handles.end(), [&](const Handle &each) {
    return each.id == id && each.at == handle.at && each.motion == handle.motion;
  });
}

} // namespace

class GrabTest : public QObject {
  Q_OBJECT

private slots:
  void handle_pressedAnywhereOnWhatIsSeenOfIt_isGrabbed_whateverIsSelected_data() {
    QTest::addColumn<QString>("lesson");
    for (const Lesson &lesson : readLessons(TEST_LESSONS_FOLDER).lessons)
      QTest::newRow(lesson.id.c_str()) << QString::fromStdString(lesson.id);
  }

  void handle_pressedAnywhereOnWhatIsSeenOfIt_isGrabbed_whateverIsSelected() {
    QFETCH(QString, lesson);
    ViewFixture fixture(readLessons(TEST_LESSONS_FOLDER));
    QVERIFY(fixture.ready);
    fixture.view.setFixedSize(viewSize);
    QTRY_COMPARE(fixture.view.size(), viewSize);
    fixture.model.openLesson(lesson.toStdString());
    fixture.view.viewpoint().show(NamedView::Home);
    const Figure &figure = fixture.model.shown().figure;
    const auto handles = handlesOf(fixture.model.session().scene);
    std::vector<Drawn> drawn;
    for (const Handle &handle : handles)
      drawn.emplace_back(fixture.view, figure, handle);
    int spots = 0;
    int covered = 0;
    QStringList missed;
    for (std::size_t i = 0; i < handles.size(); ++i)
      for (std::size_t spot = 0; spot < drawn[i].spots().size(); ++spot) {
        const Spot &pressed = drawn[i].spots()[spot];
        ++spots;
        // What is seen there is another handle, nearer to the eye. Its middle every handle shows.
        const auto isCoveredBy = [&](std::size_t other) {
          return !isAtThePlaceOf(handles, handles[other].id, handles[i]) && drawn[other].covers(pressed);
        };
        std::vector<std::size_t> others(handles.size());
        std::iota(others.begin(), others.end(), 0U);
        if (spot > 0 && std::any_of(others.begin(), others.end(), isCoveredBy)) {
          ++covered;
          continue;
        }
        for (std::size_t selected = 0; selected <= handles.size(); ++selected) {
          const std::string id = selected < handles.size() ? handles[selected].id : "";
          const std::string grabbed = grabbedAt(fixture, id, pressed.pixel);
          if (!isAtThePlaceOf(handles, grabbed, handles[i]))
            missed << QString("%1 at its spot %2 with %3 selected: %4")
                          .arg(handles[i].id.c_str())
                          .arg(spot)
                          .arg(id.c_str(), grabbed.c_str());
        }
      }
    QVERIFY2(missed.isEmpty(), qPrintable(missed.join("\n")));
    QVERIFY2(covered <= mostCoveredPart * spots, qPrintable(QString("%1 of %2").arg(covered).arg(spots)));
  }
};

QTEST_MAIN(GrabTest)
#include "grab_test.moc"
