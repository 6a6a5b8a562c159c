#include "geometry/intersect_ray_box.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

/// Of the rays below, all at the box from (2, 3, 0) to (8, 7, 4).
RayBox<Rational> meetBox(const ExactVec3 &origin, const ExactVec3 &direction) {
  return intersectRayBox<Rational>({origin, direction}, {2, 3, 0}, {8, 7, 4});
}

TEST(IntersectRayBox, GoesInBetweenTheLastPairOfPlanes) {
  const auto meet = meetBox({0, -3, 6}, {2, 2, -1});
  EXPECT_EQ(meet.which, RaySolidCase::Hit);
  EXPECT_EQ(meet.origin, SolidLocation::Outside);
  EXPECT_EQ(meet.slabs[0].in, 1);
  EXPECT_EQ(meet.slabs[0].out, 4);
  EXPECT_EQ(meet.slabs[1].in, 3);
  EXPECT_EQ(meet.slabs[1].out, 5);
  EXPECT_EQ(meet.slabs[2].in, 2); // from above: the higher plane comes first
  EXPECT_EQ(meet.slabs[2].out, 6);
  EXPECT_EQ(meet.in, 3);
  EXPECT_EQ(meet.out, 4);
}

TEST(IntersectRayBox, ThatLeavesOneSlabBeforeItComesIntoAnother_Misses) {
  const auto meet = meetBox({3, -3, 6}, {2, 2, -1});
  EXPECT_EQ(meet.which, RaySolidCase::Miss);
  EXPECT_GT(meet.in, meet.out);
  EXPECT_EQ(meetBox({2, -3, 6}, {2, 2, -1}).which, RaySolidCase::Hit) << "it touches an edge";
}

TEST(IntersectRayBox, ParallelToASlab_IsAlwaysInItOrNever) {
  const auto within = meetBox({0, 3, 2}, {1, 0, 0});
  EXPECT_EQ(within.slabs[1].which, SlabCase::Within) << "in one of its planes";
  EXPECT_EQ(within.which, RaySolidCase::Hit);
  const auto beside = meetBox({0, 2, 2}, {1, 0, 0});
  EXPECT_EQ(beside.slabs[1].which, SlabCase::Beside);
  EXPECT_EQ(beside.which, RaySolidCase::Miss);
}

TEST(IntersectRayBox, FromInsideOnItOrPastIt_TellsWhereItStarts) {
  EXPECT_EQ(meetBox({5, 5, 2}, {1, 1, 1}).origin, SolidLocation::Inside);
  EXPECT_LT(meetBox({5, 5, 2}, {1, 1, 1}).in, 0);
  EXPECT_EQ(meetBox({8, 5, 2}, {1, 1, 1}).origin, SolidLocation::On);
  EXPECT_EQ(meetBox({8, 5, 2}, {1, 1, 1}).which, RaySolidCase::Hit);
  EXPECT_EQ(meetBox({9, 5, 2}, {1, 0, 0}).which, RaySolidCase::Behind);
  EXPECT_EQ(meetBox({5, 5, 2}, {0, 0, 0}).which, RaySolidCase::ZeroDirection);
}

/// A ray with small numbers, often along an axis, and a box that may be flat.
struct RayAtBox {
  explicit RayAtBox(RandomNumbers &random)
      : ray{random.wholeVector(5), random.wholeVector(2)}, low(random.wholeVector(3)),
        high(low + ExactVec3(random.integer(0, 4), random.integer(0, 4), random.integer(0, 4))) {}

  [[nodiscard]] RayBox<Rational> meet() const { return intersectRayBox(ray, low, high); }
  [[nodiscard]] bool has(const ExactVec3 &point) const {
    return intersectRayBox<Rational>({point, {0, 0, 0}}, low, high).origin != SolidLocation::Outside;
  }

  Ray<Rational> ray;
  ExactVec3 low;
  ExactVec3 high;
};

TEST(IntersectRayBox, IsInTheBoxExactlyBetweenInAndOut) { // laws (1) and (2)
  RandomNumbers random(91);
  for (int i = 0; i < test::effort(2000); ++i) {
    const RayAtBox at(random);
    const auto meet = at.meet();
    if (meet.which == RaySolidCase::ZeroDirection)
      continue;
    const bool isMet = meet.which != RaySolidCase::Miss;
    const Rational step(1, 7);
    for (const Rational &t : {meet.in, meet.out, Rational((meet.in + meet.out) / 2), Rational(meet.in - step),
                              Rational(meet.out + step), random.rational()})
      EXPECT_EQ(at.has(pointAt(at.ray, t)), isMet && meet.in <= t && t <= meet.out);
    for (int axis = 0; axis < 3; ++axis) {
      const auto &slab = meet.slabs.at(static_cast<std::size_t>(axis));
      EXPECT_LE(slab.in, slab.out);
      if (slab.which == SlabCase::Crossed) {
        EXPECT_EQ(slab.in == slab.out, at.low[axis] == at.high[axis]);
      }
    }
  }
}

TEST(IntersectRayBox, OfALongerOrAReversedDirection_DividesT) { // law (3)
  RandomNumbers random(92);
  for (int i = 0; i < test::effort(1000); ++i) {
    const RayAtBox at(random);
    const auto meet = at.meet();
    const Rational k = random.nonZeroRational();
    const auto scaled = intersectRayBox<Rational>({at.ray.origin, at.ray.direction * k}, at.low, at.high);
    EXPECT_EQ(scaled.in, Rational((k > 0 ? meet.in : meet.out) / k));
    EXPECT_EQ(scaled.out, Rational((k > 0 ? meet.out : meet.in) / k));
    EXPECT_EQ(scaled.which == RaySolidCase::Miss, meet.which == RaySolidCase::Miss);
  }
}

TEST(IntersectRayBox, WithAnInside_IsMetAsTheSolidIs) { // law (4)
  RandomNumbers random(93);
  for (int i = 0; i < test::effort(1000); ++i) {
    const RayAtBox at(random);
    if (at.low.x == at.high.x || at.low.y == at.high.y || at.low.z == at.high.z)
      continue;
    SolidMesh<Rational> mesh;
    for (int corner = 0; corner < 8; ++corner)
      mesh.vertices.push_back({(corner & 1 ? at.high : at.low).x, (corner & 2 ? at.high : at.low).y,
                               (corner & 4 ? at.high : at.low).z});
    mesh.faces = {{4, 5, 7, 6}, {0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    const auto meet = at.meet();
    const auto asSolid = intersectRaySolid(at.ray, solidOf(mesh));
    EXPECT_EQ(meet.which, asSolid.which);
    EXPECT_EQ(meet.origin, asSolid.origin);
    if (meet.which == RaySolidCase::Hit || meet.which == RaySolidCase::Behind) {
      EXPECT_EQ(meet.in, asSolid.entered->t);
      EXPECT_EQ(meet.out, asSolid.left->t);
    }
  }
}

} // namespace
} // namespace halfspace
