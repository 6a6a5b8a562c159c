// How the role of a mark, and what is done with it, show in lines and faces.
#include "tests/picture/marks.h"
#include "tests/picture/shapes/solid_mesh.h"
#include "widgets/picture/shapes/ball_sizes.h"
#include "widgets/picture/shapes/translucent_faces.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace halfspace {
namespace {

const Theme &theme() { return themes().front(); }

/// A segment along z.
SegmentMark segmentOf(Role role) {
  SegmentMark segment = withId(segmentBetween({0, 0, 0}, {0, 0, 8}), "s", Subject::Plane);
  segment.role = role;
  return segment;
}

Mesh meshOfMark(const Mark &mark, double scale = 1) { return solidMesh({{mark}}, {}, theme(), scale); }

double thicknessOf(const Mesh &mesh) {
  double most = 0;
  for (const glm::vec3 &position : mesh.positions)
    most = std::max<double>(most, position.x);
  return 2 * most;
}

/// How much of a line along z is there between its gaps.
double partDrawn(const Mesh &mesh, double length) {
  std::set<double> ends;
  for (const glm::vec3 &position : mesh.positions)
    ends.insert(std::round(double(position.z) * 1e4) / 1e4);
  double drawn = 0;
  for (auto end = ends.begin(); end != ends.end() && std::next(end) != ends.end(); std::advance(end, 2))
    drawn += *std::next(end) - *end;
  return drawn / length;
}

std::vector<Face> facesOfMark(const Mark &mark, const std::set<std::string> &highlighted = {}) {
  return facesOf({{mark}}, highlighted, theme());
}

PolygonMark triangle(Role role = Role::Given) {
  PolygonMark mark = withId(polygonOf({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}), "T", Subject::Triangle);
  mark.role = role;
  return mark;
}

double areaOf(const Face &face) {
  Place area(0);
  for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
    area += glm::cross(face.corners[i] - face.corners[0], face.corners[i + 1] - face.corners[0]) / 2.0;
  return glm::length(area);
}

TEST(Lines, OfHelpersAndGhosts_AreDashedAndOthersAreNot) {
  for (const Role role : {Role::Given, Role::Derived, Role::Result, Role::Warning})
    EXPECT_DOUBLE_EQ(partDrawn(meshOfMark(segmentOf(role)), 8), 1);
  for (const Role role : {Role::Helper, Role::Ghost}) {
    EXPECT_LT(partDrawn(meshOfMark(segmentOf(role)), 8), 0.7);
    EXPECT_GT(partDrawn(meshOfMark(segmentOf(role)), 8), 0.5);
  }
}

TEST(Lines, OfFurtherObjects_AreInLongDashes_EachInItsOwn) {
  std::set<double> parts;
  for (const std::size_t rank : {0U, 1U, 2U, 3U}) {
    SegmentMark line = segmentOf(Role::Given);
    line.look.rank = rank;
    const double part = partDrawn(meshOfMark(line), 8);
    EXPECT_GT(part, partDrawn(meshOfMark(segmentOf(Role::Helper)), 8)) << rank;
    parts.insert(part);
  }
  EXPECT_EQ(parts.size(), 4U);
}

TEST(Lines, InAChosenStyle_AreDrawnInIt_WhateverTheirRank) {
  SegmentMark line = segmentOf(Role::Given);
  line.look.rank = 2;
  std::set<Rhythm> rhythms{rhythmOf(line, 1), rhythmOf(segmentOf(Role::Helper), 1)};
  for (const LineStyle style : {LineStyle::Dashed, LineStyle::Dotted}) {
    line.look.line = style;
    rhythms.insert(rhythmOf(line, 1));
  }
  EXPECT_EQ(rhythms.size(), 4U);
  line.look.line = LineStyle::Solid;
  EXPECT_TRUE(rhythmOf(line, 1).empty());
}

TEST(Lines, OfAHelperOfAFurtherObject_AreDashedAsThoseOfHelpers) {
  SegmentMark line = segmentOf(Role::Helper);
  line.look.rank = 2;
  EXPECT_EQ(rhythmOf(line, 1), rhythmOf(segmentOf(Role::Helper), 1));
}

TEST(Lines, InALook_HaveItsHue_AndSoHasTheFaceOfAPatch) {
  PlanePatchMark patch = withId(patchAt({0, 0, 0}, {0, 0, 1}), "F", Subject::Plane);
  patch.look.hue = Hue::Green;
  EXPECT_EQ(solidColor(patch, theme(), false), theme().colorOf(Hue::Green));
  EXPECT_EQ(facesOfMark(patch).front().color, theme().colorOf(Hue::Green));
}

TEST(Lines, OfWhatIsGiven_AreThickerThanThoseOfHelpers) {
  const auto thickness = [](Role role) { return thicknessOf(meshOfMark(segmentOf(role))); };
  EXPECT_GT(thickness(Role::Given), thickness(Role::Derived));
  EXPECT_GT(thickness(Role::Derived), thickness(Role::Helper));
  EXPECT_EQ(thickness(Role::Result), thickness(Role::Given));
}

ArrowMark upArrow(const std::string &id, double length) {
  ArrowMark arrow = withId(ArrowMark{}, id);
  arrow.vector = {0, 0, length};
  return arrow;
}

/// The distances from the z axis at a height, in tenths of thousandths.
std::set<long> radiiAt(const Mesh &mesh, double height) {
  std::set<long> radii;
  for (const glm::vec3 &position : mesh.positions)
    if (std::abs(position.z - height) < 1e-4)
      radii.insert(std::lround(1e4 * std::hypot(position.x, position.y)));
  radii.erase(0); // the middles of caps
  return radii;
}

/// The largest distance from the z axis at a height.
double thicknessAt(const Mesh &mesh, double height) {
  return static_cast<double>(*radiiAt(mesh, height).rbegin()) / 1e4;
}

TEST(Arrows, ThatLieInOthers_AreThicker_SoThatBothAreSeen) {
  const Figure both{{upArrow("v", 8), upArrow("w", 3)}};
  const double alone = thicknessAt(solidMesh({{upArrow("w", 3)}}, {}, theme(), 1), 0);
  EXPECT_GT(thicknessAt(solidMesh(both, {}, theme(), 1), 0), 1.5 * alone);
  const Figure opposite{{upArrow("v", 8), upArrow("w", -3)}};
  EXPECT_DOUBLE_EQ(thicknessAt(solidMesh(opposite, {}, theme(), 1), 0), alone);
}

TEST(Arrows, ThatAreTheSameToTheEye_AreAroundEachOther_SoThatTheyDoNotFlicker) {
  const double aHair = 1e-12; // as a unit vector is rounded
  for (const Role one : {Role::Given, Role::Derived, Role::Helper, Role::Result})
    for (const Role other : {Role::Given, Role::Derived, Role::Helper, Role::Result})
      for (const std::size_t rank : {0U, 1U})
        for (const double length : {8.0, 8 + aHair, 8 - aHair}) {
          ArrowMark v = upArrow("v", 8);
          ArrowMark w = upArrow("w", length);
          v.role = one;
          w.role = other;
          w.look.rank = rank;
          const std::set<long> radii = radiiAt(solidMesh({{v, w}}, {}, theme(), 1), 0);
          ASSERT_EQ(radii.size(), 2U);
          EXPECT_GT(*radii.rbegin() - *radii.begin(), 40);
        }
}

TEST(Arrows, ThatAreTheSameToTheEye_HaveATipEach_HoweverShortAndHoweverMany) {
  for (const std::size_t count : {2U, 3U, 4U}) {
    Figure figure;
    for (std::size_t i = 0; i < count; ++i)
      figure.marks.push_back(upArrow("v" + std::to_string(i), 1));
    std::set<long> tips; // in hundredths
    for (const glm::vec3 &position : solidMesh(figure, {}, theme(), 1).positions)
      if (position.x == 0 && position.y == 0 && position.z > 0.8)
        tips.insert(std::lround(100 * position.z));
    EXPECT_EQ(tips.size(), count);
  }
}

TEST(Arrows, ThatAreDashed_AreAroundWholeOnesThatAreTheSame) {
  ArrowMark dashed = upArrow("a", 8);
  dashed.look = {.hue = Hue::Orange, .rank = 1};
  ArrowMark whole = upArrow("b", 8);
  whole.look = {.hue = Hue::Blue};
  const Mesh mesh = solidMesh({{dashed, whole}}, {}, theme(), 1);
  const auto ofColor = [&](Hue hue) {
    Mesh part;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      if (mesh.colors[i] == theme().colorOf(hue))
        part.positions.push_back(mesh.positions[i]);
    return part;
  };
  EXPECT_GT(thicknessAt(ofColor(Hue::Orange), 0), thicknessAt(ofColor(Hue::Blue), 0));
  const auto tipOf = [&](Hue hue) {
    double highest = 0;
    for (const glm::vec3 &position : ofColor(hue).positions)
      highest = std::max<double>(highest, position.z);
    return highest;
  };
  EXPECT_NEAR(tipOf(Hue::Orange), 8, 1e-6);
  EXPECT_LT(tipOf(Hue::Blue), 7.9) << "heads with one tip would be in one cone";
}

TEST(Lines, SeenFromFartherAway_AreThickerInTheScene) {
  EXPECT_NEAR(thicknessOf(meshOfMark(segmentOf(Role::Given), 3)),
              3 * thicknessOf(meshOfMark(segmentOf(Role::Given))), 1e-6);
}

TEST(Lines, OfGhosts_ArePaler) {
  const Color ghost = meshOfMark(segmentOf(Role::Ghost)).colors.front();
  EXPECT_NE(ghost, theme().colorOf(Subject::Plane));
  EXPECT_EQ(meshOfMark(segmentOf(Role::Helper)).colors.front(), theme().colorOf(Subject::Plane));
  const auto brightness = [](Color color) { return color.red + color.green + color.blue; };
  EXPECT_GT(brightness(ghost), brightness(theme().colorOf(Subject::Plane))) << "on a light background";
}

TEST(Lines, ThatGoOn_FadeWhereTheirDrawingEnds) {
  for (const std::size_t rank : {0U, 1U}) {
    LineMark line = withId(LineMark{}, "g", Subject::Plane);
    line.direction = {1, 0, 0};
    line.look.rank = rank;
    const auto [low, high] = endsOf(line);
    const Mesh mesh = meshOfMark(line);
    const Color full = theme().colorOf(Subject::Plane);
    int atEnds = 0;
    int between = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const double toEnd = std::min(mesh.positions[i].x - low.x, high.x - mesh.positions[i].x);
      if (toEnd < 0.1) {
        ++atEnds;
        EXPECT_GT(mesh.colors[i].red, (full.red + 255) / 2);
      } else if (toEnd > 2.999) { // a solid line has no corners farther from its ends
        ++between;
        EXPECT_EQ(mesh.colors[i], full);
      }
    }
    EXPECT_GT(atEnds, 0);
    EXPECT_GT(between, 0);
  }
}

