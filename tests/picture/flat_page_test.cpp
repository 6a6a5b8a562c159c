#include "widgets/picture/flat_page.h"

#include "lessons/object/drawing.h"
#include "widgets/picture/flat_picture.h"
#include "widgets/picture/shapes/flat_shapes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace halfspace {
namespace {

const Lesson &lesson() {
  static const LessonLibrary lessons = readLessons(LESSON_FOLDER);
  return *lessons.find("ray-plane-picture");
}

/// Places of scenes are some units from the origin; turning them loses no more than the last digits.
constexpr double lastDigits = 1e-13;

/// The mark of this kind with an id.
template <class Kind> Kind markIn(const Figure &figure, std::string_view id) {
  for (const Mark &mark : figure.marks)
    if (const auto *found = std::get_if<Kind>(&mark); found && found->id == id)
      return *found;
  ADD_FAILURE() << "no such mark: " << id;
  return {};
}

/// Directions without a pattern, some of them along one line.
std::vector<std::pair<ExactVec3, ExactVec3>> directions() {
  std::vector<std::pair<ExactVec3, ExactVec3>> all{{{1, 2, 2}, {3, 0, 3}},
                                                   {{0, 0, 1}, {1, 1, 0}},
                                                   {{0, 0, -2}, {0, 0, 1}},
                                                   {{1, 2, 2}, {-2, -4, -4}},
                                                   {{Rational(1, 1000), 0, 0}, {1000, 1, 0}},
                                                   {{1, 2, 3}, {0, 0, 0}}};
  for (int i = 1; i <= 20; ++i)
    all.push_back({{i, 7 - i, Rational(i * i % 11, 3)}, {5 - i, Rational(i, 7), i % 4}});
  return all;
}

Figure planeAndCorner(const ExactVec3 &up, const FlatFrame &frame) {
  Figure figure;
  const Place at(3, -2, 5);
  figure.add(PlanePatchMark{{"E", Role::Given, Subject::Plane, "E"}, at, toDouble(up), {}});
  figure.add(PointMark{{"P", Role::Given, Subject::Point, "P"}, at});
  figure.add(PolygonMark{{"triangle"}, {at, at + 3.0 * frame.right, at + 4.0 * frame.up}});
  return figure;
}

TEST(FlatFrame, IsSquareAndOfUnitLength_WhateverTheDirections) {
  for (const auto &[up, right] : directions()) {
    const FlatFrame frame = flatFrame(up, right).value();
    for (const Place &axis : {frame.toEye, frame.right, frame.up})
      EXPECT_NEAR(glm::length(axis), 1, lastDigits);
    EXPECT_NEAR(glm::dot(frame.right, frame.up), 0, lastDigits);
    EXPECT_GE(glm::dot(frame.right, toDouble(right)), -lastDigits) << "it points to the right";
    EXPECT_NEAR(glm::dot(frame.toEye, toDouble(right)), 0, lastDigits * 1000) << "in its true length";
  }
}

TEST(FlatFrame, OfAZeroNormal_IsNone) { EXPECT_FALSE(flatFrame(ExactVec3(0), ExactVec3(1, 0, 0))); }

TEST(FlatPicture, OfAPlaneWithItsNormalUp_IsALevelLine) {
  for (const auto &[up, right] : directions()) {
    const FlatFrame frame = flatFrame(up, right).value();
    const Figure flat = laidFlat(planeAndCorner(up, frame), frame);
    const auto line = markIn<SegmentMark>(flat, "E");
    EXPECT_NEAR(line.from.z, line.to.z, lastDigits * 20);
    EXPECT_GE(line.to.y - line.from.y, minimumPatchSide - 1e-9);
    EXPECT_EQ(line.label, "E");
  }
}

TEST(FlatPicture, OfATriangleInThePage_HasItsTrueSidesAndRightAngle_OnTheScreen) {
  constexpr PixelSize size{400, 300};
  for (const auto &[up, right] : directions()) {
    const FlatFrame frame = flatFrame(up, right).value();
    const Figure flat = laidFlat(planeAndCorner(up, frame), frame);
    const Camera camera = flatCamera(flat, {{}, size, 1});
    const double pixels = size.height / camera.height;
    const std::vector<Place> corners = markIn<PolygonMark>(flat, "triangle").corners;
    ASSERT_EQ(corners.size(), 3U);
    const auto seen = [&](std::size_t i) { return glm::dvec2(camera.project(corners.at(i), size).value()); };
    const glm::dvec2 a = seen(1) - seen(0);
    const glm::dvec2 b = seen(2) - seen(0);
    EXPECT_NEAR(glm::length(a), 3 * pixels, 1e-9);
    EXPECT_NEAR(glm::length(b), 4 * pixels, 1e-9);
    EXPECT_NEAR(glm::dot(a, b), 0, 1e-9);
    EXPECT_GT(a.x, 0);
    EXPECT_LT(b.y, 0) << "pixels count down";
  }
}

TEST(FlatPicture, OfAPlaneThatIsNotEdgeOn_IsItsFace) {
  Figure figure;
  figure.add(PlanePatchMark{{"E"}, Place(0), Place(1, 1, 0), {}});
  const Figure flat = laidFlat(figure, flatFrame(ExactVec3(0, 0, 1), ExactVec3(1, 0, 0)).value());
  EXPECT_TRUE(std::holds_alternative<PolygonMark>(flat.marks.front()));
}

TEST(FlatPicture, OfItsLesson_ShowsAllPointsButNoPlaneBeyondItsSides) {
  const Evaluation evaluation = evaluate(lesson().scene);
  const Figure whole = figureOf(evaluation);
  const FlatPicture flat(flatFrame(lesson().flat, lesson().scene).value(), {}, whole, whole);
  const View view = flat.fitted({{}, {300, 220}, 0.8});
  EXPECT_TRUE(flat.isInView(view));
  const auto line = markIn<SegmentMark>(flat.seenFrom(view).figure, "G");
  for (const Place &end : {line.from, line.to}) {
    const glm::dvec3 pixel = view.camera.project(end, view.size).value();
    EXPECT_GE(pixel.x, -1e-9);
    EXPECT_LE(pixel.x, view.size.width + 1e-9);
  }
}

TEST(FlatPicture, TurnsRightAnglesOfTheFigureIntoRightAngles) {
  const Evaluation evaluation = evaluate(lesson().scene);
  const Figure flat = laidFlat(figureOf(evaluation), flatFrame(lesson().flat, lesson().scene).value());
  int corners = 0;
  for (const Mark &mark : flat.marks)
    if (const auto *corner = std::get_if<RightAngleMark>(&mark)) {
      ++corners;
      const glm::dvec2 first(corner->first.y, corner->first.z);
      const glm::dvec2 second(corner->second.y, corner->second.z);
      EXPECT_NEAR(glm::dot(glm::normalize(first), glm::normalize(second)), 0, lastDigits) << corner->id;
    }
  EXPECT_EQ(corners, 4);
}

TEST(FlatShapes, OfALesson_LieFromFacesOverLinesToPoints_AndHaveASize) {
  const Evaluation evaluation = evaluate(lesson().scene);
  SceneContent content;
  content.figure = laidFlat(figureOf(evaluation), flatFrame(lesson().flat, lesson().scene).value());
  View view{{}, {300, 220}, 0.8};
  view.camera = flatCamera(content.figure, view);
  const std::vector<FlatShape> shapes = flatShapes(content, themes().front(), view);
  ASSERT_FALSE(shapes.empty());
  EXPECT_LT(shapes.front().opacity, 1);
  EXPECT_TRUE(shapes.back().isDisc);
  for (const FlatShape &shape : shapes)
    EXPECT_TRUE(shape.width > 0.3 || shape.path.size() > 2);
}

} // namespace
} // namespace halfspace
