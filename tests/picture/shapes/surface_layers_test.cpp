#include "widgets/picture/shapes/surface_layers.h"

#include "lessons/lesson/lesson.h"
#include "lessons/scene/evaluation.h"
#include "tests/picture/marks.h"
#include "widgets/picture/stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace halfspace {
namespace {

/// Upright, looking along x, 2 units wide and high.
PolygonMark wallAt(Place middle, double halfSide = 1) {
  const auto corner = [&](double y, double z) { return middle + halfSide * Place(0, y, z); };
  return polygonOf({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
}

SphereMark ballAt(Place center) {
  SphereMark ball;
  ball.center = center;
  ball.radius = 1;
  return ball;
}

/// So many marks, each made for its number.
template <class Make> Figure figureOf(int count, const Make &make) {
  Figure figure;
  for (int i = 0; i < count; ++i)
    figure.add(withId(make(i), "mark" + std::to_string(i)));
  return figure;
}

TEST(FaceLayers, OfAStack_AreAllOfIt) {
  EXPECT_EQ(faceLayersOf(figureOf(300, [](int i) { return wallAt({0.1 * i, 0, 0}); })), 300U);
  EXPECT_EQ(faceLayersOf(figureOf(300, [](int) { return wallAt({0, 0, 0}); })), 300U);
  EXPECT_EQ(faceLayersOf(figureOf(300, [](int i) { return patchAt({0, 0, 0.1 * i}, {0, 0, 1}); })), 300U);
}

TEST(FaceLayers, OfARowWhoseFacesAreNotTurnedToEachOther_AreAllOfIt) {
  EXPECT_EQ(faceLayersOf(figureOf(300, [](int i) { return wallAt({3.0 * i, 3.0 * i, 0}); })), 300U);
}

TEST(FaceLayers, OfBalls_AreTwoEach) {
  EXPECT_EQ(faceLayersOf(figureOf(50, [](int i) { return ballAt({i, 2 * i, 0}); })), 100U);
}

TEST(FaceLayers, OfTilesInATiltedPlane_AreNotCountedOneBehindAnother) {
  const Place right(0.6, 0.7, 0.1);
  const Place up(-0.3, 0.2, 0.9);
  EXPECT_EQ(faceLayersOf(figureOf(400,
                                  [&](int i) {
                                    const Place low = right * (i % 20 / 3.0) + up * (i / 20 / 3.0);
                                    return polygonOf({low, low + right * 0.3, low + up * 0.3});
                                  })),
            1U);
}

TEST(FaceLayers, OfALargeStackAmongVerySmallFaces_AreFound) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-100, 100);
  const Figure figure = figureOf(3000, [&](int i) {
    return i % 30 == 1 ? wallAt({0.1 * i, 0, 0}, 5)
                       : wallAt({anywhere(random), anywhere(random), anywhere(random)}, 0.1);
  });
  EXPECT_GE(faceLayersOf(figure), 100U);
  EXPECT_LE(faceLayersOf(figure), 110U);
}

/// A ball of flat triangles.
TriangleMesh ballMesh(std::uint32_t meridians, std::uint32_t parallels) {
  TriangleMesh mesh;
  for (std::uint32_t row = 0; row <= parallels; ++row)
    for (std::uint32_t column = 0; column < meridians; ++column) {
      const double up = std::numbers::pi * row / parallels;
      const double around = 2 * std::numbers::pi * column / meridians;
      mesh.corners.push_back(
          {std::sin(up) * std::cos(around), std::sin(up) * std::sin(around), std::cos(up)});
      const std::uint32_t here = row * meridians + column;
      const std::uint32_t next = row * meridians + (column + 1) % meridians;
      if (row < parallels)
        mesh.triangles.insert(mesh.triangles.end(),
                              {{here, next, here + meridians}, {next, next + meridians, here + meridians}});
    }
  return mesh;
}

TriangleMesh randomTriangles(std::uint32_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(0, 1);
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 3 * count; ++i)
    mesh.corners.push_back({anywhere(random), anywhere(random), anywhere(random)});
  for (std::uint32_t i = 0; i < count; ++i)
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return mesh;
}

TEST(MeshLayers, OfABall_AreTwo_HoweverFineItIs) {
  EXPECT_EQ(meshLayersOf(ballMesh(30, 15)), 2U);
  EXPECT_EQ(meshLayersOf(ballMesh(1000, 500)), 2U);
}