TEST(Lines, OfAPatch_ArePalerThanItsNormal_ButNotWhereItWarns) {
  PlanePatchMark patch = withId(patchAt({0, 0, 0}, {0, 0, 1}), "E", Subject::Plane);
  EXPECT_NE(meshOfMark(patch).colors.front(), theme().colorOf(Subject::Plane));
  patch.role = Role::Warning;
  EXPECT_EQ(meshOfMark(patch).colors.front(), theme().warning);
}

TEST(Lines, OfADashedBorder_CloseAroundTheFace) {
  const Mesh mesh = meshOfMark(triangle(Role::Ghost));
  double nearest = 1e9;
  for (const glm::vec3 &position : mesh.positions) // the side from the last corner to the first
    nearest = std::min(nearest, glm::distance(Place(position), Place(0, 1, 0)));
  EXPECT_LT(nearest, 0.6);
}

TEST(Points, ThatAreFreeToMove_AreTheThickest) {
  PointMark point = withId(pointAt({0, 0, 0}), "Q", Subject::Point);
  EXPECT_EQ(ballRadius(point), freePointRadius);
  point.role = Role::Derived;
  EXPECT_LT(ballRadius(point), freePointRadius);
  point = withId(pointAt({0, 0, 0}), "P0", Subject::Plane);
  EXPECT_LT(ballRadius(point), freePointRadius);
}

