#include "geometry/intersect_ray_solid.h"
#include "geometry/solid_shape.h"
#include "tests/effort.h"
#include "tests/geometry/random_bodies.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

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

TEST(SolidShape, InsideOut_IsNotConvex) { // law (2)
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
    EXPECT_EQ(withRoof(powerOfTen(-k)), SolidShape::Convex);
    EXPECT_EQ(withRoof(Rational(-powerOfTen(-k))), SolidShape::NotConvex);
  }
  EXPECT_EQ(withRoof(0), SolidShape::Convex);
}

TEST(SolidShape, VertexOfNoFace_MayLieInsideButNotInFront) {
  Mesh mesh = cubeMesh();
  mesh.vertices.emplace_back(1, 1, 1);
  EXPECT_EQ(shapeOf(mesh), SolidShape::Convex);
  mesh.vertices.back() = ExactVec3(1, 1, Rational(2 + powerOfTen(-50)));
  EXPECT_EQ(shapeOf(mesh), SolidShape::NotConvex);
}

TEST(SolidShape, FlatBody_IsNotConvex) {
  const Mesh flat{{ExactVec3(0, 0, 0), ExactVec3(2, 0, 0), ExactVec3(2, 2, 0), ExactVec3(0, 2, 0)},
                  {{0, 1, 2, 3}, {3, 2, 1, 0}}};
  EXPECT_EQ(shapeOf(flat), SolidShape::NotConvex);
}

TEST(SolidShape, BentFace_IsNotPlanarWhateverElseIsWrong) {
  Mesh mesh = cubeMesh();
  mesh.vertices[6].z += powerOfTen(-50);
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
    EXPECT_EQ(solid.edges.size() * 2, sides); // law (1)
    EXPECT_EQ(uses, std::vector<int>(solid.edges.size(), 2));
    EXPECT_EQ(directions, std::vector<int>(solid.edges.size(), 0));
  }
}

bool areWhole(const ExactVec3 &v) { return v.x.isInteger() && v.y.isInteger() && v.z.isInteger(); }

TEST(SolidOf, PlanesAndLines_AreWholeMultiplesOfThoseOfTheMeshWithAllVerticesBehind) {
  RandomNumbers random(198);
  for (int i = 0; i < 100; ++i) {
    const Mesh mesh = randomSolid(random);
    const auto solid = solidOf(mesh);
    for (std::size_t j = 0; j < mesh.faces.size(); ++j) {
      const auto &plane = solid.faces[j].plane;
      const std::set<std::uint32_t> own(mesh.faces[j].begin(), mesh.faces[j].end());
      for (std::uint32_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) { // law (2)
        const Rational side = evaluate(plane, mesh.vertices[vertex]);
        EXPECT_LE(side, 0);
        EXPECT_TRUE(!own.contains(vertex) || side == 0);
      }
      const ExactVec3 normal = meshNormal(mesh, mesh.faces[j]); // law (3)
      EXPECT_TRUE(isZero(cross(plane.normal, normal)));
      EXPECT_GT(dot(plane.normal, normal), 0);
      EXPECT_TRUE(areWhole(plane.normal) && plane.offset.isInteger());
    }
    for (const auto &edge : solid.edges) {
      EXPECT_TRUE(isReal(edge));
      EXPECT_TRUE(areWhole(edge.direction) && areWhole(edge.moment));
    }
  }
}

/// The same mesh with vertices and faces in another order, and faces that start with another corner.
Mesh shuffled(const Mesh &mesh, std::mt19937_64 &engine) {
  std::vector<std::uint32_t> places(mesh.vertices.size());
  std::iota(places.begin(), places.end(), 0U);
  std::shuffle(places.begin(), places.end(), engine);
  Mesh result = mesh;
  for (std::size_t i = 0; i < places.size(); ++i)
    result.vertices[places[i]] = mesh.vertices[i];
  for (auto &face : result.faces) {
    for (std::uint32_t &corner : face)
      corner = places[corner];
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(engine() % face.size()), face.end());
  }
  std::shuffle(result.faces.begin(), result.faces.end(), engine);
  return result;
}

