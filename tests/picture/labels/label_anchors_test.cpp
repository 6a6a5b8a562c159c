// Where labels of marks may stand, how they look, and what they keep clear of.
#include "widgets/picture/labels/label_requests.h"

#include "tests/picture/marks.h"
#include "widgets/picture/design_scale.h"
#include "widgets/picture/screen_shapes.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace halfspace {
namespace {

const Theme &theme() { return themes().front(); }

View usualView(double pixelRatio = 1) {
  CameraView from;
  from.at = {2, 2, 2};
  return {Camera(from), {900, 600}, pixelRatio};
}

template <class MarkKind> MarkKind labelled(MarkKind mark, const std::string &id, const std::string &label) {
  mark.id = id;
  mark.label = label;
  return mark;
}

std::vector<WrittenLabel> textsOf(const SceneContent &content, const View &view = usualView()) {
  return writtenLabels(content, {}, theme(), view);
}

std::vector<LabelAnchor> anchorsFor(const Mark &mark, const View &view = usualView()) {
  SceneContent content;
  content.figure.marks.push_back(mark);
  const auto texts = textsOf(content, view);
  return texts.size() == 1 ? texts.front().anchors : std::vector<LabelAnchor>();
}

glm::dvec2 pixelOf(const Place &place) {
  return glm::dvec2(usualView().camera.project(place, usualView().size).value());
}

ArrowMark arrowFrom(Place from, Place vector) {
  ArrowMark arrow;
  arrow.from = from;
  arrow.vector = vector;
  return arrow;
}

TEST(LabelAnchors, OfASegment_LieAlongItAndPointAwayFromIt) {
  const Place from(0, 0, 0);
  const Place to(0, 6, 3);
  const auto anchors = anchorsFor(labelled(segmentBetween(from, to), "s", "s"));
  ASSERT_GE(anchors.size(), 3U);
  const glm::dvec2 along = glm::normalize(pixelOf(to) - pixelOf(from));
  for (const LabelAnchor &anchor : anchors) {
    EXPECT_LT(distanceToSegment(anchor.pixel, pixelOf(from), pixelOf(to)), 1);
    EXPECT_NEAR(glm::dot(glm::normalize(anchor.toward), along), 0, 1e-9);
    EXPECT_LT(anchor.toward.y, 0) << "above it";
  }
  EXPECT_LT(glm::distance(anchors.front().pixel, pixelOf((from + to) / 2.0)), 1) << "its middle first";
}

TEST(LabelAnchors, OfAnArrow_BeginBeyondItsTip) {
  const auto anchors = anchorsFor(labelled(arrowFrom({0, 0, 0}, {0, 5, 0}), "n", "n"));
  ASSERT_GE(anchors.size(), 2U);
  EXPECT_LT(glm::distance(anchors.front().pixel, pixelOf({0, 5, 0})), 1e-6);
  EXPECT_GT(glm::dot(anchors.front().toward, pixelOf({0, 5, 0}) - pixelOf({0, 0, 0})), 0);
}

TEST(LabelAnchors, OfAPatch_AreItsCornersFromTheHighestDown) {
  const auto anchors = anchorsFor(labelled(patchAt({2, 2, 2}, {1, 2, 2}), "E", "E"));
  ASSERT_EQ(anchors.size(), 4U);
  EXPECT_TRUE(std::is_sorted(anchors.begin(), anchors.end(),
                             [](const auto &a, const auto &b) { return a.pixel.y < b.pixel.y; }));
}

TEST(LabelAnchors, OfAPolygon_AreInItsMiddle) {
  const auto anchors = anchorsFor(labelled(polygonOf({{0, 0, 0}, {6, 0, 0}, {0, 6, 3}}), "T", "T"));
  ASSERT_EQ(anchors.size(), 1U);
  EXPECT_LT(glm::distance(anchors.front().pixel, pixelOf({2, 2, 1})), 1e-6);
  EXPECT_EQ(anchors.front().clearance, 0);
}

TEST(LabelAnchors, OfABall_AreOutsideOfIt) {
  SphereMark sphere;
  sphere.center = {2, 2, 2};
  sphere.radius = 3;
  const auto anchors = anchorsFor(labelled(sphere, "S", "S"));
  ASSERT_FALSE(anchors.empty());
  EXPECT_LT(glm::distance(anchors.front().pixel, pixelOf({2, 2, 5})), 1e-6) << "its top";
}

TEST(LabelAnchors, OfARightAngle_AreInItsCorner) {
  RightAngleMark corner;
  corner.at = {2, 2, 2};
  corner.first = {0, 3, 0};
  corner.second = {0, 0, 3};
  const auto anchors = anchorsFor(labelled(corner, "c", "90"));
  ASSERT_EQ(anchors.size(), 1U);
  const double scale = designScale(usualView().camera, usualView().size, 1);
  EXPECT_LT(glm::distance(anchors.front().pixel, pixelOf(corner.at + Place(0, 0.9, 0.9) * scale)), 1e-6);
}

TEST(LabelAnchors, OfWhatIsBehindTheEyeOrNotFinite_AreNone) {
  const Place behind = usualView().camera.eye() * 2.0;
  EXPECT_TRUE(anchorsFor(labelled(pointAt(behind), "P", "P")).empty());
  EXPECT_TRUE(anchorsFor(labelled(pointAt({0, std::nan(""), 0}), "P", "P")).empty());
}

TEST(LabelAnchors, OnFinerScreens_KeepOffAsFarToTheEye) {
  const PointMark point = labelled(pointAt({2, 2, 2}), "P", "P");
  EXPECT_DOUBLE_EQ(anchorsFor(point, usualView(2)).front().clearance,
                   2 * anchorsFor(point, usualView()).front().clearance);
}

TEST(LabelTexts, OfMarks_HaveTheirLettersNumbersAndInks) {
  SceneContent content;
  PointMark plain = labelled(pointAt({2, 2, 2}), "d", "d");
  plain.numbers = " = 10";
  plain.subject = Subject::Ray;
  PointMark warned = labelled(pointAt({1, 2, 2}), "w", "w");
  warned.role = Role::Warning;
  content.figure.marks = {plain, warned, pointAt({0, 0, 0})};
  const auto texts = textsOf(content);
  ASSERT_EQ(texts.size(), 2U) << "a mark without a label has none";
  EXPECT_EQ(texts[0].latex, "d = 10");
  EXPECT_EQ(texts[0].style.ink, theme().inkOf(Subject::Ray));
  EXPECT_EQ(texts[1].style.ink, theme().warning);
  EXPECT_TRUE(texts[0].isMark && texts[0].stand == LabelStand::Beside);
}

TEST(LabelTexts, OfMarksThatFadeIn_AreAsFar) {
  SceneContent content;
  content.figure.marks = {labelled(pointAt({2, 2, 2}), "P", "P"), labelled(pointAt({1, 2, 2}), "R", "R")};
  content.arrival = {{"P"}, 0.25};
  const auto texts = textsOf(content);
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_DOUBLE_EQ(texts[0].opacity, 0.25);
  EXPECT_DOUBLE_EQ(texts[1].opacity, 1);
}

TEST(LabelTexts, OnFinerScreensAndInLargerType_AreLarger) {
  SceneContent content;
  content.figure.marks = {labelled(pointAt({2, 2, 2}), "P", "P")};
  Theme large = theme();
  large.textScale = 1.5;
  EXPECT_DOUBLE_EQ(writtenLabels(content, {}, large, usualView(2)).front().style.pixelSize, 3 * markTextSize);
}

TEST(LabelTexts, OfADropLine_StandAtTheAxesAndGoAwayWithIt) {
  SceneContent content;
  content.dropLine = DropLine{{5, 3, 4}};
  const auto texts = textsOf(content);
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(texts[0].latex, "5");
  EXPECT_EQ(texts[1].latex, "3");
  EXPECT_LT(glm::distance(texts[1].anchors.front().pixel, pixelOf({0, 3, 0})), 1e-6);
  for (const WrittenLabel &text : texts) {
    EXPECT_EQ(text.style.ink, theme().accent);
    EXPECT_EQ(text.stand, LabelStand::Passing);
  }
  content.stage.middle = {1000, 0, 0}; // the axes lie elsewhere
  EXPECT_TRUE(textsOf(content).empty());
}

TEST(LabelTexts, OfTheGizmo_TellsItsNoteIfItHasOne) {
  SceneContent content;
  content.gizmo.emplace();
  content.gizmo->at = {2, 2, 2};
  EXPECT_TRUE(textsOf(content).empty());
  content.gizmo->note = "z = 7";
  ASSERT_EQ(textsOf(content).size(), 1U);
  EXPECT_EQ(textsOf(content).front().latex, "z = 7");
  EXPECT_FALSE(textsOf(content).front().isMark);
}

TEST(Obstacles, OfAPicture_AreItsPointsKnobsLinesAndAxes) {
  SceneContent content;
  content.figure.marks = {pointAt({2, 2, 2}), segmentBetween({0, 0, 0}, {0, 6, 3})};
  content.knobs.push_back({"k", {1, 1, 1}, {}, Subject::Plane, false});
  const LabelObstacles found = obstaclesOf(content, {}, theme(), usualView());
  ASSERT_EQ(found.discs.size(), 2U);
  EXPECT_LT(glm::distance(found.discs[0].center, pixelOf({2, 2, 2})), 1e-6);
  ASSERT_EQ(found.segments.size(), 1U);
  EXPECT_LT(glm::distance(found.segments[0].to, pixelOf({0, 6, 3})), 1e-6);
  EXPECT_FALSE(found.segments[0].isThick);
  const auto withAxes = obstaclesOf(content, AxesReach(), theme(), usualView()).segments;
  ASSERT_EQ(withAxes.size(), 1U + 3U);
  EXPECT_TRUE(withAxes.back().isThick);
}

TEST(Obstacles, OfAnArrow_AreItsShaftAndItsHead) {
  SceneContent content;
  content.figure.marks = {arrowFrom({0, 0, 0}, {0, 5, 0})};
  const LabelObstacles found = obstaclesOf(content, {}, theme(), usualView());
  ASSERT_EQ(found.segments.size(), 1U);
  EXPECT_TRUE(found.segments[0].isThick);
  ASSERT_EQ(found.discs.size(), 3U) << "at its base, halfway to its tip, and there";
  EXPECT_GT(found.discs[1].radius, found.discs[0].radius);
  EXPECT_GT(glm::distance(found.discs[1].center, pixelOf({0, 5, 0})), found.discs[1].radius);
  EXPECT_LT(glm::distance(found.discs[2].center, pixelOf({0, 5, 0})), 1e-6);
}

TEST(Obstacles, OfAFace_AreAllItsSides) {
  SceneContent content;
  content.figure.marks = {polygonOf({{0, 0, 0}, {6, 0, 0}, {0, 6, 3}})};
  EXPECT_EQ(obstaclesOf(content, {}, theme(), usualView()).segments.size(), 3U);
}

TEST(Obstacles, OfAMesh_AreNone) {
  MeshMark mesh;
  mesh.box = {{0, 0, 0}, {6, 6, 3}};
  SceneContent content;
  content.figure.marks = {mesh};
  const LabelObstacles found = obstaclesOf(content, {}, theme(), usualView());
  EXPECT_TRUE(found.segments.empty());
  EXPECT_TRUE(found.discs.empty());
}

TEST(Obstacles, OfTheHandAndTheWindow_StandApart) {
  SceneContent content;
  content.gizmo.emplace();
  content.gizmo->at = {2, 2, 2};
  View view = usualView();
  view.covered = {{{0, 500}, {420, 600}}};
  const LabelObstacles found = obstaclesOf(content, {}, theme(), view);
  EXPECT_TRUE(found.segments.empty());
  EXPECT_FALSE(found.tools.empty());
  EXPECT_EQ(found.covered, view.covered);
}

TEST(Obstacles, WhatFliesBy_IsNone_AndItsLabelPasses) {
  PointMark flying = labelled(pointAt({2, 2, 2}), "M", "M");
  SceneContent content;
  content.figure.marks = {flying};
  EXPECT_EQ(obstaclesOf(content, {}, theme(), usualView()).discs.size(), 1U);
  EXPECT_EQ(textsOf(content).at(0).stand, LabelStand::Beside);
  flying.passes = true;
  content.figure.marks = {flying};
  EXPECT_TRUE(obstaclesOf(content, {}, theme(), usualView()).discs.empty());
  EXPECT_EQ(textsOf(content).at(0).stand, LabelStand::Passing);
}

TEST(Obstacles, WithAHandleSelected_LeaveAllLabelsWhereTheyAre) {
  const auto placesIn = [](const SceneContent &content) {
    std::vector<LabelRequest> requests;
    for (const WrittenLabel &text : textsOf(content))
      requests.push_back({text.id, {40, 24}, text.anchors, text.stand});
    std::map<std::string, glm::dvec2> places;
    LabelLayout layout;
    for (const PlacedLabel &label :
         layout.place(requests, obstaclesOf(content, {}, theme(), usualView()), usualView().size, 1))
      places[label.id] = label.topLeft;
    return places;
  };
  SceneContent content;
  PointMark point = withId(pointAt({2, 2, 2}), "Q");
  point.label = "Q";
  content.figure.marks = {point};
  const auto before = placesIn(content);
  ASSERT_EQ(before.size(), 1U);
  content.gizmo.emplace();
  content.gizmo->at = {2, 2, 2};
  for (const char *note : {"", "z = 7"}) {
    content.gizmo->note = note;
    // Wherever the note would stand best, the label may stand already.
    for (const Place &at : {Place(2, 2, 2), Place(2, 3, 3), Place(2, 1.5, 3), Place(1, 3, 2)}) {
      content.gizmo->at = at;
      EXPECT_EQ(placesIn(content).at("Q"), before.at("Q"));
    }
  }
}

TEST(Obstacles, OnFinerScreens_AreAsLargeToTheEye) {
  SceneContent content;
  content.figure.marks = {pointAt({2, 2, 2})};
  const auto radius = [&](double ratio) {
    return obstaclesOf(content, {}, theme(), usualView(ratio)).discs.front().radius;
  };
  EXPECT_DOUBLE_EQ(radius(2), 2 * radius(1));
}

} // namespace
} // namespace halfspace