/// The largest distance of a ball's surface from the middle of it, the origin, on a square of some width.
double ballOnSquare(double width, double scale) {
  const double half = width / 2;
  PolygonMark square =
      withId(polygonOf({{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}}), "S/1",
             Subject::Neutral);
  PointMark point = withId(pointAt({0, 0, 0}), "Q", Subject::Point);
  return BallSizes({{square, point}}).radiusOf(point, scale);
}

TEST(Points, OnASurface_TakeNoMoreThanAPartOfIt) {
  EXPECT_EQ(ballOnSquare(8, 1), freePointRadius) << "there is room";
  EXPECT_EQ(ballOnSquare(8, 2), 2 * freePointRadius);
  EXPECT_LT(ballOnSquare(4, 2), 0.13 * 4);
  EXPECT_EQ(ballOnSquare(4, 3), ballOnSquare(4, 2)) << "the surface does not grow with the type";
  EXPECT_GT(ballOnSquare(0.1, 2), 2 * arrowRadius) << "they are still seen on lines";
}

TEST(Points, BesideASurface_AreAsLargeAsAlways) {
  const PolygonMark small = withId(polygonOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), "S", Subject::Neutral);
  const PointMark point = withId(pointAt({2, 2, 0}), "Q", Subject::Point);
  EXPECT_EQ(BallSizes({{small, point}}).radiusOf(point, 3), 3 * freePointRadius);
}

