#include "geometry/intersect_line_sphere.h"
#include "geometry/ray.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace halfspace {
namespace {

using SurdVec3 = std::array<Surd, 3>;

/// The vectors A and B and the number n of A + B·√n, where all coordinates share the root.
struct Parts {
  ExactVec3 rational{};
  ExactVec3 factor{};
  Rational radicand = 1;
};

Parts partsOf(const SurdVec3 &vector) {
  Parts parts;
  for (int axis = 0; axis < 3; ++axis) {
    const Surd &value = vector[static_cast<std::size_t>(axis)];
    parts.rational[axis] = value.rationalPart();
    parts.factor[axis] = value.rootFactor();
    if (!value.isRational())
      parts.radicand = value.radicand();
  }
  return parts;
}

bool rootsAreShared(const SurdVec3 &vector) {
  const Parts parts = partsOf(vector);
  return std::all_of(vector.begin(), vector.end(), [&](const Surd &value) {
    return value.isRational() || value.radicand() == parts.radicand;
  });
}

/// Whether |A + B·√n|² is the square, its part with the root zero.
bool hasSquare(const Parts &v, const Rational &square) {
  return dot(v.rational, v.rational) + dot(v.factor, v.factor) * v.radicand == square &&
         dot(v.rational, v.factor) == 0;
}

bool liesOnSphere(const SurdVec3 &point, const Sphere<Rational> &sphere) {
  Parts fromCenter = partsOf(point);
  fromCenter.rational -= sphere.center;
  return hasSquare(fromCenter, sphere.radius * sphere.radius);
}

bool liesOnLine(const SurdVec3 &point, const Ray<Rational> &ray) {
  const Parts parts = partsOf(point);
  return isZero(cross(ExactVec3(parts.rational - ray.origin), ray.direction)) &&
         isZero(cross(parts.factor, ray.direction));
}

void expectSoundContact(const SphereContact<Rational> &contact, const Ray<Rational> &ray,
                        const Sphere<Rational> &sphere) {
  EXPECT_TRUE(rootsAreShared(contact.point));
  EXPECT_TRUE(liesOnSphere(contact.point, sphere)); // law (1)
  EXPECT_TRUE(liesOnLine(contact.point, ray));
  EXPECT_TRUE(hasSquare(partsOf(contact.normal), 1)); // law (2)
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<int>(i);
    EXPECT_EQ(contact.t * ray.direction[axis] + ray.origin[axis], contact.point[i]);
    EXPECT_EQ(contact.normal[i] * sphere.radius + sphere.center[axis], contact.point[i]);
  }
}

/// Of two roots of one quadratic, A ∓ B·√n.
bool ascends(const Surd &first, const Surd &second) {
  if (first.isRational())
    return first.rationalPart() < second.rationalPart();
  return first.rationalPart() == second.rationalPart() && first.rootFactor() < 0 && second.rootFactor() > 0;
}

TEST(IntersectLineSphere, RootThatIsNoFraction_StaysARoot) {
  const auto meet =
      intersectLineSphere(ExactVec3(-3, 1, 0), ExactVec3(1, 0, 0), Sphere<Rational>{ExactVec3(0, 0, 0), 2});
  ASSERT_EQ(meet.along.size(), 2U);
  EXPECT_EQ(toText(meet.along[0].t), "3 - sqrt(3)");
  EXPECT_EQ(toText(meet.along[1].point[0]), "sqrt(3)");
  EXPECT_EQ(toText(meet.along[1].normal[0]), "1/2*sqrt(3)");
}

TEST(IntersectLineSphere, AnyLine_HasItsContactsExactlyOnTheSphere) {
  RandomNumbers random(101);
  std::map<SphereContacts, int> contacts;
  for (int i = 0; i < 1500; ++i) {
    const Ray<Rational> ray{random.wholeVector(9), random.nonZeroWholeVector(9)};
    const Sphere<Rational> sphere{random.wholeVector(9), abs(random.nonZeroRational(8))};
    const auto meet = intersectLineSphere(ray.origin, ray.direction, sphere);
    ++contacts[meet.contacts];
    EXPECT_EQ(meet.along.size(), meet.discriminant < 0 ? 0U : meet.discriminant == 0 ? 1U : 2U);
    for (const auto &contact : meet.along)
      expectSoundContact(contact, ray, sphere);
    EXPECT_TRUE(meet.along.size() < 2 || ascends(meet.along[0].t, meet.along[1].t));
  }
  EXPECT_GE(contacts.size(), 2U) << "a number of contacts did not come up";
}

