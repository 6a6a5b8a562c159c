// Millions of doubles, random and adversarial: no verdict may differ from the exact one, which is law (1) of
// them all.
#include "geometry/decide.h"

#include "geometry/filter.h"
#include "geometry/intersect_ray_triangle_cramer.h"
#include "geometry/intersect_ray_triangle_plucker.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace halfspace {
namespace {

/// The sweeps are this many times as long when the environment says so: HALFSPACE_SWEEP=100 makes millions.
int times(int count) {
  const char *factor = std::getenv("HALFSPACE_SWEEP");
  return test::effort(count) * (factor == nullptr ? 1 : std::max(1, std::atoi(factor)));
}

/// Doubles that filters like least.
class NastyDoubles {
public:
  explicit NastyDoubles(std::uint64_t seed) : m_random(seed), m_engine(seed + 1) {}

  int integer(int low, int high) { return m_random.integer(low, high); }

  /// Whole, short, long, huge, tiny or subnormal.
  double number() {
    switch (integer(0, 9)) {
    case 0:
      return 0;
    case 1:
      return integer(-3, 3);
    case 2:
      return integer(-1000, 1000) / 16.0;
    case 3:
      return m_random.anyDouble();
    case 4:
      return std::ldexp(integer(-9, 9), integer(-1074, 1000));
    case 5:
      return 1e6 + uniform();
    default:
      return uniform() * 20;
    }
  }

  /// Between −1 and 1.
  double uniform() { return std::uniform_real_distribution<double>(-1, 1)(m_engine); }

  Vec3<double> vector() { return {number(), number(), number()}; }
  Vec3<double> ordinaryVector() { return {uniform() * 20, uniform() * 20, uniform() * 20}; }

