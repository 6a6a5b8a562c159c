// Meshes: what files say of them, where they stand, and what they share.
#include "lessons/object/kinds/mesh.h"
#include "lessons/scene/file/shape_text.h"

#include "geometry/decide.h"
#include "geometry/intersect_ray_triangle.h"
#include "lessons/lesson/lesson.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/scene/file/large_meshes.h"
#include "lessons/scene/file/session_file.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace halfspace {
namespace {

using namespace test;

constexpr const char *square = "0 0 0, 4 0 0, 4 4 0, 0 4 0";

// --- as files have it

Problem problemWith(const std::string &corners, const std::string &faces) {
  const auto shape = readShape(corners, faces);
  if (shape)
    throw std::invalid_argument("it was read: " + corners + "; " + faces);
  return shape.problem();
}

void expectRefused(const std::string &corners, const std::string &faces, const std::string &field,
                   const std::string &sentence) {
  const Problem problem = problemWith(corners, faces);
  EXPECT_EQ(problem.field, field) << corners << "; " << faces;
  EXPECT_NE(problem.sentence.find(sentence), std::string::npos) << problem.sentence;
}

TEST(MeshShape, CornersOfNoMesh_AreRefusedWithTheReason) {
  expectRefused("", "0 1 2", "corners", "no corners");
  expectRefused("0 0, 4 0 0", "0 1 2", "corners", "“0 0” is no corner");
  expectRefused("0 0 0 0", "0 1 2", "corners", "“0 0 0 0” is no corner");
  expectRefused(", 0 0 0", "0 1 2", "corners", "“” is no corner");
  expectRefused("0 0 x", "0 1 2", "corners", "“x” is not a number");
  expectRefused("0 0 1/0", "0 1 2", "corners", "“1/0” is not a number");
  expectRefused("0 0 nan", "0 1 2", "corners", "“nan” is not a number");
  expectRefused("0 0 inf", "0 1 2", "corners", "“inf” is not a number");
  expectRefused("0 0 0.1", "0 1 2", "corners", "0.1 cannot be a coordinate of a corner");
  expectRefused("0 0 1/3", "0 1 2", "corners", "1/3 cannot be a coordinate of a corner");
  expectRefused("0 0 1000000001", "0 1 2", "corners", "too large");
  expectRefused("0 0 1e999999999", "0 1 2", "corners", "1e999999999");
  expectRefused("0 0 " + std::string(5000, '9'), "0 1 2", "corners", "999");
}

TEST(MeshShape, FacesOfNoMesh_AreRefusedWithTheReason) {
  expectRefused(square, "", "faces", "no faces");
  expectRefused(square, "0 1", "faces", "“0 1” is no flat, convex face");
  expectRefused(square, "0 1 2, , 0 2 3", "faces", "“” is no flat, convex face");
  expectRefused(square, "0 1 4", "faces", "“4” is not the number of a corner: they are counted from 0 to 3");
  expectRefused(square, "0 1 -1", "faces", "“-1” is not the number of a corner");
  expectRefused(square, "0 1 2.0", "faces", "“2.0” is not the number of a corner");
  expectRefused(square, "0 1 4294967298", "faces", "“4294967298” is not the number of a corner");
  expectRefused(square, "0 2 1 3", "faces", "no flat, convex face");
  expectRefused("0 0 0, 4 0 0, 4 4 1, 0 4 0", "0 1 2 3", "faces", "no flat, convex face");
  expectRefused("0 0 0, 4 0 0, 1 1 0, 0 4 0", "0 1 2 3", "faces", "no flat, convex face");
}

TEST(MeshShape, ManyFacesOrCorners_AreReadUpToTheLimits) {
  const auto facesOf = [](std::size_t count) {
    std::string faces = "0 1 2";
    for (std::size_t i = 1; i < count; ++i)
      faces += ",0 1 2";
    return faces;
  };
  EXPECT_TRUE(readShape(square, facesOf(mostWrittenTriangles)));
  expectRefused(square, facesOf(mostWrittenTriangles + 1), "faces", "too many faces: at most 50000");
  std::string manyCorners = "0 0 0";
  for (std::size_t i = 0; i < 3 * mostWrittenTriangles; ++i)
    manyCorners += ",0 0 0";
  expectRefused(manyCorners, "0 1 2", "corners", "too many corners: at most 150000");
  // Around a bowl: flat and convex, however many.
  const auto bowl = [](std::size_t count) {
    std::string corners;
    std::string face;
    for (std::size_t i = 0; i < count; ++i) {
      corners += (i > 0 ? ", " : "") + std::to_string(i) + " " + std::to_string(i * i) + " 0";
      face += " " + std::to_string(i);
    }
    return std::pair(corners, face);
  };
  const auto [corners, face] = bowl(mostFaceCorners);
  EXPECT_EQ((*readShape(corners, face))->triangleCount(), mostFaceCorners - 2);
  const auto [moreCorners, largerFace] = bowl(mostFaceCorners + 1);
  expectRefused(moreCorners, largerFace, "faces", "of three to 32 corners");
}

TEST(MeshShape, FlatFaces_AreCutIntoTrianglesFromTheirFirstCorner) {
  const auto shape = *readShape("0 0 0, 4 0 0.5, 4 4 0.5, 0 4 0, -1/4 1e1 2", "0 1 2 3, 3\n4 0");
  EXPECT_EQ(shape->mesh()->triangles,
            (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {3, 4, 0}}));
  EXPECT_EQ(shape->faces(), (std::vector<MeshFace>{{0, 1, 2, 3}, {3, 4, 0}}));
  EXPECT_EQ(shape->box().low, Vec3<double>(-0.25, 0, 0));
  EXPECT_EQ(shape->box().high, Vec3<double>(4, 10, 2));
}