TEST(Points, InTheBoxAroundASlantedSurface_AreSmallOnlyNearIt) {
  const PolygonMark slanted = withId(polygonOf({{0, 0, 0}, {2, 0, 2}, {0, 2, 2}}), "S", Subject::Neutral);
  const auto radiusAt = [&](Place at) {
    const PointMark point = withId(pointAt(at), "Q", Subject::Point);
    return BallSizes({{slanted, point}}).radiusOf(point, 3);
  };
  EXPECT_EQ(radiusAt({1.9, 1.9, 0.1}), 3 * freePointRadius);
  const double onIt = radiusAt({0.5, 0.5, 1});
  EXPECT_LT(onIt, 2 * freePointRadius);
  EXPECT_NEAR(radiusAt({0.5, 0.5, 1.01}), onIt, 0.02) << "it does not jump";
}

TEST(Faces, OfPatches_LieUnderThoseOfPolygons) {
  const auto faces =
      facesOf({{triangle(), withId(patchAt({0, 0, 0}, {0, 0, 1}), "E", Subject::Plane)}}, {}, theme());
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_EQ(faces[0].color, theme().planeFace);
  EXPECT_EQ(faces[1].color, theme().colorOf(Subject::Triangle));
}

TEST(Faces, OfMarksWithoutAny_AreNone) {
  EXPECT_TRUE(facesOfMark(segmentOf(Role::Given)).empty());
  EXPECT_TRUE(facesOfMark(withId(pointAt({0, 0, 0}), "Q")).empty());
}

TEST(Faces, OfRolesAndHighlights_AreMoreOrLessDense) {
  const double usual = facesOfMark(triangle()).front().opacity;
  EXPECT_DOUBLE_EQ(usual, theme().polygonOpacity);
  EXPECT_LT(facesOfMark(triangle(Role::Ghost)).front().opacity, 0.5 * usual);
  EXPECT_GT(facesOfMark(triangle(), {"T"}).front().opacity, usual);
  EXPECT_EQ(facesOfMark(triangle(Role::Warning)).front().color, theme().warning);
}

TEST(Faces, OfWhatArrives_BecomeAsDenseAsItIsThere) {
  const auto opacity = [](double presence) {
    return facesOf({{triangle()}}, {}, theme(), {{"T"}, presence}).front().opacity;
  };
  EXPECT_EQ(opacity(0), 0);
  EXPECT_DOUBLE_EQ(opacity(0.5), 0.5 * opacity(1));
  EXPECT_DOUBLE_EQ(facesOf({{triangle()}}, {}, theme(), {{"other"}, 0.5}).front().opacity, opacity(1));
}

TEST(Faces, OfABall_CoverItsSurfaceOnce) {
  SphereMark sphere = withId(SphereMark(), "S", Subject::Triangle);
  sphere.center = {1, 2, 3};
  sphere.radius = 2;
  double area = 0;
  double low = 3;
  double high = 3;
  for (const Face &face : facesOfMark(sphere)) {
    area += areaOf(face);
    for (const Place &corner : face.corners) {
      EXPECT_NEAR(glm::distance(corner, sphere.center), 2, 1e-9);
      low = std::min(low, corner.z);
      high = std::max(high, corner.z);
    }
    EXPECT_GE(face.corners.size(), 3U);
    EXPECT_DOUBLE_EQ(face.opacity, theme().polygonOpacity / 2) << "it is looked through twice";
  }
  EXPECT_NEAR(low, 1, 1e-9);
  EXPECT_NEAR(high, 5, 1e-9);
  EXPECT_NEAR(area, 4 * std::numbers::pi * 4, 0.05 * 4 * std::numbers::pi * 4);
}

} // namespace
} // namespace halfspace
