#include "geometry/intersect_ray_solid.h"
#include "geometry/solid_shape.h"
#include "tests/geometry/random_bodies.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

ExactVec3 meshNormal(const Mesh &mesh, const std::vector<std::uint32_t> &face) {
  return cross(ExactVec3(mesh.vertices[face[1]] - mesh.vertices[face[0]]),
               ExactVec3(mesh.vertices[face[2]] - mesh.vertices[face[0]]));
}

TEST(SolidShape, KnownAndRandomSolids_AreConvex) {
  for (const Mesh &mesh : {cubeMesh(), splitCubeMesh(), tetrahedronMesh(), octahedronMesh(), pyramidMesh()})
    EXPECT_EQ(shapeOf(mesh), SolidShape::Convex);
  RandomNumbers random(121);
  for (int i = 0; i < 300; ++i)
    EXPECT_EQ(shapeOf(randomSolid(random)), SolidShape::Convex);
}

TEST(SolidShape, FaceLeftOut_IsNotClosed) {
  for (const Mesh &whole : {cubeMesh(), splitCubeMesh(), octahedronMesh(), pyramidMesh()})
    for (std::size_t face = 0; face < whole.faces.size(); ++face) {
      Mesh open = whole;
      open.faces.erase(open.faces.begin() + static_cast<std::ptrdiff_t>(face));
      EXPECT_EQ(shapeOf(open), SolidShape::NotClosed);
    }
}

TEST(SolidShape, FaceGivenTwice_IsNotClosed) {
  for (std::size_t face = 0; face < 6; ++face) {
    Mesh mesh = cubeMesh();
    mesh.faces.push_back(mesh.faces[face]);
    EXPECT_EQ(shapeOf(mesh), SolidShape::NotClosed);
  }
}

TEST(SolidShape, VertexGivenTwiceByIndex_IsNotClosed) {
  Mesh mesh = cubeMesh();
  mesh.vertices.push_back(mesh.vertices[0]);
  mesh.faces[0] = {3, 2, 1, 8};
  EXPECT_EQ(shapeOf(mesh), SolidShape::NotClosed);
}

TEST(SolidShape, FaceTurnedOver_IsNotConvex) {
  for (std::size_t face = 0; face < 6; ++face) {
    Mesh mesh = cubeMesh();
    std::reverse(mesh.faces[face].begin(), mesh.faces[face].end());
    EXPECT_EQ(shapeOf(mesh), SolidShape::NotConvex);
  }
}

TEST(SolidShape, InsideOut_IsNotConvex) {
  Mesh mesh = octahedronMesh();
  for (auto &face : mesh.faces)
    std::reverse(face.begin(), face.end());
  EXPECT_EQ(shapeOf(mesh), SolidShape::NotConvex);
}

TEST(SolidShape, DentHoweverSmall_IsNotConvex) {
  // A roof on the cube instead of its top: risen it is convex, sunk it is not, level it is again.
  const auto withRoof = [](const Rational &height) {
    Mesh mesh = cubeMesh();
    mesh.vertices.emplace_back(1, 1, Rational(2 + height));
    mesh.faces.erase(mesh.faces.begin() + 1);
    for (const std::uint32_t corner : {0U, 1U, 2U, 3U})
      mesh.faces.push_back({4 + corner, 4 + (corner + 1) % 4, 8});
    return shapeOf(mesh);
  };
  for (int k = 0; k <= 60; ++k) {
    EXPECT_EQ(withRoof(tenToThe(-k)), SolidShape::Convex);
    EXPECT_EQ(withRoof(Rational(-tenToThe(-k))), SolidShape::NotConvex);
  }
  EXPECT_EQ(withRoof(0), SolidShape::Convex);
}

TEST(SolidShape, VertexOfNoFace_MayLieInsideButNotInFront) {
  Mesh mesh = cubeMesh();
  mesh.vertices.emplace_back(1, 1, 1);
  EXPECT_EQ(shapeOf(mesh), SolidShape::Convex);
  mesh.vertices.back() = ExactVec3(1, 1, Rational(2 + tenToThe(-50)));
  EXPECT_EQ(shapeOf(mesh), SolidShape::NotConvex);
}