TEST(MeshShape, Written_IsReadAsTheSame) {
  const auto shape =
      *readShape("0 0 0, 4 0 -0.375, 4 4 1, 1000000000 4 0, 0 0 1, 4 0 0.625", "0 1 2, 1 2 3, 0 1 5 4");
  const auto [corners, faces] = written(*shape);
  EXPECT_EQ(**readShape(corners, faces), *shape);
  // Of triangles without faces.
  const MeshShape triangles(*shape->mesh(), std::make_shared<const PlainHitSearch>(*shape->mesh()));
  EXPECT_EQ(written(triangles).faces, "0 1 2, 1 2 3, 0 1 5, 0 5 4");
}

TEST(MeshShape, WithOtherFaces_IsAnother) {
  const auto one = *readShape(square, "0 1 2 3");
  EXPECT_EQ(*one, **readShape(square, "0 1 2 3"));
  EXPECT_FALSE(*one == **readShape(square, "0 1 2, 0 2 3")) << "it has an edge more";
}

/// So many triangles in a row.
std::shared_ptr<const MeshShape> strip(std::size_t triangles) {
  std::vector<Vec3<double>> corners;
  for (std::uint32_t i = 0; i < triangles + 2; ++i)
    corners.emplace_back(i / 2, i % 2, 0);
  std::vector<MeshFace> faces;
  for (std::uint32_t i = 0; i < triangles; ++i)
    faces.push_back({i, i + 1, i + 2});
  return std::make_shared<const MeshShape>(std::move(corners), std::move(faces));
}

/// A mesh aimed at, alone and beside another.
Scene sceneWith(const std::shared_ptr<const MeshShape> &shape) {
  const auto small = strip(2);
  const auto hit = [](std::vector<std::string> meshes) {
    return ConstructionUse{"nearest-hit", {{"L", "L"}, {"i", "i"}, {"meshes", std::move(meshes)}}};
  };
  return {{{"big", MeshObject{{}, {1, 0, 0}, 1, shape}},
           {"small", MeshObject{{}, {1, 0, 0}, 1, small}},
           {"L", RayObject{{1, 1, 9}, {0, 0, -1}}},
           {"i", NumberObject{1, 0, 9, 1}},
           {"both", hit({"big", "small"})},
           {"alone", hit({"big"})},
           {"again", ConstructionUse{"ray-triangle-perp", {{"T", "alone.T"}, {"L", "L"}}}}}};
}

