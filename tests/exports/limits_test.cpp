// What is too much to be drawn exactly is drawn less exactly, in bounded time.
#include "geometry/triangle_mesh.h"
#include "widgets/exports/body_faces.h"
#include "widgets/exports/drawn_lines.h"
#include "widgets/exports/painting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

constexpr double pageWidth = 240;

/// A picture without shapes, seen against the x axis.
ShapeList emptyPicture() {
  ShapeList list;
  list.view = {{}, {1200, 800}, 1};
  list.view.camera.target = {0, 0, 0};
  list.view.camera.azimuth = 0;
  list.view.camera.elevation = 0;
  list.view.camera.height = 12;
  list.depths.nearest = 0.1;
  list.layers.fill(std::make_shared<const std::vector<Shape>>());
  return list;
}

/// A square of half a side, at x.
std::vector<Place> wallAt(double x, double half = 2) {
  return {{x, -half, -half}, {x, half, -half}, {x, half, half}, {x, -half, half}};
}

/// A wall of so many triangles at x, which goes through the wall at 0 where it is turned.
Shape bodyOf(std::size_t count, double x, double turned, const std::string &mark) {
  auto mesh = std::make_shared<TriangleMesh>();
  for (std::size_t i = 0; i < count; ++i) {
    const auto low = static_cast<float>(4.0 * static_cast<double>(i) / static_cast<double>(count) - 2);
    const auto high = static_cast<float>(4.0 * static_cast<double>(i + 1) / static_cast<double>(count) - 2);
    const auto at = [&](float y) { return static_cast<float>(x + turned * y); };
    const auto first = static_cast<std::uint32_t>(mesh->corners.size());
    mesh->corners.insert(mesh->corners.end(), {{at(low), low, -2}, {at(high), high, -2}, {at(low), low, 2}});
    mesh->triangles.push_back({first, first + 1, first + 2});
  }
  BodyShape body;
  body.mesh = mesh;
  return {mark, {90, 90, 90}, body};
}

std::size_t faceCountOf(const std::vector<Shape> &bodies) {
  ShapeList list = emptyPicture();
  list.layer(Layer::Bodies) = std::make_shared<const std::vector<Shape>>(bodies);
  return facesWithBodies(list, Paper(list, pageWidth)).size();
}

TEST(Limits, OfBodiesWithMoreTrianglesThanAreDrawn_EachSoManiethIsLeft) {
  EXPECT_EQ(faceCountOf({bodyOf(mostDrawnTriangles - 1, 0, 0, "body")}), mostDrawnTriangles - 1);
  const std::size_t count = faceCountOf({bodyOf(5 * mostDrawnTriangles, 0, 0, "body")});
  EXPECT_LE(count, mostDrawnTriangles);
  EXPECT_GT(count, mostDrawnTriangles / 2);
}

TEST(Limits, OfMoreTrianglesThanAreOrderedExactly_NoneIsCut_AndTheFartherComeFirst) {
  constexpr std::size_t few = 51; // odd: the triangle in the middle is cut
  EXPECT_GT(faceCountOf({bodyOf(few, 0, 0, "a"), bodyOf(few, 0, 1, "b")}), 2 * few) << "they are cut";
  ShapeList list = emptyPicture();
  list.layer(Layer::Bodies) = std::make_shared<const std::vector<Shape>>(std::vector{
      bodyOf(mostOrderedFaces, 1, 0, "near"), bodyOf(few, -1, 0, "far"), bodyOf(few, 0, 1, "turned")});
  const Paper paper(list, pageWidth);
  const std::vector<Shape> faces = facesWithBodies(list, paper);
  ASSERT_EQ(faces.size(), mostOrderedFaces + 2 * few);
  const auto depthOf = [&](const Shape &face) {
    double depth = 0;
    for (const Place &corner : std::get<FaceShape>(face.form).corners)
      depth += paper.depthOf(corner);
    return depth;
  };
  EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end(),
                             [&](const Shape &a, const Shape &b) { return depthOf(a) > depthOf(b); }));
}