/// The mesh with one vertex moved, one face turned over or left out, a point added, or as it is.
Mesh damaged(Mesh mesh, RandomNumbers &random) {
  const auto index = [&](std::size_t count) {
    return static_cast<std::size_t>(random.integer(0, static_cast<int>(count) - 1));
  };
  auto &face = mesh.faces[index(mesh.faces.size())];
  switch (random.integer(0, 4)) {
  case 0:
    mesh.vertices[index(mesh.vertices.size())] += random.wholeVector(1) * Rational(1, 2);
    break;
  case 1:
    std::reverse(face.begin(), face.end());
    break;
  case 2:
    std::swap(face, mesh.faces.back());
    mesh.faces.pop_back();
    break;
  case 3:
    mesh.vertices.push_back((mesh.vertices[face[0]] + mesh.vertices[face[1]]) * Rational(1, 2) +
                            random.wholeVector(1) * Rational(random.integer(0, 1), 4));
    break;
  default:
    break;
  }
  return mesh;
}

TEST(SolidShape, AnotherOrderOfFacesVerticesAndCorners_IsTheSame) { // law (1)
  RandomNumbers random(199);
  std::mt19937_64 engine(199);
  std::map<SolidShape, int> shapes;
  for (int i = 0; i < 400; ++i) {
    const Mesh mesh = damaged(randomSolid(random), random);
    const SolidShape shape = shapeOf(mesh);
    ++shapes[shape];
    for (int j = 0; j < 5; ++j)
      ASSERT_EQ(shapeOf(shuffled(mesh, engine)), shape) << "mesh " << i;
    Mesh insideOut = mesh; // law (2)
    for (auto &face : insideOut.faces)
      std::reverse(face.begin(), face.end());
    EXPECT_TRUE(shape != SolidShape::Convex || shapeOf(insideOut) == SolidShape::NotConvex);
  }
  EXPECT_EQ(shapes.size(), 4U) << "a shape did not come up";
}

/// The hull of more points than are looked at one by one.
Mesh largeHull(RandomNumbers &random) {
  for (;;) {
    Mesh mesh;
    for (int i = 0; i < 22; ++i) {
      // Near to a sphere, so that most of them are corners.
      const ExactVec3 way = random.nonZeroWholeVector(50);
      const auto length = static_cast<int>(std::sqrt(toDouble(dot(way, way))));
      mesh.vertices.push_back(way * Rational(100, std::max(1, length)));
    }
    if (addHull(mesh))
      return mesh;
  }
}

TEST(AreAllBehind, ManyVertices_AreBehindAsOneByOne) { // law (1)
  RandomNumbers random(200);
  int behind = 0;
  int notBehind = 0;
  for (int i = 0; i < 20; ++i) {
    const Mesh hull = largeHull(random);
    for (int j = 0; j < 20; ++j) {
      Mesh mesh = hull;
      if (j % 3 == 0) { // not closed, so that faces in front of a vertex need not be its neighbours'
        mesh.vertices[0] += random.wholeVector(60);
        mesh.faces.resize(mesh.faces.size() / 2);
      }
      mesh = damaged(mesh, random);
      ASSERT_GT(mesh.vertices.size(), 16U);
      const FaceSet<Rational> set{weighted(mesh.vertices), mesh.faces, edgesByEnds(mesh.faces)};
      std::vector<Plane<Rational>> planes;
      for (const auto &face : mesh.faces)
        planes.push_back(planeOf(face, set.vertices));
      const bool expected = areAllBehindOneByOne(set, planes);
      (expected ? behind : notBehind) += 1;
      ASSERT_EQ(areAllBehind(set), expected) << "hull " << i << ", mesh " << j;
    }
  }
  EXPECT_GT(behind, test::effort(50));
  EXPECT_GT(notBehind, test::effort(50));
}

TEST(IsInside, CornersInAnyOrder_TellTheSameAsBarycentricCoordinates) { // law (1)
  RandomNumbers random(201);
  for (int i = 0; i < 300; ++i) {
    std::array<ExactVec3, 4> corners;
    const auto volume = [&] {
      return dot(ExactVec3(corners[1] - corners[0]),
                 cross(ExactVec3(corners[2] - corners[0]), ExactVec3(corners[3] - corners[0])));
    };
    do
      for (ExactVec3 &corner : corners)
        corner = random.wholeVector(3);
    while (volume() == 0);
    // Inside exactly where all four coordinates are positive.
    const std::array<int, 3> parts{random.integer(-1, 4), random.integer(-1, 4), random.integer(-1, 4)};
    const int last = 6 - parts[0] - parts[1] - parts[2];
    const bool inside = parts[0] > 0 && parts[1] > 0 && parts[2] > 0 && last > 0;
    const ExactVec3 point = (corners[0] * Rational(parts[0]) + corners[1] * Rational(parts[1]) +
                             corners[2] * Rational(parts[2]) + corners[3] * Rational(last)) *
                            Rational(1, 6);
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    do
      EXPECT_EQ(isInside(weighted(point), {weighted(corners[order[0]]), weighted(corners[order[1]]),
                                           weighted(corners[order[2]]), weighted(corners[order[3]])}),
                inside);
    while (std::next_permutation(order.begin(), order.end()));
  }
}

