// What stands in the list of shapes for a scene: from which marks, in which order, and what stays as it was.
#include "widgets/picture/composer.h"

#include "geometry/triangle_mesh.h"
#include "tests/picture/labels/vectors_only.h"
#include "tests/picture/marks.h"
#include "widgets/picture/shapes/surface_layers.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace halfspace {
namespace {

View viewFrom(Place from) {
  CameraView camera;
  camera.from = from;
  camera.at = {6, 8, 4};
  return {Camera(camera), {640, 400}, 1};
}

/// A plane with a triangle on it, an arrow, a ray and a point with a name.
SceneContent usualContent() {
  SceneContent content;
  ArrowMark normal = withId(ArrowMark{}, "E.n", Subject::Plane);
  normal.from = {6, 8, 4};
  normal.vector = {0, 0, 4};
  RayMark ray = withId(RayMark{}, "L", Subject::Ray);
  ray.origin = {2, 4, 9};
  ray.direction = {1, 1, -1};
  PointMark point = withId(pointAt({9, 6, 9}), "Q", Subject::Point);
  point.label = "Q";
  content.figure.add(point);
  content.figure.add(withId(polygonOf({{4, 6, 4}, {8, 6, 4}, {6, 10, 4}}), "T", Subject::Triangle));
  content.figure.add(normal);
  content.figure.add(ray);
  content.figure.add(withId(patchAt({6, 8, 4}, {0, 0, 1}), "E", Subject::Plane));
  return content;
}

struct Composed : testing::Test {
  Composer composer{vectorsOnly()};

