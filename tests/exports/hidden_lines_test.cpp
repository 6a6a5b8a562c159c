// What is hidden, against exact ray casting; and where marks land, against the camera.
#include "geometry/intersect_ray_triangle.h"
#include "tests/effort.h"
#include "tests/picture/labels/vectors_only.h"
#include "tests/picture/marks.h"
#include "widgets/exports/draw_shapes.h"
#include "widgets/picture/composer.h"
#include "widgets/picture/screen_shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>

namespace halfspace {
namespace {

constexpr double pageWidth = 240;
/// Numbers of a drawing that are the same but for rounding.
constexpr double rounding = 1e-6;
/// What is shorter than can be written is left out.
constexpr double written = 0.01;
/// So near to where something begins to be hidden, in points, a sample tells nothing.
constexpr double undecided = 0.02;

Vec3<Rational> exactly3(const Place &place) { return {exactly(place.x), exactly(place.y), exactly(place.z)}; }

/// A scene of triangles that pass through one another, and of lines among them.
struct SeededScene {
  std::mt19937 random;
  Camera camera;
  std::vector<PolygonMark> triangles{};
  std::vector<SegmentMark> segments{};

  explicit SeededScene(unsigned seed) : random(seed) {
    camera.target = {4, 4, 4};
    camera.azimuth = number(-3, 3);
    camera.elevation = number(-1, 1.4);
    camera.height = number(9, 24);
    camera.orthographic = seed % 3 == 0;
    const int count = 1 + static_cast<int>(seed % 5);
    for (int i = 0; i < count; ++i)
      triangles.push_back(withId(polygonOf({place(), place(), place()}), "T" + std::to_string(i)));
    for (int i = 0; i < 8; ++i)
      segments.push_back(withId(segmentBetween(place(), place()), "s" + std::to_string(i)));
  }

  double number(double low, double high) {
    return low + (high - low) * (static_cast<double>(random() % 4096) / 4096);
  }
  Place place() {
    Place at;
    for (int i = 0; i < 3; ++i)
      at[i] = static_cast<double>(random() % 9);
    return at;
  }