TEST(LargeMesh, InAScene_IsLeftOutOfFilesWithWhatLooksAtItAlone) {
  const Scene scene = sceneWith(strip(mostWrittenTriangles + 1));
  EXPECT_EQ(largeMeshes(scene), std::vector<std::string>{"big"});
  const auto again = readSession(writeSession({.lesson = "photon-torpedo", .scene = scene}), "");
  ASSERT_TRUE(again) << again.problem().sentence;
  std::vector<std::string> names;
  for (const Entry &entry : again->scene.entries)
    names.push_back(entry.name);
  EXPECT_EQ(names, (std::vector<std::string>{"small", "L", "i", "both"}));
  EXPECT_EQ(std::get<ConstructionUse>(again->scene.entries.back().content).roles.at("meshes").ids,
            std::vector<std::string>{"small"});
}

TEST(LargeMesh, JustSmallEnough_IsWrittenAndReadAsTheSame) {
  const Scene scene = sceneWith(strip(mostWrittenTriangles));
  const auto again = readSession(writeSession({.lesson = "photon-torpedo", .scene = scene}), "");
  ASSERT_TRUE(again) << again.problem().sentence;
  EXPECT_EQ(again->scene, scene);
}

TEST(MeshShape, DamagedInThousandsOfWays_IsReadOrToldWhatIsWrong) {
  const std::string corners = "0 0 0, 4 0 -0.375, 4 4 1/4, 0 4 0, 2 1 1e1";
  const std::string faces = "0 1 4, 1 2 4, 0 1 1, 3 4 2";
  const std::string scraps = "0123456789 ,.-/e\n\t\xFFx";
  std::mt19937 engine(5);
  const auto damaged = [&](std::string text) {
    for (auto times = engine() % 4; times > 0; --times)
      if (const std::size_t at = engine() % text.size(); engine() % 2 == 0)
        text[at] = scraps[engine() % scraps.size()];
      else
        text.insert(at, 1, scraps[engine() % scraps.size()]);
    return text;
  };
  int wasRead = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto shape = readShape(damaged(corners), damaged(faces));
    if (!shape) {
      EXPECT_FALSE(shape.problem().sentence.empty());
      EXPECT_TRUE(shape.problem().field == cornersField || shape.problem().field == facesField);
      continue;
    }
    ++wasRead;
    const auto [writtenCorners, writtenFaces] = written(**shape);
    EXPECT_EQ(**readShape(writtenCorners, writtenFaces), **shape);
  }
  EXPECT_GT(wasRead, 500);
  EXPECT_LT(wasRead, 4500);
}

