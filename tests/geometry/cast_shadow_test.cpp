#include "geometry/cast_shadow.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

constexpr int scenes = 10'000;

/// −y + 2z = 0, a slope.
const Plane<Rational> slope{{0, -1, 2}, 0};

TEST(CastBySun, OnASlope_FallsAsFarAsTheLightGoes) {
  const auto shadow = castBySun<Rational>({2, 5, 7}, {2, -1, -2}, slope);
  EXPECT_EQ(shadow.which, ShadowCase::Falls);
  EXPECT_EQ(shadow.t, 3);
  EXPECT_EQ(shadow.place, ExactVec3(8, 2, 1));
}

TEST(CastByLamp, OnASlope_FallsInTheLineOfLampAndPoint) {
  const auto shadow = castByLamp<Rational>({2, 5, 7}, {3, 4, 8}, slope);
  EXPECT_EQ(shadow.which, ShadowCase::Falls);
  EXPECT_EQ(shadow.t, 4);
  EXPECT_EQ(shadow.place, ExactVec3(-1, 8, 4));
}

TEST(CastBySun, WithoutPlaneOrLightOrAlongThePlane_SaysSo) {
  const ExactVec3 point{2, 5, 7};
  const Plane<Rational> none{ExactVec3(0), 1};
  EXPECT_EQ(castBySun(point, ExactVec3(1, 0, 0), none).which, ShadowCase::NoPlane);
  EXPECT_EQ(castBySun(point, ExactVec3(0), slope).which, ShadowCase::NoLight);
  EXPECT_EQ(castBySun(point, ExactVec3(3, 2, 1), slope).which, ShadowCase::Parallel);
  EXPECT_EQ(castBySun(point, ExactVec3(0, 0, 1), slope).which, ShadowCase::PlaneFirst);
  EXPECT_EQ(castBySun(ExactVec3(9, 4, 2), ExactVec3(0, 0, 1), slope).which, ShadowCase::Falls);
}

TEST(CastByLamp, WhereNoShadowFalls_SaysWhy) {
  const ExactVec3 lamp{3, 4, 8};
  const Plane<Rational> none{ExactVec3(0), 1};
  EXPECT_EQ(castByLamp(lamp, lamp, none).which, ShadowCase::NoPlane);
  EXPECT_EQ(castByLamp(lamp, lamp, slope).which, ShadowCase::NoLight);
  EXPECT_EQ(castByLamp(ExactVec3(9, 6, 9), lamp, slope).which, ShadowCase::Parallel);
  EXPECT_EQ(castByLamp(ExactVec3(3, 4, 9), lamp, slope).which, ShadowCase::Away);
  EXPECT_EQ(castByLamp(ExactVec3(3, 4, 1), lamp, slope).which, ShadowCase::PlaneFirst);
  EXPECT_EQ(castByLamp(ExactVec3(3, 4, 2), lamp, slope).which, ShadowCase::Falls);
  const ExactVec3 inPlane{3, 4, 2};
  EXPECT_EQ(castByLamp(ExactVec3(3, 4, 9), inPlane, slope).which, ShadowCase::PlaneFirst);
  EXPECT_EQ(castByLamp(ExactVec3(9, 4, 2), inPlane, slope).which, ShadowCase::Parallel);
}

struct Lit {
  explicit Lit(RandomNumbers &random)
      : plane{random.nonZeroWholeVector(3), Rational(random.integer(-6, 6))}, a(random.wholeVector(5)),
        b(random.wholeVector(5)), light(random.wholeVector(4)) {}

  [[nodiscard]] Plane<Rational> times(const Rational &k) const {
    return {plane.normal * k, Rational(plane.offset * k)};
  }
  [[nodiscard]] ExactVec3 between(const ExactVec3 &from, const ExactVec3 &to, const Rational &s) const {
    return from * Rational(1 - s) + to * s;
  }

  Plane<Rational> plane;
  ExactVec3 a;
  ExactVec3 b;
  ExactVec3 light; ///< the direction of the sun, or the lamp
};

