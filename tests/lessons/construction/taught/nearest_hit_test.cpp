// What is said of a ray that lies in the plane of one of many triangles.
#include "lessons/object/kinds/mesh.h"
#include "lessons/object/kinds/number.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <memory>

namespace halfspace {
namespace {

using namespace test;

/// A triangle in the plane z = 0, and a wall across the x-axis at x = 10.
MeshObject floorAndWall() {
  MeshObject mesh;
  mesh.shape = std::make_shared<const MeshShape>(
      std::vector<Vec3<double>>{{2, 0, 0}, {6, 0, 0}, {4, 2, 0}, {10, -5, -5}, {10, 5, -5}, {10, 0, 5}},
      std::vector<MeshFace>{{0, 1, 2}, {3, 4, 5}});
  return mesh;
}

std::string toldOf(const MeshObject &mesh, const ExactVec3 &from, const ExactVec3 &direction) {
  const Construction &construction = *findConstruction("nearest-hit");
  return lastOutcome(evaluate(sceneOf(construction, {RayObject{from, direction}, NumberObject{1}, mesh})))
      .told->description;
}

std::string toldOf(const ExactVec3 &from, const ExactVec3 &direction) {
  return toldOf(floorAndWall(), from, direction);
}

TEST(NearestHit, OfARayAlongATriangle_SaysSo) {
  EXPECT_EQ(toldOf({4, 6, 0}, {0, -1, 0}),
            "The ray runs along meshes₀ 1, in its plane: it hits no triangle at a single point.");
}

TEST(NearestHit, OfARayThatTouchesACornerWithinThePlane_SaysThatItOnlyTouches) {
  EXPECT_EQ(toldOf({4, 2, 0}, {0, 1, 0}),
            "The ray touches meshes₀ 1 at one point, within its plane, and that "
            "does not count as a hit. It hits no triangle.");
}

TEST(NearestHit, BehindATriangleThatTheRayRunsAlong_TellsOfBoth) {
  const std::string told = toldOf({0, 1, 0}, {1, 0, 0});
  EXPECT_NE(told.find("hits meshes₀ 2 first"), std::string::npos) << told;
  EXPECT_NE(told.find("Before, it runs along meshes₀ 1"), std::string::npos) << told;
}

TEST(NearestHit, BehindACornerThatTheRayTouchesWithinThePlane_TellsOfBoth) {
  const std::string told = toldOf({0, 2, 0}, {1, 0, 0});
  EXPECT_NE(told.find("Before, it touches meshes₀ 1 within its plane"), std::string::npos) << told;
}

/// So many triangles like the floor, one above the other.
MeshObject floors(std::uint32_t count) {
  std::vector<Vec3<double>> corners;
  std::vector<MeshFace> faces;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double z = i;
    corners.insert(corners.end(), {{2, 0, z}, {6, 0, z}, {4, 2, z}});
    faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  MeshObject mesh;
  mesh.shape = std::make_shared<const MeshShape>(std::move(corners), std::move(faces));
  return mesh;
}

TEST(NearestHit, AlongOneOfAsManyTrianglesAsAreListed_SaysSo) {
  const std::string told = toldOf(floors(128), {0, 1, 0}, {1, 0, 0});
  EXPECT_NE(told.find("runs along meshes₀ 1"), std::string::npos) << told;
}

TEST(NearestHit, AlongOneOfMoreTriangles_SaysThatItIsNotLookedAt) {
  const std::string told =
      toldOf(floors(129), {0, 1, 1}, {1, 0, 0}); // the first one is looked at by its number
  EXPECT_EQ(told.find("meets nothing"), std::string::npos) << told;
  EXPECT_NE(told.find("not looked at: there are more than 128 triangles"), std::string::npos) << told;
}

TEST(NearestHit, OfATriangleThatTheRaysLineAloneRunsAlong_TellsNothing) {
  EXPECT_EQ(toldOf({8, 1, 0}, {1, 0, 0}).find("Before"), std::string::npos);
  EXPECT_EQ(toldOf({8, 6, 0}, {0, 1, 0}), "No triangle has a hit with λ ≥ 0: the ray meets nothing.");
}

} // namespace
} // namespace halfspace