TEST(MeshLayers, OfRandomTriangles_GrowWithTheirNumber) {
  const std::size_t some = meshLayersOf(randomTriangles(1000));
  const std::size_t many = meshLayersOf(randomTriangles(100'000));
  EXPECT_GT(some, mostMeshLayers);
  EXPECT_NEAR(static_cast<double>(many) / static_cast<double>(some), 100, 40);
}

TEST(MeshLayers, OfTrianglesWithoutArea_AreNone) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {}};
  mesh.triangles.assign(200, {0, 1, 2});
  EXPECT_EQ(meshLayersOf(mesh), 0U);
}

TEST(MeshStride, IsTheLeastPowerOfTwo_ThatLeavesNotTooManyLayers) {
  EXPECT_EQ(strideFor(0), 1U);
  EXPECT_EQ(strideFor(mostMeshLayers), 1U);
  EXPECT_EQ(strideFor(mostMeshLayers + 1), 2U);
  EXPECT_EQ(strideFor(2 * mostMeshLayers + 1), 4U);
  EXPECT_EQ(strideFor(1000 * mostMeshLayers), 1024U);
}

std::vector<std::string> idsLeft(const Figure &figure, const std::set<std::string> &highlighted = {}) {
  std::vector<std::string> ids;
  for (const Mark &mark : thinned(figure, highlighted).value_or(figure).marks)
    ids.push_back(baseOf(mark).id);
  return ids;
}

TEST(ThinnedFigure, OfAStack_HasEveryOtherFace_ThoseThatStandOut_AndAllElse) {
  Figure figure = figureOf(41, [](int i) { return wallAt({i, 0, 0}); });
  figure.marks.insert(1, withId(pointAt({0, 0, 0}), "point"));
  const std::vector<std::string> ids = idsLeft(figure, {"mark0", "mark3"});
  EXPECT_EQ(ids.size(), 23U);
  EXPECT_EQ(std::vector(ids.begin(), ids.begin() + 5),
            (std::vector<std::string>{"mark0", "point", "mark2", "mark3", "mark4"}));
}

TEST(ThinnedFigure, LosesOnlyFacesThatLieOneBehindAnother) {
  const auto wallsAndTiles = [](int i) { return i % 2 == 0 ? wallAt({i, 0, 0}) : wallAt({0, 5.0 * i, 0}); };
  const std::vector<std::string> ids = idsLeft(figureOf(82, wallsAndTiles));
  EXPECT_EQ(ids.size(), 21U + 41U);
  for (int i = 1; i < 82; i += 2)
    EXPECT_EQ(std::count(ids.begin(), ids.end(), "mark" + std::to_string(i)), 1) << i;
}

TEST(ThinnedFigure, OfStacksInTurn_HasAsManyOfEach) {
  const auto stacks = [](int i) { return wallAt({i / 10, 5.0 * (i % 10), 0}); };
  std::map<int, int> left;
  for (const std::string &id : idsLeft(figureOf(410, stacks)))
    ++left[std::stoi(id.substr(4)) % 10];
  for (int stack = 0; stack < 10; ++stack)
    EXPECT_EQ(left[stack], 21) << stack;
}

TEST(ThinnedFigure, OfFacesInDisorder_HasNoMoreLayersThanAreDrawn) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  const auto corner = [&] { return Place(anywhere(random), anywhere(random), anywhere(random)); };
  const Figure figure = figureOf(1000, [&](int) { return polygonOf({corner(), corner(), corner()}); });
  ASSERT_GT(faceLayersOf(figure), mostFaceLayers);
  EXPECT_LE(faceLayersOf(thinned(figure, {}).value()), mostFaceLayers);
}

TEST(ThinnedFigure, IsThereWhereThereAreMoreLayersThanAreDrawn) {
  const auto walls = [](int i) { return wallAt({i, 0, 0}); };
  EXPECT_FALSE(thinned(figureOf(40, walls), {}));
  EXPECT_TRUE(thinned(figureOf(41, walls), {}));
}

TEST(SurfaceLayers, OfLessons_AreNoMoreThanAreDrawn) {
  const LessonLibrary library = readLessons(LESSON_FOLDER);
  ASSERT_FALSE(library.lessons.empty());
  for (const Lesson &lesson : library.lessons) {
    const Evaluation evaluation = evaluate(lesson.scene);
    const Figure figure =
        toStage(figureOf(evaluation), stageOf(lesson.scene, boundObjectsOf(lesson.scene, evaluation)));
    EXPECT_LE(faceLayersOf(figure), mostFaceLayers) << lesson.id;
    for (const Mark &mark : figure.marks)
      if (const auto *body = std::get_if<MeshMark>(&mark)) {
        EXPECT_LE(meshLayersOf(*body->mesh), mostMeshLayers) << lesson.id;
      }
    RecordProperty(lesson.id, std::to_string(faceLayersOf(figure)));
  }
}

} // namespace
} // namespace halfspace