  void SetUp() override {
    composer.setContent(usualContent());
    composer.setView(viewFrom({1, 0.6, 0.5}));
  }
  const std::vector<Shape> &shapes(Layer layer) { return *composer.compose().layer(layer); }
  std::vector<std::string> marks(Layer layer) {
    std::vector<std::string> ids;
    for (const Shape &shape : shapes(layer))
      ids.push_back(shape.mark);
    return ids;
  }
  template <class Form> std::size_t count(Layer layer) {
    std::size_t number = 0;
    forEach<Form>(shapes(layer), [&](const Shape &, const Form &) { ++number; });
    return number;
  }
  /// The layers that another picture does not share with the one before.
  template <class Change> std::set<Layer> renewedBy(Change change) {
    const auto before = composer.compose().layers;
    change();
    const ShapeList &after = composer.compose();
    std::set<Layer> renewed;
    for (std::size_t i = 0; i < layerCount; ++i)
      if (after.layers[i] != before[i])
        renewed.insert(static_cast<Layer>(i));
    return renewed;
  }
};

TEST_F(Composed, Solids_AreOfTheMarksInTheirOrder_OneEach) {
  EXPECT_EQ(marks(Layer::Solids), (std::vector<std::string>{"Q", "T", "E.n", "L", "E"}));
  const std::vector<Shape> &solids = shapes(Layer::Solids);
  const auto *ball = std::get_if<BallShape>(&solids[0].form);
  ASSERT_TRUE(ball);
  EXPECT_EQ(ball->center, Place(9, 6, 9));
  const auto *border = std::get_if<LineShape>(&solids[1].form);
  ASSERT_TRUE(border);
  EXPECT_TRUE(border->isClosed);
  EXPECT_EQ(border->path.size(), 3U);
  EXPECT_FALSE(border->fade);
  EXPECT_TRUE(std::get_if<ArrowShape>(&solids[2].form));
  const auto *ray = std::get_if<LineShape>(&solids[3].form);
  ASSERT_TRUE(ray);
  ASSERT_TRUE(ray->fade) << "it goes on";
  EXPECT_FALSE(ray->fade->isAtBothEnds);
}

TEST_F(Composed, Faces_AreFromBackToFront_OfTheMarksThatTheyAreOf) {
  EXPECT_EQ(marks(Layer::Faces), (std::vector<std::string>{"E", "T"})) << "a triangle lies on its plane";
  SceneContent content;
  content.figure.add(withId(polygonOf({{0, -2, -2}, {0, 2, -2}, {0, 2, 2}, {0, -2, 2}}), "near"));
  content.figure.add(withId(polygonOf({{-5, -2, 0}, {5, -2, 0}, {5, 2, 0}, {-5, 2, 0}}), "cut"));
  composer.setContent(content);
  composer.setView(viewFrom({1, 0, 0.2}));
  EXPECT_EQ(marks(Layer::Faces), (std::vector<std::string>{"cut", "near", "cut"}));
  composer.setView(viewFrom({-1, 0, 0.2}));
  EXPECT_EQ(marks(Layer::Faces), (std::vector<std::string>{"cut", "near", "cut"}));
}

TEST_F(Composed, Labels_AreOfMarksAndAxes_OnThePage) {
  std::size_t ofQ = 0;
  forEach<LabelShape>(shapes(Layer::Labels), [&](const Shape &shape, const LabelShape &label) {
    ofQ += shape.mark == "Q" ? 1U : 0U;
    EXPECT_TRUE(shape.mark == "Q" || shape.mark.empty()) << shape.mark;
    EXPECT_FALSE(label.formula->glyphs.empty());
    EXPECT_TRUE(label.box.low.x >= 0 && label.box.high.x <= 640 && label.box.low.y >= 0 &&
                label.box.high.y <= 400);
  });
  EXPECT_EQ(ofQ, 1U);
  EXPECT_GT(count<LabelShape>(Layer::Labels), 3U) << "x, y, z and numbers";
}

TEST_F(Composed, OnAStageFarAway_HasNeitherGridNorAxesNorShadows) {
  EXPECT_GT(count<HairlineShape>(Layer::Ground), 20U);
  EXPECT_GT(count<LineShape>(Layer::Axes), 3U) << "ticks";
  EXPECT_TRUE(composer.compose().shadows);
  SceneContent content = usualContent();
  content.stage.middle = {1000, 1000, 1000};
  composer.setContent(content);
  EXPECT_TRUE(shapes(Layer::Ground).empty());
  EXPECT_TRUE(shapes(Layer::Axes).empty());
  EXPECT_FALSE(composer.compose().shadows);
  composer.setContent(usualContent());
  EXPECT_GT(count<HairlineShape>(Layer::Ground), 20U) << "it is back";
}

TEST_F(Composed, Shadows_AreThereWhereTheGroundIsSeenFromAbove) {
  composer.setBackgroundVisible(false);
  EXPECT_FALSE(composer.compose().shadows);
  composer.setBackgroundVisible(true);
  EXPECT_TRUE(composer.compose().shadows);
  composer.setView(viewFrom({1, 0.6, -3}));
  EXPECT_FALSE(composer.compose().shadows);
}

TEST_F(Composed, ToolsAreNoMarks_AndTheOutlineOfABallIsOne) {
  SceneContent content = usualContent();
  content.figure.add(withId(SphereMark{{}, {6, 8, 4}, 2}, "S"));
  content.gizmo.emplace();
  content.gizmo->at = {9, 6, 9};
  content.dropLine = DropLine{{9, 6, 9}};
  content.knobs.push_back({"k", {2, 2, 2}, {}, Subject::Plane, false});
  composer.setContent(content);
  EXPECT_GT(count<ArrowShape>(Layer::Tools), 3U);
  EXPECT_EQ(count<BallShape>(Layer::Tools), 1U);
  for (const std::string &mark : marks(Layer::Tools))
    EXPECT_EQ(mark, "");
  EXPECT_EQ(marks(Layer::Axes).back(), "S");
}

TEST_F(Composed, Bodies_AreOneShapeEach_OfWhichSoManyTrianglesAreDrawn) {
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->triangles = {{0, 1, 2}};
  MeshMark mark = withId(MeshMark{}, "barn");
  mark.mesh = mesh;
  mark.place = {1, 2, 3};
  SceneContent content;
  content.figure.add(mark);
  composer.setContent(content);
  ASSERT_EQ(marks(Layer::Bodies), (std::vector<std::string>{"barn"}));
  const auto &body = std::get<BodyShape>(shapes(Layer::Bodies).front().form);
  EXPECT_EQ(body.mesh, mesh);
  EXPECT_EQ(body.origin, Place(1, 2, 3));
  EXPECT_EQ(body.stride, 1U);
  EXPECT_TRUE(shapes(Layer::Solids).empty());
  content.arrival = {{"barn"}, 0};
  composer.setContent(content);
  EXPECT_TRUE(shapes(Layer::Bodies).empty()) << "it is not there yet";
}

TEST_F(Composed, WhatDidNotChange_IsSharedWithTheListBefore) {
  EXPECT_EQ(renewedBy([] {}), std::set<Layer>());
  EXPECT_EQ(renewedBy([&] { composer.setContent(usualContent()); }), std::set<Layer>());
  EXPECT_EQ(renewedBy([&] { composer.setTools(Gizmo(), {}); }), std::set<Layer>{Layer::Tools});
  const std::set<Layer> turned = renewedBy([&] { composer.setView(viewFrom({1, 0.7, 0.5})); });
  EXPECT_FALSE(turned.contains(Layer::Ground));
  EXPECT_FALSE(turned.contains(Layer::Solids));
  EXPECT_FALSE(turned.contains(Layer::Faces)) << "their order is the same from there";
  EXPECT_TRUE(turned.contains(Layer::Axes)) << "ticks turn to the eye";
  SceneContent moved = usualContent();
  moved.figure.marks.change(0, [](Mark &mark) { std::get<PointMark>(mark).at = {9, 7, 9}; });
  const std::set<Layer> dragged = renewedBy([&] { composer.setContent(moved); });
  EXPECT_TRUE(dragged.contains(Layer::Solids));
  for (const Layer layer : {Layer::Ground, Layer::Axes, Layer::Faces})
    EXPECT_FALSE(dragged.contains(layer)) << static_cast<int>(layer);
}

TEST_F(Composed, InAnotherTheme_HasItsColours) {
  const Theme &dark = *findTheme("dark");
  composer.setTheme(dark);
  const ShapeList &list = composer.compose();
  EXPECT_EQ(list.background, (Background{dark.backgroundBottom, dark.backgroundTop, true}));
  EXPECT_EQ(list.shadows->ofSolids, dark.shadow);
  EXPECT_EQ(list.layer(Layer::Ground)->back().color, dark.gridMajor);
  EXPECT_EQ(list.layer(Layer::Axes)->front().color, dark.axis);
}

TEST_F(Composed, TypeIsAsLargeAsPixelRatioAndThemeAskFor) {
  Theme theme = *findTheme("light");
  theme.textScale = 1.5;
  composer.setTheme(theme);
  View view = viewFrom({1, 0.6, 0.5});
  view.pixelRatio = 2;
  composer.setView(view);
  forEach<LabelShape>(shapes(Layer::Labels), [](const Shape &shape, const LabelShape &label) {
    if (shape.mark == "Q") {
      EXPECT_DOUBLE_EQ(label.style.pixelSize, 22 * 2 * 1.5);
    }
  });
}

TEST_F(Composed, ALabelIsPartOfItsMark) {
  const View view = viewFrom({1, 0.6, 0.5});
  composer.compose();
  const auto point = view.camera.project({9, 6, 9}, view.size);
  ASSERT_TRUE(point);
  EXPECT_EQ(composer.markAt(glm::dvec2(*point)), "Q");
  forEach<LabelShape>(shapes(Layer::Labels), [&](const Shape &shape, const LabelShape &label) {
    if (shape.mark == "Q") {
      EXPECT_EQ(composer.markAt((label.box.low + label.box.high) / 2.0), "Q");
    }
  });
  EXPECT_EQ(composer.markAt({5, 5}), "");
}

TEST_F(Composed, AMarkThatLosesItsName_LosesItsLabel_AndGetsItBack) {
  const auto isLabelled = [&](const std::string &name) {
    SceneContent content = usualContent();
    content.figure.marks.change(0, [&](Mark &mark) { std::get<PointMark>(mark).label = name; });
    composer.setContent(content);
    const std::vector<std::string> labelled = marks(Layer::Labels);
    return std::find(labelled.begin(), labelled.end(), "Q") != labelled.end();
  };
  EXPECT_TRUE(isLabelled("Q"));
  EXPECT_FALSE(isLabelled("{}"));
  EXPECT_TRUE(isLabelled("R"));
}

/// Where the label of Q stands.
glm::dvec2 placeOfQ(const ShapeList &list) {
  glm::dvec2 place(-1);
  forEach<LabelShape>(*list.layer(Layer::Labels), [&](const Shape &shape, const LabelShape &label) {
    if (shape.mark == "Q")
      place = label.box.low;
  });
  return place;
}

TEST_F(Composed, LabelsAreForgotten_AsInAFirstPicture) {
  const glm::dvec2 alone = placeOfQ(composer.compose());
  const View view = viewFrom({1, 0.6, 0.5});
  SceneContent crowded = usualContent();
  const SightLine sight = view.camera.sightThrough(alone + 4.0, view.size);
  crowded.figure.add(withId(pointAt(sight.origin + sight.direction * view.camera.distance()), "R"));
  composer.setContent(crowded);
  const glm::dvec2 aside = placeOfQ(composer.compose());
  ASSERT_NE(aside, alone);
  composer.setContent(usualContent());
  EXPECT_EQ(placeOfQ(composer.compose()), aside) << "nothing drives it away";
  composer.forgetLabels();
  EXPECT_EQ(placeOfQ(composer.compose()), alone);
}

TEST_F(Composed, OfVeryManyFacesOneBehindAnother_LeavesOutSome) {
  const auto walls = [](int count) {
    SceneContent content;
    for (int i = 0; i < count; ++i) {
      const double x = -i / 1000.0;
      content.figure.add(
          withId(polygonOf({{x, -9, -9}, {x, 9, -9}, {x, 9, 9}, {x, -9, 9}}), "wall" + std::to_string(i)));
    }
    return content;
  };
  composer.setContent(walls(mostFaceLayers));
  EXPECT_EQ(shapes(Layer::Faces).size(), mostFaceLayers);
  EXPECT_FALSE(composer.compose().leavesOutSurfaces);
  composer.setContent(walls(mostFaceLayers + 1));
  EXPECT_LT(shapes(Layer::Faces).size(), mostFaceLayers);
  EXPECT_TRUE(composer.compose().leavesOutSurfaces);
}

} // namespace
} // namespace halfspace