  /// Some units in the last place off, or none.
  double nudged(double value) {
    for (int steps = integer(0, 2); steps > 0; --steps)
      value = std::nextafter(value, integer(0, 1) == 0 ? -1e300 : 1e300);
    return value;
  }
  Vec3<double> nudged(const Vec3<double> &v) { return {nudged(v.x), nudged(v.y), nudged(v.z)}; }

private:
  RandomNumbers m_random;
  std::mt19937_64 m_engine;
};

TEST(DecidePointPlane, PointsOnOrBesideThePlane_AreOnTheirExactSide) {
  NastyDoubles nasty(1);
  int on = 0;
  for (int i = 0; i < times(4000); ++i) {
    const Vec3<double> point = nasty.vector();
    Plane<double> plane{nasty.vector(), nasty.number()};
    if (i % 2 == 0)
      plane.offset = nasty.nudged(-dot(plane.normal, point));
    if (!std::isfinite(plane.offset))
      continue;
    const auto exact = measurePointPlane(exactly(point), exactly(plane)).which;
    on += exact == PointPlaneCase::On ? 1 : 0;
    ASSERT_EQ(decidePointPlane(point, plane), exact) << i;
  }
  EXPECT_GT(on, times(20)); // the sweep reaches the plane itself
}

TEST(DecideRayPlane, NearlyParallelAndNearlyInThePlane_IsTheExactCase) {
  NastyDoubles nasty(2);
  for (int i = 0; i < times(3000); ++i) {
    Ray<double> ray{nasty.vector(), nasty.vector()};
    Plane<double> plane{nasty.vector(), nasty.number()};
    if (i % 2 == 0) {
      // Two edges of a plane and its normal: what is left of their product is rounding.
      const Vec3<double> u = nasty.ordinaryVector();
      plane.normal = cross(u, nasty.ordinaryVector());
      ray.direction = nasty.nudged(u);
      plane.offset = nasty.nudged(-dot(plane.normal, ray.origin));
    }
    if (!std::isfinite(plane.offset))
      continue;
    ASSERT_EQ(decideRayPlane(ray, plane), intersectRayPlane(exactly(ray), exactly(plane)).which) << i;
  }
}

/// Rays aimed at, or within a few units in the last place of, corners and points of edges.
Ray<double> aimedRay(NastyDoubles &nasty, const Triangle<double> &triangle) {
  const double share = nasty.integer(0, 4) / 4.0;
  const Vec3<double> target = triangle.p0 + (triangle.p1 - triangle.p0) * share;
  const Vec3<double> origin = nasty.ordinaryVector();
  return {origin, nasty.nudged(target - origin)};
}

void expectExactVerdict(const Ray<double> &ray, const Triangle<double> &triangle) {
  const auto verdict = decideRayTriangle(ray, triangle);
  const auto exact = intersectRayTriangle(exactly(ray), exactly(triangle));
  ASSERT_EQ(verdict.which, exact.which);
  ASSERT_EQ(verdict.location.part, exact.location.part);
  ASSERT_EQ(verdict.location.feature, exact.location.feature);

  const auto hit = exactHit(ray, triangle);
  ASSERT_EQ(hit.has_value(), exact.which == RayTriangleCase::Hit);
  ASSERT_TRUE(!hit || *hit == exact.plane.t);
  ASSERT_TRUE(!exact.crosses() || exactT(ray, triangle) == exact.plane.t);
}

TEST(DecideShape, NearlyInLineAndNearlyInOnePoint_IsTheExactShape) {
  NastyDoubles nasty(215);
  int degenerate = 0;
  for (int i = 0; i < times(20'000); ++i) {
    const Vec3<double> p0 = i % 2 == 0 ? nasty.vector() : nasty.ordinaryVector();
    const Vec3<double> way =
        i % 3 == 0 ? Vec3<double>(0) : Vec3<double>(1, 2, -0.5) * std::ldexp(1.0, nasty.integer(-30, 30));
    Triangle<double> triangle{p0, p0 + way, p0 + way * double(nasty.integer(-2, 2))};
    if (i % 5 == 0)
      triangle.p2.x = nasty.nudged(triangle.p2.x);
    const TriangleShape expected = shapeOf(exactly(triangle));
    ASSERT_EQ(decideShape(triangle), expected) << i;
    degenerate += expected == TriangleShape::Proper ? 0 : 1;
  }
  EXPECT_GT(degenerate, times(1000));
  EXPECT_LT(degenerate, times(19'000));
}

TEST(DecideRayTriangle, AimedAtEdgesAndCorners_IsTheExactVerdict) {
  NastyDoubles nasty(3);
  for (int i = 0; i < times(4000); ++i) {
    Triangle<double> triangle{nasty.ordinaryVector(), nasty.ordinaryVector(), nasty.ordinaryVector()};
    if (i % 5 == 0)
      triangle.p2 = nasty.nudged(triangle.p0 + (triangle.p1 - triangle.p0) * nasty.uniform());
    ASSERT_NO_FATAL_FAILURE(expectExactVerdict(aimedRay(nasty, triangle), triangle)) << i;
  }
}

TEST(DecideRayTriangle, AnyNumbers_IsTheExactVerdict) {
  NastyDoubles nasty(4);
  for (int i = 0; i < times(2000); ++i)
    ASSERT_NO_FATAL_FAILURE(expectExactVerdict({nasty.vector(), nasty.vector()},
                                               {nasty.vector(), nasty.vector(), nasty.vector()}))
        << i;
}

TEST(DecideRaySphere, NearlyTangent_IsTheExactVerdict) {
  NastyDoubles nasty(5);
  int tangents = 0;
  for (int i = 0; i < times(3000); ++i) {
    Ray<double> ray{nasty.vector(), nasty.vector()};
    Sphere<double> sphere{nasty.vector(), std::abs(nasty.number())};
    if (i % 2 == 0) {
      sphere.radius = nasty.integer(1, 9);
      sphere.center = {double(nasty.integer(-9, 9)), double(nasty.integer(-9, 9)), 0};
      ray.origin = {double(nasty.integer(-9, 9)), nasty.nudged(sphere.center.y + sphere.radius), 0};
      ray.direction = {1, 0, 0};
    }
    if (sphere.radius == 0)
      continue;
    const auto verdict = decideRaySphere(ray, sphere);
    const auto exact = intersectRaySphere(exactly(ray), exactly(sphere));
    ASSERT_EQ(verdict.which, exact.which) << i;
    ASSERT_EQ(verdict.contacts, exact.contacts) << i;
    tangents += exact.contacts == SphereContacts::Tangent ? 1 : 0;
  }
  EXPECT_GT(tangents, times(100));
}

bool holds(const Bounded &bounded, const Rational &exact) {
  return abs(exact - exactly(bounded.value)) <= exactly(bounded.error) &&
         (bounded.sign() == 0 || bounded.sign() == exact.sign());
}

TEST(Bounded, ProductsDifferencesAndQuotients_AreWithinTheirBounds) { // laws (1) and (2)
  NastyDoubles nasty(6);
  int quotients = 0;
  for (int i = 0; i < times(4000); ++i) {
    Plane<double> plane{nasty.vector(), nasty.number()};
    const Vec3<double> x = nasty.vector();
    Vec3<double> y = nasty.nudged(x);
    if (i % 2 == 0) { // nearly across the normal: what is left of the product is hardly more than its error
      y = nasty.ordinaryVector();
      plane.normal = cross(y, nasty.ordinaryVector());
      y += plane.normal * std::ldexp(nasty.uniform(), -40);
    }
    if (!isTame(plane) || !isTame(x) || !isTame(y))
      continue;
    const auto first = boundedEvaluate(plane, x);
    const auto second = boundedDot(plane.normal, y);
    const Rational exactFirst = evaluate(exactly(plane), exactly(x));
    const Rational exactSecond = dot(exactly(plane.normal), exactly(y));
    ASSERT_TRUE(holds(first, exactFirst)) << i;
    ASSERT_TRUE(holds(second, exactSecond)) << i;
    ASSERT_TRUE(holds(first - second, Rational(exactFirst - exactSecond))) << i;
    if (second.sign() != 0) {
      ++quotients;
      ASSERT_TRUE(holds(first / second, Rational(exactFirst / exactSecond))) << i;
      ASSERT_TRUE(holds(Bounded::of(1, 1) / second, Rational(1 / exactSecond))) << i;
    }
  }
  EXPECT_GT(quotients, times(500));
}

TEST(FilterRayTriangle, AnyTameNumbers_AreMissedSurelyOrWithinTheirBounds) {
  NastyDoubles nasty(7);
  int missed = 0;
  int sure = 0;
  for (int i = 0; i < times(4000); ++i) {
    const Triangle<double> triangle =
        i % 4 == 0 ? Triangle<double>{nasty.vector(), nasty.vector(), nasty.vector()}
                   : Triangle<double>{nasty.ordinaryVector(), nasty.ordinaryVector(), nasty.ordinaryVector()};
    const Ray<double> ray =
        i % 2 == 0 ? Ray<double>{nasty.vector(), nasty.vector()} : aimedRay(nasty, triangle);
    if (!isTame(ray) || !isTame(triangle))
      continue;
    const auto filtered = filterRayTriangle(ray, triangle);
    const auto exact = intersectRayTrianglePlucker(exactly(ray), exactly(triangle));
    if (const auto which = surelyCaseOf(filtered)) { // law (1) of both
      ++sure;
      ASSERT_EQ(*which, exact.which) << i;
    }
    if (filtered.surelyMissed) {
      ++missed;
      continue;
    }
    for (std::size_t edge = 0; edge < 3; ++edge) // law (2)
      ASSERT_TRUE(holds(filtered.bounded.products[edge], exact.products[edge])) << i;
    ASSERT_TRUE(holds(filtered.bounded.sum, exact.sum)) << i;
    const auto volume = intersectRayTriangleCramer(exactly(ray), exactly(triangle)).detT;
    ASSERT_TRUE(holds(filtered.bounded.volume, volume)) << i;
  }
  EXPECT_GT(missed, times(100));
  EXPECT_GT(sure - missed, times(20));
}

} // namespace
} // namespace halfspace