/// A session file with a mesh.
std::string sessionWith(const std::string &mesh) {
  return R"({"format":"halfspace","version":2,"lesson":"x","step":0,
"scene":[{"name":"A1",
"mesh":{"P":["0","0","0"],"h":["1","0","0"],"k":"1")" +
         mesh + "}}]}";
}

TEST(Mesh, BadShapeInAFile_IsToldWithItsField) {
  const auto problemOf = [](const std::string &mesh) {
    return readSession(sessionWith(mesh), "x").problem();
  };
  EXPECT_TRUE(readSession(sessionWith(R"(,"corners":"0 0 0, 4 0 0, 0 4 0","faces":"0 1 2")"), "x"));
  EXPECT_EQ(problemOf(R"(,"corners":"0 0 0, 4 0 0, 0 4 0","faces":"0 1 3")").field, "scene[0].mesh.faces");
  EXPECT_EQ(problemOf(R"(,"corners":"0 0 0.1, 4 0 0, 0 4 0","faces":"0 1 2")").field,
            "scene[0].mesh.corners");
  EXPECT_EQ(problemOf(R"(,"corners":"0 0 0, 4 0 0, 0 4 0")").field, "scene[0].mesh.faces");
  EXPECT_EQ(problemOf(R"(,"faces":"0 1 2")").field, "scene[0].mesh.corners");
  const Problem list = problemOf(R"(,"corners":["0 0 0"],"faces":"0 1 2")");
  EXPECT_EQ(list.field, "scene[0].mesh.corners");
  EXPECT_NE(list.sentence.find("a text is expected"), std::string::npos) << list.sentence;
}

TEST(Mesh, BadShapeInALesson_IsToldWithItsLine) {
  const auto problemOf = [](const std::string &corners, const std::string &faces) {
    return parseLesson(
               "---\nid: x\ntitle: X\nsources: [PG 1]\nscene:\n  - name: A1\n    mesh:\n      P: [0, 0, 0]\n"
               "      h: [1, 0, 0]\n      k: 1\n      corners: " +
                   corners + "\n      faces: " + faces + "\n---\n## A step\n\nWords.\n",
               "x.md")
        .problem();
  };
  EXPECT_EQ(problemOf("0 0 0.1, 4 0 0, 0 4 0", "0 1 2").line, 11);
  EXPECT_EQ(problemOf("0 0 0, 4 0 0, 0 4 0", "0 1 3").line, 12);
}

// --- what is shared

TEST(Mesh, MovedByAnEdit_KeepsItsShape) {
  const Scene scene{{{"A1", *makeObject("mesh")}}};
  Object moved = *findObject(scene, "A1");
  moved[0] = {7, 8, 9};
  const Scene after = edited(scene, {ChangeObject{"A1", moved}});
  EXPECT_EQ((*findObject(after, "A1"))[0], ExactVec3(7, 8, 9));
  EXPECT_EQ(findObject(after, "A1")->shape(), findObject(scene, "A1")->shape());
}

TEST(Mesh, OfAnotherShape_IsAnother) {
  Object mesh = *makeObject("mesh");
  const Object before = mesh;
  mesh.setShape(*readShape(square, "0 1 2 3"));
  EXPECT_FALSE(mesh == before);
  Object same = mesh;
  same.setShape(*readShape(square, "0 1 2 3"));
  EXPECT_EQ(same, mesh);
}

// --- where it stands

/// Any mesh of a triangle, turned by any heading.
class RandomMeshes {
public:
  explicit RandomMeshes(std::uint64_t seed) : m_engine(seed) {}

  Rational number() {
    return Rational(static_cast<int>(m_engine() % 61) - 30, 1 + static_cast<int>(m_engine() % 4));
  }
  ExactVec3 vector() { return {number(), number(), number()}; }
  Vec3<double> corner() {
    const auto half = [&] { return (static_cast<double>(m_engine() % 41) - 20) / 2; };
    return {half(), half(), half()};
  }
  MeshObject mesh() {
    const auto shape = std::make_shared<const MeshShape>(std::vector{corner(), corner(), corner()},
                                                         std::vector<MeshFace>{{0, 1, 2}});
    return {vector(), vector(), abs(number()) + Rational(1, 7), shape};
  }

private:
  std::mt19937_64 m_engine;
};

TEST(MeshPlacement, OfARayAndATriangle_KeepsWhereTheyMeet) { // law (1)
  RandomMeshes random(1);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const MeshObject mesh = random.mesh();
    const Triangle<Rational> placed = triangleOf(mesh, 0);
    const ExactVec3 origin = random.vector();
    // Every second ray is aimed at the middle.
    const ExactVec3 middle = (placed.p0 + placed.p1 + placed.p2) / Rational(3);
    const Ray<Rational> ray{origin, i % 2 == 0 ? ExactVec3(middle - origin) : random.vector()};
    const auto inScene = intersectRayTriangle(ray, placed);
    const auto inMesh =
        intersectRayTriangle(MeshPlacement(mesh).toMesh(ray), exactly(mesh.shape->mesh()->triangle(0)));
    ASSERT_EQ(inMesh.which, inScene.which) << i;
    EXPECT_EQ(inMesh.plane.t, inScene.plane.t) << i;
    EXPECT_EQ(inMesh.s, inScene.s) << i;
    EXPECT_EQ(inMesh.tTriangle, inScene.tTriangle) << i;
    hits += inScene.which == RayTriangleCase::Hit ? 1 : 0;
  }
  EXPECT_GT(hits, 900);
}

ExactVec3 turnedX(const ExactVec3 &heading) {
  return MeshPlacement(MeshObject{{0, 0, 0}, heading, 1, nullptr}).toScene({1, 0, 0});
}

TEST(MeshPlacement, HeadingWhoseLengthIsAFraction_TurnsExactlyThere) {
  EXPECT_EQ(turnedX({3, 4, 0}), ExactVec3(q(3, 5), q(4, 5), 0));
  EXPECT_EQ(turnedX({-3, 4, 99}), ExactVec3(q(-3, 5), q(4, 5), 0)) << "its height turns nothing";
  EXPECT_EQ(turnedX({q(5, 2), -6, 0}), ExactVec3(q(5, 13), q(-12, 13), 0));
  EXPECT_EQ(turnedX({0, 7, 0}), ExactVec3(0, 1, 0));
  EXPECT_EQ(turnedX({-7, 0, 0}), ExactVec3(-1, 0, 0));
  EXPECT_EQ(turnedX({0, 0, 5}), ExactVec3(1, 0, 0)) << "upwards is no way to turn to";
  EXPECT_EQ(turnedX({0, 0, 0}), ExactVec3(1, 0, 0));
}

TEST(MeshPlacement, AnyHeading_TurnsByLessThanHalfADegreeBesideItAndKeepsLengths) {
  RandomMeshes random(2);
  for (int i = 0; i < 1000; ++i) {
    const ExactVec3 heading = i == 0 ? ExactVec3(-1000000000, 1, 0) : random.vector();
    if (heading.x == 0 && heading.y == 0)
      continue;
    const ExactVec3 x = turnedX(heading);
    EXPECT_EQ(dot(x, x), 1);
    const double across = toDouble(Rational(x.x * heading.y - x.y * heading.x));
    const double along = toDouble(Rational(x.x * heading.x + x.y * heading.y));
    EXPECT_LT(std::abs(std::atan2(across, along)), 0.5 * std::numbers::pi / 180)
        << toText(heading.x) << ", " << toText(heading.y);
  }
}

TEST(MeshPlacement, AxesInDoubles_LeadWhereTheScenePlacesAre) {
  RandomMeshes random(3);
  for (int i = 0; i < 100; ++i) {
    const MeshObject mesh = random.mesh();
    const MeshPlacement placement(mesh);
    const Vec3<double> corner = random.corner();
    const Vec3<double> drawn = toDouble(mesh.place) + placement.axes() * corner;
    const Vec3<double> exact = toDouble(placement.toScene(exactly(corner)));
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(drawn[axis], exact[axis], 1e-10);
  }
}

TEST(Mesh, ScaledToLessThanTheSmallestScale_IsScaledToThat) {
  Scene scene{{{"A1", *makeObject("mesh")}}};
  for (const Rational &scale : {Rational(-3), Rational(0), smallestScale / 2}) {
    Object mesh = *findObject(scene, "A1");
    mesh[2].x = scale;
    EXPECT_EQ((*findObject(edited(scene, {ChangeObject{"A1", mesh}}), "A1"))[2].x, smallestScale);
    const MeshObject unsettled{{0, 0, 0}, {1, 0, 0}, scale, mesh.shape()};
    EXPECT_EQ(MeshPlacement(unsettled).toScene(ExactVec3(1 / smallestScale, 0, 0)), ExactVec3(1, 0, 0));
  }
}

// --- what others catch at

TEST(Mesh, OfFewFaces_OffersItsCornersAndEdges) {
  Object mesh = *makeObject("mesh");
  mesh.setShape(*readShape("0 0 0, 4 0 0, 4 3 0, 0 3 0, 2 1 3", "0 1 2 3, 0 1 4, 1 2 4, 2 3 4, 3 0 4"));
  mesh[1] = {1, 0, 0};
  mesh[2].x = 1;
  Surroundings found;
  mesh.kind().offer({"A1", letter("A"), {letter("P"), letter("h"), letter("k")}, mesh}, found);
  EXPECT_EQ(found.points.size(), 5U);
  EXPECT_EQ(found.edges.size(), 8U) << "each once, and none across a face";
}

} // namespace
} // namespace halfspace