TEST(SolidShape, FlatBody_IsNotConvex) {
  const Mesh flat{{ExactVec3(0, 0, 0), ExactVec3(2, 0, 0), ExactVec3(2, 2, 0), ExactVec3(0, 2, 0)},
                  {{0, 1, 2, 3}, {3, 2, 1, 0}}};
  EXPECT_EQ(shapeOf(flat), SolidShape::NotConvex);
}

TEST(SolidShape, BentFace_IsNotPlanarWhateverElseIsWrong) {
  Mesh mesh = cubeMesh();
  mesh.vertices[6].z += tenToThe(-50);
  EXPECT_EQ(shapeOf(mesh), SolidShape::NotPlanar);
  mesh.faces.pop_back();
  std::reverse(mesh.faces[0].begin(), mesh.faces[0].end());
  EXPECT_EQ(shapeOf(mesh), SolidShape::NotPlanar);
}

TEST(SolidOf, EachEdge_IsHeldOnceAndUsedByTwoFacesInOppositeDirections) {
  RandomNumbers random(122);
  for (int i = 0; i < 100; ++i) {
    const Mesh mesh = randomSolid(random);
    const auto solid = solidOf(mesh);
    std::size_t sides = 0;
    std::vector<int> uses(solid.edges.size());
    std::vector<int> directions(solid.edges.size());
    for (const auto &face : solid.faces)
      for (const auto &side : face.sides) {
        ++sides;
        ++uses[side.edge];
        directions[side.edge] += side.forward ? 1 : -1;
      }
    EXPECT_EQ(solid.edges.size() * 2, sides);
    EXPECT_EQ(uses, std::vector<int>(solid.edges.size(), 2));
    EXPECT_EQ(directions, std::vector<int>(solid.edges.size(), 0));
  }
}

/// What is expected of a ray and a solid, by clipping its line to the half-spaces behind the faces.
struct Clipped {
  bool meets = true;
  Rational enter;
  Rational leave;
  bool inFacePlane = false;
  SolidPlace origin = SolidPlace::Inside;
};

Clipped clip(const Ray<Rational> &ray, const Mesh &mesh) {
  Clipped clipped;
  std::optional<Rational> enter;
  std::optional<Rational> leave;
  bool onSomePlane = false;
  bool outside = false;
  bool passesBeside = false;
  for (const auto &face : mesh.faces) {
    const ExactVec3 normal = meshNormal(mesh, face);
    const Rational height = dot(normal, ExactVec3(ray.origin - mesh.vertices[face[0]]));
    const Rational climb = dot(normal, ray.direction);
    outside = outside || height > 0;
    onSomePlane = onSomePlane || height == 0;
    if (climb == 0) {
      passesBeside = passesBeside || height > 0;
      clipped.inFacePlane = clipped.inFacePlane || height == 0;
      continue;
    }
    const Rational t = -height / climb;
    if (climb < 0)
      enter = enter ? std::max(*enter, t) : t;
    else
      leave = leave ? std::min(*leave, t) : t;
  }
  clipped.origin = outside ? SolidPlace::Outside : onSomePlane ? SolidPlace::On : SolidPlace::Inside;
  clipped.enter = *enter;
  clipped.leave = *leave;
  clipped.meets = !passesBeside && clipped.enter <= clipped.leave;
  return clipped;
}

bool faceContains(const Mesh &mesh, const std::vector<std::uint32_t> &face, const ExactVec3 &point) {
  const ExactVec3 normal = meshNormal(mesh, face);
  if (dot(normal, ExactVec3(point - mesh.vertices[face[0]])) != 0)
    return false;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const ExactVec3 &from = mesh.vertices[face[i]];
    const ExactVec3 &to = mesh.vertices[face[(i + 1) % face.size()]];
    if (dot(cross(ExactVec3(to - from), ExactVec3(point - from)), normal) < 0)
      return false;
  }
  return true;
}