TEST(IntersectLineSphere, DiscriminantBelowZero_MeansTheLineKeepsFartherThanTheRadius) { // law (3)
  RandomNumbers random(102);
  for (int i = 0; i < test::effort(2000); ++i) {
    const Ray<Rational> ray{random.wholeVector(9), random.nonZeroWholeVector(9)};
    const Sphere<Rational> sphere{random.wholeVector(9), abs(random.nonZeroRational(8))};
    const ExactVec3 moment = cross(ExactVec3(sphere.center - ray.origin), ray.direction);
    const Rational squaredDistance = dot(moment, moment) / dot(ray.direction, ray.direction);
    const auto meet = intersectLineSphere(ray.origin, ray.direction, sphere);
    const int side = (squaredDistance - sphere.radius * sphere.radius).sign();
    EXPECT_EQ(meet.discriminant,
              dot(ray.direction, ray.direction) * (sphere.radius * sphere.radius - squaredDistance));
    EXPECT_EQ(meet.contacts, side > 0    ? SphereContacts::None
                             : side == 0 ? SphereContacts::Tangent
                                         : SphereContacts::Two);
  }
}

TEST(IntersectLineSphere, BothT_HaveTheSumAndProductOfTheQuadratic) { // law (4)
  RandomNumbers random(187);
  for (int i = 0; i < test::effort(1500); ++i) {
    const Ray<Rational> ray{random.wholeVector(5), random.nonZeroWholeVector(5)};
    const Sphere<Rational> sphere{random.wholeVector(5), random.integer(1, 6)};
    const auto meet = intersectLineSphere(ray.origin, ray.direction, sphere);
    if (meet.along.empty())
      continue;
    const ExactVec3 m = ray.origin - sphere.center;
    const Rational square = dot(ray.direction, ray.direction);
    const Rational product = (dot(m, m) - sphere.radius * sphere.radius) / square;
    // A − B·√n and A + B·√n, or two fractions.
    const Surd &first = meet.along.front().t;
    const Surd &last = meet.along.back().t;
    const Rational rootSquare = last.rootFactor() * last.rootFactor() * last.radicand();
    EXPECT_EQ(first.rootFactor(), -last.rootFactor());
    EXPECT_EQ(first.rationalPart() + last.rationalPart(), -2 * dot(ray.direction, m) / square);
    EXPECT_EQ(first.rationalPart() * last.rationalPart() - rootSquare, product);
    EXPECT_EQ(product.sign(), meet.origin == SolidLocation::Inside ? -1
                              : meet.origin == SolidLocation::On   ? 0
                                                                   : 1);
  }
}

TEST(IntersectLineSphere, MultipleOfTheDirection_DividesTAndKeepsThePoints) { // law (5)
  RandomNumbers random(188);
  std::map<SphereContacts, int> contacts;
  for (int i = 0; i < 1500; ++i) {
    const Ray<Rational> ray{random.wholeVector(4), random.nonZeroWholeVector(2)};
    const Sphere<Rational> sphere{random.wholeVector(4), random.integer(1, 4)};
    const Rational k = random.nonZeroRational(3);
    const auto meet = intersectLineSphere(ray.origin, ray.direction, sphere);
    auto scaled = intersectLineSphere(ray.origin, ExactVec3(ray.direction * k), sphere);
    ++contacts[meet.contacts];
    if (k < 0)
      std::reverse(scaled.along.begin(), scaled.along.end());
    EXPECT_EQ(scaled.contacts, meet.contacts);
    ASSERT_EQ(scaled.along.size(), meet.along.size());
    for (std::size_t j = 0; j < meet.along.size(); ++j) {
      EXPECT_EQ(scaled.along[j].t, meet.along[j].t * (1 / k));
      EXPECT_EQ(scaled.along[j].point, meet.along[j].point);
      EXPECT_EQ(scaled.along[j].normal, meet.along[j].normal);
    }
  }
  EXPECT_EQ(contacts.size(), 3U) << "a number of contacts did not come up";
}

TEST(IntersectLineSphere, TangentMovedByAHair_TouchesTwiceOrNotAtAll) {
  const Sphere<Rational> sphere{ExactVec3(0, 0, 0), 1};
  for (int k = 0; k <= 60; ++k) {
    const auto at = [&](const Rational &height) {
      return intersectLineSphere(ExactVec3(-5, height, 0), ExactVec3(1, 0, 0), sphere).contacts;
    };
    EXPECT_EQ(at(Rational(1 - powerOfTen(-k))), SphereContacts::Two);
    EXPECT_EQ(at(Rational(1)), SphereContacts::Tangent);
    EXPECT_EQ(at(Rational(1 + powerOfTen(-k))), SphereContacts::None);
  }
}

TEST(IntersectLineSphere, ZeroDirection_KnowsThePlaceOfThePointAlone) {
  const Sphere<Rational> sphere{ExactVec3(0, 0, 0), 2};
  const auto still = intersectLineSphere(ExactVec3(0, 1, 0), ExactVec3(0, 0, 0), sphere);
  EXPECT_EQ(still.origin, SolidLocation::Inside);
  EXPECT_EQ(still.power, -3);
  EXPECT_EQ(still.contacts, SphereContacts::None);
  EXPECT_TRUE(still.along.empty());
}

} // namespace
} // namespace halfspace