TEST(Limits, WithoutQuestionsLeft_ALineStandsAsideOfAllVeils) {
  const ShapeList list = emptyPicture();
  const Paper paper(list, pageWidth);
  Veils veils(paper);
  veils.add(*FlatVeil::of(wallAt(0), paper));
  const SightedPiece piece{{-1, -1, 0}, {-1, 1, 0}};
  Questions many;
  EXPECT_TRUE(veils.spansOf(piece, many).front().veils.isHidden());
  EXPECT_TRUE(veils.standingOf(piece.from, many).isHidden());
  Questions none(0);
  const std::vector<StandingSpan> spans = veils.spansOf(piece, none);
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_EQ(spans.front().veils, AmongVeils());
  EXPECT_EQ(spans.front().begin, 0);
  EXPECT_EQ(spans.front().end, 1);
  EXPECT_EQ(veils.standingOf(piece.from, none), AmongVeils());
}

TEST(Limits, OfQuestions_AreNoneLeftOnceThereWereTooFew) {
  Questions questions(10);
  EXPECT_TRUE(questions.ask(4));
  EXPECT_TRUE(questions.ask(6));
  EXPECT_TRUE(questions.ask(0));
  EXPECT_FALSE(questions.ask(1));
  Questions others(10);
  EXPECT_FALSE(others.ask(11));
  EXPECT_FALSE(others.ask(1)) << "it would be drawn half in one way and half in the other";
}

/// Things that are painted over one another in two rows of spots, one of which is nearer.
PaintedThing rowAt(double x, std::size_t spots, const std::string &mark, const Paper &paper) {
  PaintedThing thing;
  for (std::size_t i = 0; i < spots; ++i)
    thing.spine.push_back(
        paper.spotOf({x, 4.0 * static_cast<double>(i) / static_cast<double>(spots) - 2, 0.0}));
  thing.reach = 1;
  thing.parts.push_back({{}, {}, Pen{}, mark});
  return thing;
}

std::vector<std::string> orderOf(std::vector<PaintedThing> things, const Paper &paper) {
  std::vector<std::string> marks;
  for (const PathPart &part : inPaintingOrder(Veils(paper), {}, std::move(things)))
    marks.push_back(part.mark);
  return marks;
}

using Marks = std::vector<std::string>;

TEST(Limits, OfLinesWithMorePiecesThanAreCompared_TheOrderStays) {
  const Paper paper(emptyPicture(), pageWidth);
  const auto orderWith = [&](std::size_t spots) {
    return orderOf({rowAt(1, spots, "near", paper), rowAt(-1, spots, "far", paper)}, paper);
  };
  EXPECT_EQ(orderWith(50), (Marks{"far", "near"}));
  const auto tooMany = static_cast<std::size_t>(std::sqrt(static_cast<double>(mostComparedPieces))) + 2;
  EXPECT_EQ(orderWith(tooMany), (Marks{"near", "far"}));
}

TEST(Limits, OfMoreVeilsThanAreComparedWithOneAnother_TheOrderStays) {
  const Paper paper(emptyPicture(), pageWidth);
  const auto changesWith = [&](std::size_t count) {
    Veils veils(paper);
    std::vector<VeilLook> looks;
    for (std::size_t i = 0; i < count; ++i) { // two piles side by side, each of one look
      std::vector<Place> corners = wallAt(0.001 * static_cast<double>(i) - 2, 0.5);
      for (Place &corner : corners)
        corner.y += i % 2 == 0 ? -1 : 1;
      veils.add(*FlatVeil::of(corners, paper));
      looks.push_back({i % 2 == 0 ? "left" : "right", {}});
    }
    const std::vector<PathPart> parts = inPaintingOrder(veils, looks, {});
    std::size_t changes = 0;
    for (std::size_t i = 1; i < parts.size(); ++i)
      if (parts[i].mark != parts[i - 1].mark)
        ++changes;
    return changes;
  };
  EXPECT_EQ(changesWith(100), 1U) << "first one pile, then the other";
  EXPECT_EQ(changesWith(mostComparedVeils + 2), mostComparedVeils + 1) << "as they came";
}

TEST(Limits, OfDashes_RoundsAreNoMoreThanCanBeToldApart) {
  const Rhythm few = fittedTo(9, {1, 1});
  EXPECT_DOUBLE_EQ(few.front(), 1) << "five dashes, four gaps";
  const double length = 1e6;
  const Rhythm many = fittedTo(length, {1, 1});
  EXPECT_DOUBLE_EQ(many.front(), length / (2 * mostRounds - 1));
}

} // namespace
} // namespace halfspace