/// The lowest index of the faces that contain the point and that the direction goes into (sign −1) or out of.
std::size_t lowestFace(const Mesh &mesh, const ExactVec3 &point, const ExactVec3 &direction, int sign) {
  for (std::size_t i = 0; i < mesh.faces.size(); ++i)
    if (dot(meshNormal(mesh, mesh.faces[i]), direction).sign() == sign &&
        faceContains(mesh, mesh.faces[i], point))
      return i;
  return mesh.faces.size();
}

SolidContacts expectedContacts(const Clipped &clipped) {
  if (!clipped.meets)
    return SolidContacts::None;
  if (clipped.enter == clipped.leave)
    return SolidContacts::One;
  return clipped.inFacePlane ? SolidContacts::Along : SolidContacts::Two;
}

void expectCrossings(const Ray<Rational> &ray, const Mesh &mesh, const RaySolid<Rational> &meet,
                     const Clipped &clipped) {
  ASSERT_TRUE(meet.entered && meet.left);
  EXPECT_EQ(meet.entered->t, clipped.enter);
  EXPECT_EQ(meet.left->t, clipped.leave);
  EXPECT_EQ(meet.entered->point, pointAt(ray, clipped.enter));
  EXPECT_EQ(meet.left->point, pointAt(ray, clipped.leave));
  EXPECT_EQ(meet.entered->face, lowestFace(mesh, meet.entered->point, ray.direction, -1));
  EXPECT_EQ(meet.left->face, lowestFace(mesh, meet.left->point, ray.direction, 1));
}

void expectAsClipped(const Ray<Rational> &ray, const Mesh &mesh, const RaySolid<Rational> &meet) {
  const Clipped clipped = clip(ray, mesh);
  EXPECT_EQ(meet.contacts, expectedContacts(clipped));
  EXPECT_EQ(meet.origin, clipped.origin);
  EXPECT_EQ(meet.which, !clipped.meets      ? RaySolidCase::Miss
                        : clipped.leave < 0 ? RaySolidCase::Behind
                                            : RaySolidCase::Hit);
  EXPECT_EQ(meet.entered.has_value(), clipped.meets);
  if (clipped.meets)
    expectCrossings(ray, mesh, meet, clipped);
}

const std::vector<std::uint32_t> &someFace(const Mesh &mesh, RandomNumbers &random) {
  return mesh.faces[static_cast<std::size_t>(random.integer(0, static_cast<int>(mesh.faces.size()) - 1))];
}

/// A vertex, a point of an edge, one between two vertices, or any point of a face's plane.
ExactVec3 someTarget(const Mesh &mesh, const std::vector<std::uint32_t> &face, RandomNumbers &random) {
  const ExactVec3 &corner = mesh.vertices[face[0]];
  const ExactVec3 u = mesh.vertices[face[1]] - corner;
  const ExactVec3 v = mesh.vertices[face[2]] - corner;
  switch (random.integer(0, 3)) {
  case 0:
    return corner;
  case 1:
    return corner + u * (Rational(random.integer(-1, 5)) / 4);
  case 2:
    return (corner + mesh.vertices[someFace(mesh, random)[1]]) * Rational(1, 2);
  default:
    return corner + u * (Rational(random.integer(-2, 6)) / 4) + v * (Rational(random.integer(-2, 6)) / 4);
  }
}

ExactVec3 someDirection(const Mesh &mesh, const std::vector<std::uint32_t> &face, RandomNumbers &random) {
  const ExactVec3 u = mesh.vertices[face[1]] - mesh.vertices[face[0]];
  const ExactVec3 v = mesh.vertices[face[2]] - mesh.vertices[face[0]];
  switch (random.integer(0, 4)) {
  case 0:
    return random.integer(0, 1) == 0 ? u : ExactVec3(-u);
  case 1:
    return u * Rational(random.integer(-2, 2)) + v * Rational(random.integer(-2, 2));
  case 2:
    return mesh.vertices[someFace(mesh, random)[0]] - someTarget(mesh, face, random);
  default:
    return random.wholeVector(5);
  }
}