/// What is expected of a ray and a solid, by clipping its line to the half-spaces behind the faces.
struct Clipped {
  bool meets = true;
  Rational enter;
  Rational leave;
  bool inFacePlane = false;
  SolidLocation origin = SolidLocation::Inside;
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
  clipped.origin = outside ? SolidLocation::Outside : onSomePlane ? SolidLocation::On : SolidLocation::Inside;
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
  std::map<SolidLocation, int> origins;
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
  for (const auto place : {SolidLocation::Outside, SolidLocation::On, SolidLocation::Inside})
    EXPECT_GE(origins[place], enough) << static_cast<int>(place);
}

TEST(IntersectRaySolid, AnySolidAndRay_IsMetBetweenTheTwoAndTheSameWhenStretched) {
  RandomNumbers random(202);
  std::map<SolidContacts, int> contacts;
  for (int i = 0; i < 1500; ++i) {
    const Mesh mesh = randomSolid(random);
    const auto solid = solidOf(mesh);
    const auto &face = someFace(mesh, random);
    const ExactVec3 direction = someDirection(mesh, face, random);
    if (isZero(direction))
      continue;
    const Ray<Rational> ray{someTarget(mesh, face, random) - direction * random.rational(2), direction};
    const auto meet = intersectRaySolid(ray, solid);
    ++contacts[meet.contacts];
    const Rational k = random.nonZeroRational(3);
    const auto scaled = intersectRaySolid({ray.origin, ray.direction * k}, solid);
    EXPECT_EQ(scaled.contacts, meet.contacts); // law (4)
    EXPECT_EQ(scaled.origin, meet.origin);
    ASSERT_EQ(meet.entered && meet.left, meet.contacts != SolidContacts::None);
    ASSERT_EQ(scaled.entered && scaled.left, meet.contacts != SolidContacts::None);
    if (meet.contacts == SolidContacts::None)
      continue;
    const auto &entered = k > 0 ? scaled.entered : scaled.left;
    const auto &left = k > 0 ? scaled.left : scaled.entered;
    EXPECT_EQ(entered->t, meet.entered->t / k);
    EXPECT_EQ(entered->point, meet.entered->point);
    EXPECT_EQ(entered->face, meet.entered->face);
    EXPECT_EQ(left->t, meet.left->t / k);
    EXPECT_EQ(left->point, meet.left->point);
    EXPECT_EQ(left->face, meet.left->face);

    EXPECT_LE(meet.entered->t, meet.left->t); // law (1)
    EXPECT_EQ(meet.entered->t == meet.left->t, meet.contacts == SolidContacts::One);
    for (const auto &crossing : {meet.entered, meet.left}) { // law (3)
      EXPECT_EQ(crossing->point, pointAt(ray, crossing->t));
      EXPECT_TRUE(faceContains(mesh, mesh.faces[crossing->face], crossing->point));
    }
    const auto placeAt = [&](const Rational &t) { // law (2)
      return intersectRaySolid({pointAt(ray, t), ray.direction}, solid).origin;
    };
    EXPECT_EQ(placeAt(meet.entered->t), SolidLocation::On);
    EXPECT_EQ(placeAt(meet.left->t), SolidLocation::On);
    EXPECT_EQ(placeAt(Rational(meet.entered->t - powerOfTen(-30))), SolidLocation::Outside);
    EXPECT_EQ(placeAt(Rational(meet.left->t + powerOfTen(-30))), SolidLocation::Outside);
    if (meet.contacts != SolidContacts::One) {
      EXPECT_EQ(placeAt(Rational(meet.entered->t + (meet.left->t - meet.entered->t) / 3)),
                meet.contacts == SolidContacts::Two ? SolidLocation::Inside : SolidLocation::On);
    }
  }
  EXPECT_EQ(contacts.size(), 4U) << "a kind of contact did not come up";
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
  EXPECT_EQ(still.origin, SolidLocation::Inside);
}

} // namespace
} // namespace halfspace
