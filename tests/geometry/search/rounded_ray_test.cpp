#include "geometry/search/rounded_ray.h"

#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

bool isInDoubles(const ExactVec3 &origin, const ExactVec3 &direction) {
  const Ray<Rational> ray{origin, direction};
  return RoundedRay(ray).isExact;
}

TEST(RoundedRay, OnlyARayInDoubles_IsExact) {
  EXPECT_TRUE(isInDoubles({1, Rational(3, 8), 0}, {0, 0, -1}));
  EXPECT_FALSE(isInDoubles({1, Rational(1, 3), 0}, {0, 0, -1}));
  EXPECT_FALSE(isInDoubles({1, 0, 0}, {0, Rational(1, 10), -1}));
  EXPECT_FALSE(isInDoubles({powerOfTen(400), 0, 0}, {0, 0, 1}));
  EXPECT_FALSE(isInDoubles({0, 0, 0}, {0, 0, 1 / powerOfTen(400)}));
}

TEST(RoundedRay, ItsNumbers_AreTheNearestDoubles) {
  const Ray<Rational> ray{{1, Rational(1, 3), 0}, {Rational(1, 10), 0, -1}};
  const RoundedRay rounded(ray);
  EXPECT_EQ(rounded.rounded.origin, Vec3<double>(1, 1.0 / 3, 0));
  EXPECT_EQ(rounded.rounded.direction, Vec3<double>(0.1, 0, -1));
}

} // namespace
} // namespace halfspace