TEST(IntersectRaySolid, AnySolidAndRay_AgreesWithClippingToHalfSpaces) {
  RandomNumbers random(123);
  // So often each kind of contact comes up at least.
  constexpr int enough = 100;
  std::map<SolidContacts, int> contacts;
  std::map<RaySolidCase, int> cases;
  std::map<SolidPlace, int> origins;
  for (int i = 0; i < 300; ++i) {
    const Mesh mesh = randomSolid(random);
    const auto solid = solidOf(mesh);
    for (int j = 0; j < 30; ++j) {
      const auto &face = someFace(mesh, random);
      const ExactVec3 direction = someDirection(mesh, face, random);
      if (isZero(direction))
        continue;
      const ExactVec3 target = someTarget(mesh, face, random);
      const Ray<Rational> ray{target - direction * (Rational(random.integer(-4, 4)) / 2), direction};
      const auto meet = intersectRaySolid(ray, solid);
      ++contacts[meet.contacts];
      ++cases[meet.which];
      ++origins[meet.origin];
      expectAsClipped(ray, mesh, meet);
      ASSERT_FALSE(HasFatalFailure() || HasNonfatalFailure()) << "solid " << i << ", ray " << j;
    }
  }
  for (const auto kind : {SolidContacts::None, SolidContacts::One, SolidContacts::Two, SolidContacts::Along})
    EXPECT_GE(contacts[kind], enough) << static_cast<int>(kind);
  for (const auto which : {RaySolidCase::Hit, RaySolidCase::Behind, RaySolidCase::Miss})
    EXPECT_GE(cases[which], enough) << static_cast<int>(which);
  for (const auto place : {SolidPlace::Outside, SolidPlace::On, SolidPlace::Inside})
    EXPECT_GE(origins[place], enough) << static_cast<int>(place);
}

TEST(IntersectRaySolid, CubeTouchedAtACornerAndAlongAnEdgeAndInAFace_SaysWhich) {
  const auto solid = solidOf(cubeMesh());
  const auto contacts = [&](const ExactVec3 &origin, const ExactVec3 &direction) {
    return intersectRaySolid({origin, direction}, solid).contacts;
  };
  EXPECT_EQ(contacts(ExactVec3(2, 2, 2), ExactVec3(1, -1, 0)), SolidContacts::One);
  EXPECT_EQ(contacts(ExactVec3(2, 2, 2), ExactVec3(1, 1, -2)), SolidContacts::One);
  EXPECT_EQ(contacts(ExactVec3(2, 1, 2), ExactVec3(1, 0, -1)), SolidContacts::One);
  EXPECT_EQ(contacts(ExactVec3(9, 2, 2), ExactVec3(-1, 0, 0)), SolidContacts::Along);
  EXPECT_EQ(contacts(ExactVec3(9, 1, 2), ExactVec3(-1, 0, 0)), SolidContacts::Along);
  EXPECT_EQ(contacts(ExactVec3(9, 3, 2), ExactVec3(-1, 0, 0)), SolidContacts::None);
  EXPECT_EQ(contacts(ExactVec3(9, 9, 9), ExactVec3(1, 1, 1)), SolidContacts::Two);
}

TEST(IntersectRaySolid, FacesThatShareAPlane_GiveTheLowestIndexThatContainsThePoint) {
  const auto solid = solidOf(splitCubeMesh());
  const auto downAt = [&](const Rational &x, const Rational &y) {
    return intersectRaySolid({ExactVec3(x, y, 9), ExactVec3(0, 0, -1)}, solid);
  };
  EXPECT_EQ(downAt(Rational(3, 2), Rational(1, 2)).entered->face, 1U);
  EXPECT_EQ(downAt(Rational(1, 2), Rational(3, 2)).entered->face, 5U);
  EXPECT_EQ(downAt(1, 1).entered->face, 1U);
  EXPECT_EQ(downAt(1, 1).left->face, 0U);
  EXPECT_EQ(downAt(Rational(1, 2), Rational(1, 2)).left->face, 7U);
}

TEST(IntersectRaySolid, ZeroDirection_IsACaseOfItsOwnButKnowsItsPlace) {
  const auto still = intersectRaySolid({ExactVec3(1, 1, 1), ExactVec3(0, 0, 0)}, solidOf(cubeMesh()));
  EXPECT_EQ(still.which, RaySolidCase::ZeroDirection);
  EXPECT_EQ(still.origin, SolidPlace::Inside);
}

} // namespace
} // namespace halfspace