TEST(CastBySun, FallsInThePlaneBehindThePoint) { // law (1)
  RandomNumbers random(201);
  for (int i = 0; i < test::effort(scenes); ++i) {
    const Lit at(random);
    const auto shadow = castBySun(at.a, at.light, at.plane);
    const int side = evaluate(at.plane, at.a).sign();
    const int way = dot(at.plane.normal, at.light).sign();
    EXPECT_EQ(shadow.crosses(), way != 0);
    if (!shadow.crosses())
      continue;
    EXPECT_EQ(shadow.falls(), side * way <= 0) << "towards the plane, or in it";
    EXPECT_EQ(evaluate(at.plane, shadow.place), 0);
    EXPECT_EQ(ExactVec3(shadow.place - at.a), ExactVec3(at.light * shadow.t));
    // n·r A − f(A) r, divided by n·r
    EXPECT_EQ(ExactVec3(shadow.place * dot(at.plane.normal, at.light)),
              ExactVec3(at.a * dot(at.plane.normal, at.light) - at.light * evaluate(at.plane, at.a)));
  }
}

TEST(CastBySun, OfAPointBetweenTwo_IsAsFarBetweenTheirShadows) { // laws (2) and (3)
  RandomNumbers random(202);
  for (int i = 0; i < test::effort(scenes); ++i) {
    const Lit at(random);
    const auto a = castBySun(at.a, at.light, at.plane);
    if (!a.crosses())
      continue;
    const auto b = castBySun(at.b, at.light, at.plane);
    const Rational s = random.rational(3);
    const auto between = castBySun(at.between(at.a, at.b, s), at.light, at.plane);
    EXPECT_EQ(between.place, at.between(a.place, b.place, s));
    EXPECT_EQ(between.t, Rational(a.t * (1 - s) + b.t * s));
    const auto scaled = castBySun(at.a, ExactVec3(at.light * abs(random.nonZeroRational())),
                                  at.times(random.nonZeroRational()));
    EXPECT_EQ(scaled.which, a.which);
    EXPECT_EQ(scaled.place, a.place);
  }
}

TEST(CastByLamp, FallsInThePlaneBehindThePoint) { // laws (1) and (3)
  RandomNumbers random(203);
  for (int i = 0; i < test::effort(scenes); ++i) {
    const Lit at(random);
    const auto shadow = castByLamp(at.a, at.light, at.plane);
    const Rational atLamp = evaluate(at.plane, at.light);
    const Rational atPoint = evaluate(at.plane, at.a);
    EXPECT_EQ(shadow.crosses(), atLamp != atPoint);
    if (!shadow.crosses())
      continue;
    // the point lies between the lamp and the plane, or in the plane
    EXPECT_EQ(shadow.falls(), atPoint * atLamp >= 0 && abs(atPoint) < abs(atLamp));
    EXPECT_EQ(shadow.which == ShadowCase::Away, atPoint * atLamp > 0 && abs(atPoint) > abs(atLamp));
    EXPECT_EQ(evaluate(at.plane, shadow.place), 0);
    EXPECT_TRUE(isZero(cross(shadow.place - at.light, at.a - at.light)));
    const auto scaled = castByLamp(at.a, at.light, at.times(random.nonZeroRational()));
    EXPECT_EQ(scaled.which, shadow.which);
    EXPECT_EQ(scaled.t, shadow.t);
    EXPECT_EQ(scaled.place, shadow.place);
  }
}

TEST(CastByLamp, OfAPointBetweenTwo_LiesByTheInversesOfTheSteps) { // law (2)
  RandomNumbers random(204);
  for (int i = 0; i < test::effort(scenes); ++i) {
    const Lit at(random);
    const auto a = castByLamp(at.a, at.light, at.plane);
    const auto b = castByLamp(at.b, at.light, at.plane);
    const Rational s = random.rational(3);
    const auto between = castByLamp(at.between(at.a, at.b, s), at.light, at.plane);
    if (!a.crosses() || !b.crosses() || !between.crosses() || a.t == 0)
      continue;
    EXPECT_EQ(Rational(1 / between.t), Rational((1 - s) / a.t + s / b.t));
    const auto middle = castByLamp(at.between(at.a, at.b, Rational(1, 2)), at.light, at.plane);
    if (middle.crosses()) {
      EXPECT_EQ(middle.place, at.between(a.place, b.place, Rational(a.t / (a.t + b.t))));
    }
  }
}

} // namespace
} // namespace halfspace