  [[nodiscard]] ShapeList shapes() const {
    SceneContent content;
    content.stage.middle = {1000, 1000, 1000}; // without axes and ground
    for (const PolygonMark &triangle : triangles)
      content.figure.add(triangle);
    for (const SegmentMark &segment : segments)
      content.figure.add(segment);
    Composer composer(vectorsOnly());
    composer.setContent(content);
    composer.setView({camera, {1200, 800}, 1});
    return composer.compose();
  }
};

/// A place in the plane of a triangle is rounded to one side of it: nearer than this part of its sight it is
/// in the plane.
const Rational inPlane(1, 1'000'000'000);

/// How many triangles the eye sees a place through, exactly.
std::size_t triangleCountBefore(const Place &place, const SeededScene &scene) {
  const Place origin =
      scene.camera.orthographic ? place - scene.camera.viewDirection() * 100.0 : scene.camera.eye();
  const Ray<Rational> sight{exactly3(origin), exactly3(place) - exactly3(origin)};
  return static_cast<std::size_t>(
      std::count_if(scene.triangles.begin(), scene.triangles.end(), [&](const PolygonMark &triangle) {
        const auto &corners = triangle.corners;
        const auto met = intersectRayTriangle(
            sight, Triangle<Rational>{exactly3(corners[0]), exactly3(corners[1]), exactly3(corners[2])});
        return met.which == RayTriangleCase::Hit && met.plane.t < 1 - inPlane;
      }));
}

/// The pieces of a line that are drawn in full, or those that are hidden.
std::vector<std::pair<glm::dvec2, glm::dvec2>> piecesOf(const Drawing &drawing, const std::string &mark,
                                                        bool hidden) {
  std::vector<std::pair<glm::dvec2, glm::dvec2>> pieces;
  for (const DrawingPart &part : drawing.parts)
    if (const auto *path = std::get_if<PathPart>(&part);
        path && path->pen && path->mark == mark && path->isHidden == hidden)
      for (std::size_t i = 1; i < path->path.steps.size(); ++i)
        pieces.emplace_back(path->path.steps[i - 1].to, path->path.steps[i].to);
  return pieces;
}

double distanceTo(const std::vector<std::pair<glm::dvec2, glm::dvec2>> &pieces, glm::dvec2 spot) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto &[from, to] : pieces)
    least = std::min(least, distanceToSegment(spot, from, to));
  return least;
}

TEST(HiddenLines, InSeededScenes_AreHiddenWhereAnExactRayFromTheEyeIsStopped) {
  int hiddenSamples = 0;
  int seenSamples = 0;
  for (unsigned seed = 1; seed <= static_cast<unsigned>(test::effort(300)); ++seed) {
    SCOPED_TRACE(seed);
    const SeededScene scene(seed);
    const ShapeList shapes = scene.shapes();
    const Drawing drawing = drawingOf(shapes, {pageWidth, HiddenLines::Dashed});
    for (const SegmentMark &segment : scene.segments) {
      const auto hidden = piecesOf(drawing, segment.id, true);
      const auto seen = piecesOf(drawing, segment.id, false);
      for (int i = 1; i < 20; ++i) {
        const Place place = glm::mix(segment.from, segment.to, i / 20.0);
        const auto pixel = scene.camera.project(place, shapes.view.size);
        ASSERT_TRUE(pixel);
        const glm::dvec2 spot = glm::dvec2(*pixel) * (pageWidth / shapes.view.size.width);
        const double toHidden = distanceTo(hidden, spot);
        const double toSeen = distanceTo(seen, spot);
        const bool isOffPage = spot.x < 0 || spot.y < 0 || spot.x > drawing.size.x || spot.y > drawing.size.y;
        if (isOffPage || segment.from == segment.to || std::max(toHidden, toSeen) < undecided)
          continue;
        EXPECT_LT(std::min(toHidden, toSeen), rounding) << segment.id << " is drawn in full";
        const bool isHidden = toHidden < toSeen;
        EXPECT_EQ(isHidden, triangleCountBefore(place, scene) != 0) << segment.id << " at " << i;
        ++(isHidden ? hiddenSamples : seenSamples);
      }
    }
  }
  EXPECT_GT(hiddenSamples, test::atLeast(2000));
  EXPECT_GT(seenSamples, test::atLeast(2000));
}

TEST(HiddenLines, LeftOut_AreNotDrawn_AndPalerOnesAreNotCutWhereTheyAreCovered) {
  SceneContent content;
  content.figure.add(withId(polygonOf({{4, 0, 0}, {4, 9, 0}, {4, 9, 9}, {4, 0, 9}}), "wall"));
  content.figure.add(withId(segmentBetween({0, -4, 4}, {0, 20, 4}), "line"));
  Composer composer(vectorsOnly());
  composer.setContent(content);
  View view{{}, {1200, 800}, 1};
  view.camera.target = {4, 4, 4};
  view.camera.elevation = 0.1;
  composer.setView(view);
  const ShapeList &shapes = composer.compose();
  const auto parts = [&](HiddenLines hidden, bool wanted) {
    return piecesOf(drawingOf(shapes, {pageWidth, hidden}), "line", wanted).size();
  };
  EXPECT_EQ(parts(HiddenLines::Dashed, true), 1U);
  EXPECT_EQ(parts(HiddenLines::Dashed, false), 2U);
  EXPECT_EQ(parts(HiddenLines::LeftOut, true), 0U);
  EXPECT_EQ(parts(HiddenLines::LeftOut, false), 2U);
  EXPECT_EQ(parts(HiddenLines::Paler, true), 1U) << "in one piece";
  EXPECT_EQ(parts(HiddenLines::Paler, false), 0U);
}

/// The middle of a path that goes around a disc.
glm::dvec2 middleOf(const PagePath &path) {
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high(-std::numeric_limits<double>::infinity());
  for (const PageStep &step : path.steps)
    if (step.kind != PageStep::Kind::Close) {
      low = glm::min(low, step.to);
      high = glm::max(high, step.to);
    }
  return (low + high) / 2.0;
}

TEST(Drawings, OfSeededScenes_HaveEveryMarkWhereTheCameraSeesIt) {
  int marks = 0;
  for (unsigned seed = 1; seed <= static_cast<unsigned>(test::effort(2000)); ++seed) {
    SCOPED_TRACE(seed);
    SeededScene scene(seed);
    SceneContent content;
    std::map<std::string, std::vector<Place>> ends;
    for (const SegmentMark &segment : scene.segments) {
      content.figure.add(segment);
      ends[segment.id] = {segment.from, segment.to};
    }
    for (int i = 0; i < 4; ++i) {
      const PointMark point = withId(pointAt(scene.place()), "P" + std::to_string(i));
      content.figure.add(point);
      ends[point.id] = {point.at};
    }
    content.figure.add(scene.triangles.front());
    Composer composer(vectorsOnly());
    composer.setContent(content);
    const View view{scene.camera, {1200, 800}, 1};
    composer.setView(view);
    const Drawing drawing = drawingOf(composer.compose(), {pageWidth});
    for (const auto &[mark, places] : ends)
      for (const Place &place : places) {
        const glm::dvec2 spot =
            glm::dvec2(view.camera.project(place, view.size).value()) * (pageWidth / view.size.width);
        if (places.front() == places.back() && places.size() > 1)
          continue; // a segment without length
        if (spot.x < 0 || spot.y < 0 || spot.x > drawing.size.x || spot.y > drawing.size.y)
          continue;
        double least = std::numeric_limits<double>::infinity();
        for (const DrawingPart &part : drawing.parts)
          if (const auto *path = std::get_if<PathPart>(&part); path && path->mark == mark) {
            if (path->fill)
              least = std::min(least, glm::distance(middleOf(path->path), spot));
            else
              for (const PageStep &step : path->path.steps)
                least = std::min(least, glm::distance(step.to, spot));
          }
        EXPECT_LT(least, written) << mark;
        ++marks;
      }
  }
  EXPECT_GT(marks, test::atLeast(10000));
}

} // namespace
} // namespace halfspace
