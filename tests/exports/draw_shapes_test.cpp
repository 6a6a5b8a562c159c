// What lies over what in a drawing, and what it is drawn with.
#include "widgets/exports/draw_shapes.h"

#include "geometry/triangle_mesh.h"
#include "tests/picture/labels/vectors_only.h"
#include "tests/picture/marks.h"
#include "widgets/picture/composer.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace halfspace {
namespace {

constexpr double pageWidth = 240;

struct Drawn : testing::Test {
  SceneContent content;
  View view{{}, {1200, 800}, 1};

  void SetUp() override {
    content.stage.middle = {1000, 1000, 1000}; // without axes and ground
    view.camera.target = {0, 0, 0};
    view.camera.elevation = 0.3;
    view.camera.height = 12;
  }
  ShapeList shapes() const {
    Composer composer(vectorsOnly());
    composer.setContent(content);
    composer.setView(view);
    return composer.compose();
  }
  Drawing drawing(HiddenLines hidden = HiddenLines::Dashed) const {
    return drawingOf(shapes(), {pageWidth, hidden});
  }
  /// The marks of all paths, in the order in which they are painted; hidden ones in brackets.
  std::vector<std::string> order(HiddenLines hidden = HiddenLines::Dashed) const {
    std::vector<std::string> marks;
    for (const DrawingPart &part : drawing(hidden).parts)
      if (const auto *path = std::get_if<PathPart>(&part))
        marks.push_back(path->isHidden ? "(" + path->mark + ")" : path->mark);
    return marks;
  }
  const PathPart *firstOf(const Drawing &drawing, const std::string &mark, bool isFilled) const {
    for (const DrawingPart &part : drawing.parts)
      if (const auto *path = std::get_if<PathPart>(&part);
          path && path->mark == mark && path->fill.has_value() == isFilled)
        return path;
    return nullptr;
  }
};

/// A square at x, of half a side.
PolygonMark wallAt(double x, double half = 3) {
  return polygonOf({{x, -half, -half}, {x, half, -half}, {x, half, half}, {x, -half, half}});
}

using Marks = std::vector<std::string>;

TEST_F(Drawn, AnArrowThroughAFace_IsCutThere_WithTheHeadOnItsSide) {
  content.figure.add(withId(wallAt(0), "wall"));
  ArrowMark arrow = withId(ArrowMark{}, "arrow");
  arrow.from = {-4, 0, 0};
  arrow.vector = {8, 1, 0};
  content.figure.add(arrow);
  EXPECT_EQ(order(), (Marks{"(arrow)", "wall", "wall", "arrow", "arrow"})) << "its head last";
  content.figure.marks = {};
  content.figure.add(withId(wallAt(0), "wall"));
  arrow.from = {4, 0, 0};
  arrow.vector = {-8, 1, 0};
  content.figure.add(arrow);
  const Marks reversed = order();
  EXPECT_EQ(std::count(reversed.begin(), reversed.end(), "(arrow)"), 2) << "shaft and head";
  EXPECT_EQ(reversed.back(), "arrow");
}

TEST_F(Drawn, WhatLiesOnAFace_IsDrawnOverIt) {
  content.figure.add(withId(wallAt(0), "wall"));
  content.figure.add(withId(segmentBetween({0, -2, -2}, {0, 2, 2}), "line"));
  content.figure.add(withId(pointAt({0, 1, 0}), "point"));
  EXPECT_EQ(order(), (Marks{"wall", "wall", "line", "point"}));
}

TEST_F(Drawn, OfTwoLines_TheNearerLiesOverTheOther) {
  const SegmentMark near = withId(segmentBetween({2, -2, 0}, {2, 2, 0.1}), "near");
  const SegmentMark far = withId(segmentBetween({-2, 0, -3}, {-2, 0.1, 3}), "far");
  content.figure.add(near);
  content.figure.add(far);
  EXPECT_EQ(order(), (Marks{"far", "near"}));
  content.figure.marks = {};
  content.figure.add(far);
  content.figure.add(near);
  EXPECT_EQ(order(), (Marks{"far", "near"}));
}

TEST_F(Drawn, ALineThatIsSeenFromItsEnd_HasNoPath) {
  view.camera.elevation = 0;
  view.camera.orthographic = true;
  content.figure.add(withId(wallAt(0), "wall"));
  LineMark line = withId(LineMark{}, "line");
  line.direction = {1, 0, 0};
  content.figure.add(line);
  EXPECT_EQ(order(), (Marks{"wall", "wall"})) << "its dashes would have no direction";
}

TEST_F(Drawn, APoint_LiesOverTheLinesThatEndInIt) {
  content.figure.add(withId(pointAt({0, 0, 0}), "point"));
  content.figure.add(withId(segmentBetween({0, 0, 0}, {3, 1, 0}), "near"));
  content.figure.add(withId(segmentBetween({0, 0, 0}, {-3, 1, 0}), "far"));
  EXPECT_EQ(order().back(), "point");
}

TEST_F(Drawn, FacesThatPassThroughEachOther_AreOnePathForEachPartThatLiesElsewhere) {
  content.figure.add(withId(wallAt(0), "a"));
  content.figure.add(withId(polygonOf({{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}), "b"));
  Marks fills;
  for (const DrawingPart &part : drawing().parts)
    if (const auto *path = std::get_if<PathPart>(&part); path && path->fill)
      fills.push_back(path->mark);
  EXPECT_EQ(fills, (Marks{"b", "a", "b"}));
}

TEST_F(Drawn, ABall_IsItsSilhouetteTwice_AndWhatIsInItIsHidden) {
  view.camera.target = {0, 3, 1}; // seen from aside: an ellipse
  content.figure.add(withId(SphereMark{{}, {0, 0, 0}, 2}, "ball"));
  content.figure.add(withId(segmentBetween({0, -1, 0}, {0, 1, 0}), "inside"));
  content.figure.add(withId(segmentBetween({3, -1, 0}, {3, 1, 0}), "before"));
  const Drawing drawn = drawing();
  const PathPart *disc = firstOf(drawn, "ball", true);
  ASSERT_TRUE(disc);
  const double scale = view.size.width / pageWidth;
  for (const PageStep &step : disc->path.steps) {
    if (step.kind == PageStep::Kind::Close)
      continue;
    const SightLine sight = view.camera.sightThrough(step.to * scale, view.size);
    EXPECT_NEAR(glm::length(glm::cross(sight.direction, sight.origin)), 2, 1e-6)
        << "sights touch the ball there";
  }
  const Marks marks = order();
  EXPECT_EQ(std::count(marks.begin(), marks.end(), "(inside)"), 1);
  EXPECT_EQ(std::count(marks.begin(), marks.end(), "before"), 1);
  EXPECT_NE(std::find(marks.begin(), marks.end(), "(ball)"), marks.end()) << "great circles have a far half";
}

TEST_F(Drawn, ABody_HidesWhatStandsBehindIt) {
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->corners = {{0, -2, -2}, {0, 2, -2}, {0, 2, 2}, {0, -2, 2}};
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  MeshMark body = withId(MeshMark{}, "body");
  body.mesh = mesh;
  content.figure.add(body);
  content.figure.add(withId(segmentBetween({-1, -1, 0.1}, {-1, 1, 0.1}), "behind"));
  content.figure.add(withId(segmentBetween({1, -1, 0.1}, {1, 1, 0.1}), "before"));
  EXPECT_EQ(order(), (Marks{"(behind)", "body", "before"})) << "its triangles are in one plane";
  const Drawing drawn = drawing();
  const PathPart *painted = firstOf(drawn, "body", true);
  ASSERT_TRUE(painted);
  EXPECT_EQ(painted->fill->opacity, 1);
  EXPECT_TRUE(painted->pen) << "no seam";
}

TEST_F(Drawn, WithHiddenLinesLeftOut_LabelsOfMarksThatAreWhollyHiddenAreToo) {
  const auto labelled = [](auto mark, const std::string &id) {
    mark = withId(mark, id);
    mark.label = id;
    return mark;
  };
  content.figure.add(labelled(wallAt(0), "W"));
  content.figure.add(labelled(wallAt(-1, 2), "V")); // its border is hidden, the face is not
  content.figure.add(labelled(pointAt({-2, 0, 0}), "B"));
  content.figure.add(labelled(pointAt({2, 1, 1}), "A"));
  content.figure.add(labelled(segmentBetween({-2, 2, 0}, {2, 2, 0}), "s"));
  const auto labels = [&](HiddenLines hidden) {
    std::set<std::string> marks;
    for (const DrawingPart &part : drawing(hidden).parts)
      if (const auto *formula = std::get_if<FormulaPart>(&part))
        marks.insert(formula->mark);
    return marks;
  };
  EXPECT_EQ(labels(HiddenLines::Dashed), (std::set<std::string>{"A", "B", "V", "W", "s"}));
  EXPECT_EQ(labels(HiddenLines::LeftOut), (std::set<std::string>{"A", "V", "W", "s"}));
}

TEST_F(Drawn, PensHaveOneWidthWhereverTheirLinesAre) {
  content.figure.add(withId(segmentBetween({4, -2, 0}, {4, 2, 0}), "near"));
  content.figure.add(withId(segmentBetween({-30, -2, 0}, {-30, 2, 0}), "far"));
  const Drawing drawn = drawing();
  ASSERT_TRUE(firstOf(drawn, "near", false) && firstOf(drawn, "far", false));
  EXPECT_EQ(firstOf(drawn, "near", false)->pen->width, firstOf(drawn, "far", false)->pen->width);
}

TEST_F(Drawn, OfVeryManyThings_IsDrawnInBoundedTime) {
  std::mt19937 random(1);
  const auto place = [&] {
    const auto number = [&] { return static_cast<double>(random() % 1000) / 100 - 5; };
    return Place(number(), number(), number());
  };
  for (int i = 0; i < 200; ++i) {
    const std::string number = std::to_string(i);
    content.figure.add(withId(polygonOf({place(), place(), place()}), "t" + number));
    content.figure.add(withId(segmentBetween(place(), place()), "s" + number));
    content.figure.add(withId(pointAt(place()), "p" + number));
  }
  const Drawing drawn = drawing();
  EXPECT_GT(drawn.parts.size(), 500U);
  EXPECT_LT(drawn.parts.size(), 200000U);
}

TEST_F(Drawn, WithTheEyeAmongAll_HasFiniteNumbersNearThePage) {
  view.camera.height = 0.2;
  content.figure.add(withId(wallAt(0.05, 500), "wall"));
  content.figure.add(withId(segmentBetween({-900, -900, 0}, {900, 900, 1}), "line"));
  content.figure.add(withId(SphereMark{{}, {0, 0, 0}, 100}, "ball"));
  ArrowMark arrow = withId(ArrowMark{}, "arrow");
  arrow.from = {-100, 0, 0};
  arrow.vector = {500, 3, 1};
  content.figure.add(arrow);
  for (const bool orthographic : {false, true}) {
    view.camera.orthographic = orthographic;
    for (const DrawingPart &part : drawing().parts)
      if (const auto *path = std::get_if<PathPart>(&part))
        for (const PageStep &step : path->path.steps) {
          EXPECT_LT(std::abs(step.to.x), 2 * pageWidth) << path->mark;
          EXPECT_LT(std::abs(step.to.y), 2 * pageWidth) << path->mark;
        }
  }
}

} // namespace
} // namespace halfspace
