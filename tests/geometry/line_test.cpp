#include "geometry/line.h"
#include "geometry/relate_lines.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

bool contains(const Line<Rational> &line, const ExactVec3 &point) {
  return cross(point, line.direction) == line.moment;
}

/// The square of the distance by dropping a perpendicular, without any moment: the way from p to q less its
/// part in the span of both directions.
Rational squaredDistance(const ExactVec3 &p, const ExactVec3 &d, const ExactVec3 &q, const ExactVec3 &e) {
  const ExactVec3 way = q - p;
  const Rational dd = dot(d, d);
  const Rational de = dot(d, e);
  const Rational ee = dot(e, e);
  const Rational determinant = dd * ee - de * de;
  const Rational alongD = determinant == 0 ? Rational(dot(way, d) / dd)
                                           : Rational((dot(way, d) * ee - dot(way, e) * de) / determinant);
  const Rational alongE =
      determinant == 0 ? Rational(0) : Rational((dot(way, e) * dd - dot(way, d) * de) / determinant);
  const ExactVec3 across = way - d * alongD - e * alongE;
  return dot(across, across);
}

TEST(LineThrough, TwoPoints_ContainsBothAndIsReal) {
  RandomNumbers random(81);
  for (int i = 0; i < test::effort(2000); ++i) {
    const ExactVec3 p = random.vector();
    const ExactVec3 q = p + random.nonZeroVector();
    const Line<Rational> line = lineThrough(p, q);
    EXPECT_TRUE(contains(line, p));
    EXPECT_TRUE(contains(line, q));
    EXPECT_EQ(relation(line), 0); // law (1) of lineAlong
    EXPECT_TRUE(isReal(line));
    EXPECT_EQ(line.direction, ExactVec3(q - p));
    EXPECT_EQ(line.moment, cross(p, q)); // law (1)
    const Line<Rational> back = lineThrough(q, p);
    EXPECT_EQ(back.direction, ExactVec3(-line.direction)); // law (2)
    EXPECT_EQ(back.moment, ExactVec3(-line.moment));
  }
}

TEST(LineAlong, AnyOtherPointOfIt_HasTheSameMoment) { // law (2)
  RandomNumbers random(82);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Ray<Rational> ray{random.vector(), random.nonZeroVector()};
    const Line<Rational> line = lineOf(ray);
    EXPECT_EQ(lineAlong(pointAt(ray, random.rational()), ray.direction).moment, line.moment);
  }
}

TEST(IsReal, SixNumbersOfNoLine_AreNot) {
  EXPECT_FALSE(isReal(Line<Rational>{ExactVec3(1, 0, 0), ExactVec3(1, 0, 0)}));
  EXPECT_FALSE(isReal(Line<Rational>{ExactVec3(0, 0, 0), ExactVec3(1, 2, 3)}));
  EXPECT_FALSE(isReal(Line<Rational>{ExactVec3(0, 0, 0), ExactVec3(0, 0, 0)}));
  EXPECT_EQ(relation(Line<Rational>{ExactVec3(1, 2, 3), ExactVec3(4, 5, 6)}), 32);
  EXPECT_TRUE(isReal(Line<Rational>{ExactVec3(1, 2, 3), ExactVec3(0, 3, -2)}));
}

TEST(NearestToOrigin, AnyLine_IsOnItAndPerpendicularToItsDirection) {
  RandomNumbers random(83);
  for (int i = 0; i < test::effort(2000); ++i) {
    ExactVec3 point = random.vector();
    const ExactVec3 direction = random.nonZeroVector();
    if (i % 5 == 0)
      point = direction * random.rational();
    const Line<Rational> line = lineAlong(point, direction);
    const ExactVec3 nearest = nearestToOrigin(line);
    EXPECT_TRUE(contains(line, nearest));                  // law (1)
    EXPECT_EQ(dot(nearest, direction), 0);                 // law (2)
    EXPECT_EQ(passesThroughOrigin(line), isZero(nearest)); // law (4)
  }
}

TEST(PermutedInnerProduct, AnyLines_IsTheVolumeTheySpanAndItsSignTurnsWithEither) {
  RandomNumbers random(84);
  for (int i = 0; i < test::effort(2000); ++i) {
    const ExactVec3 p = random.vector();
    const ExactVec3 d = random.nonZeroVector();
    const ExactVec3 q = random.vector();
    const ExactVec3 e = random.nonZeroVector();
    const Line<Rational> a = lineAlong(p, d);
    const Line<Rational> b = lineAlong(q, e);
    const Rational product = permutedInnerProduct(a, b);
    EXPECT_EQ(product, -dot(ExactVec3(q - p), cross(d, e))); // law (3)
    EXPECT_EQ(permutedInnerProduct(b, a), product);          // law (1)
    EXPECT_EQ(permutedInnerProduct(lineAlong(p, ExactVec3(-d)), b), -product);
    EXPECT_EQ(permutedInnerProduct(lineThrough(p, ExactVec3(p + d)), b), product);
  }
}

TEST(PermutedInnerProduct, AnySixNumbers_AreScaledWithItAndGiveTwiceTheirRelationWithThemselves) {
  RandomNumbers random(180);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Line<Rational> a{random.vector(), random.vector()};
    const Line<Rational> b{random.vector(), random.vector()};
    const Rational k = random.rational();
    EXPECT_EQ(permutedInnerProduct(Line<Rational>{a.direction * k, a.moment * k}, b),
              permutedInnerProduct(a, b) * k);              // law (2)
    EXPECT_EQ(permutedInnerProduct(a, a), 2 * relation(a)); // law (5)
  }
}

TEST(PermutedInnerProduct, LinePassingCounterclockwise_IsPositive) {
  const Line<Rational> up = lineAlong(ExactVec3(0, 0, 0), ExactVec3(0, 0, 1));
  const Line<Rational> counterclockwise = lineAlong(ExactVec3(1, 0, 0), ExactVec3(0, 1, 0));
  const Line<Rational> clockwise = lineAlong(ExactVec3(1, 0, 0), ExactVec3(0, -1, 0));
  EXPECT_EQ(permutedInnerProduct(up, counterclockwise), 1);
  EXPECT_EQ(permutedInnerProduct(up, clockwise), -1);
}

/// Two lines that are the same, opposite, parallel, meet, or are anything.
std::pair<Ray<Rational>, Ray<Rational>> somePair(int kind, RandomNumbers &random) {
  const Ray<Rational> first{random.wholeVector(9), random.nonZeroWholeVector(9)};
  const ExactVec3 onFirst = pointAt(first, random.rational(3));
  switch (kind) {
  case 0:
    return {first, {onFirst, first.direction * random.nonZeroRational(3)}};
  case 1:
    return {first, {random.wholeVector(9), first.direction * random.nonZeroRational(3)}};
  case 2:
    return {first, {onFirst, random.nonZeroWholeVector(9)}};
  default:
    return {first, {random.wholeVector(9), random.nonZeroWholeVector(9)}};
  }
}

LineLineCase expectedCase(const Ray<Rational> &first, const Ray<Rational> &second) {
  const Rational square = squaredDistance(first.origin, first.direction, second.origin, second.direction);
  if (!isZero(cross(first.direction, second.direction)))
    return square == 0 ? LineLineCase::Intersecting : LineLineCase::Skew;
  if (square != 0)
    return LineLineCase::Parallel;
  return dot(first.direction, second.direction) > 0 ? LineLineCase::Same : LineLineCase::Opposite;
}

TEST(RelateLines, AnyTwo_AgreeWithDroppingAPerpendicular) {
  RandomNumbers random(85);
  std::map<LineLineCase, int> cases;
  for (int i = 0; i < 8000; ++i) {
    const auto [first, second] = somePair(i % 4, random);
    const auto related = relateLines(lineOf(first), lineOf(second));
    ++cases[related.which];
    EXPECT_EQ(related.which, expectedCase(first, second));
    EXPECT_EQ(related.distance,
              Surd::root(squaredDistance(first.origin, first.direction, second.origin, second.direction)));
    EXPECT_EQ(related.perpendicular, dot(first.direction, second.direction) == 0);
    // Law (2), and law (4) of the product.
    EXPECT_EQ(related.product == 0, related.which != LineLineCase::Skew);
    const bool apart = related.which == LineLineCase::Skew || related.which == LineLineCase::Parallel;
    EXPECT_EQ(related.distance.sign(), apart ? 1 : 0); // law (3)
    const ExactVec3 common = cross(first.direction, second.direction);
    if (!isZero(common)) {
      EXPECT_EQ(related.distance, overRoot(abs(related.product), dot(common, common)));
    }
    if (related.which == LineLineCase::Intersecting) { // law (4)
      EXPECT_TRUE(contains(lineOf(first), related.point));
      EXPECT_TRUE(contains(lineOf(second), related.point));
    }
  }
  EXPECT_EQ(cases.size(), 5U) << "a case did not come up";
}

TEST(RelateLines, InTheOtherOrder_GivesTheSame) { // law (1)
  RandomNumbers random(86);
  for (int i = 0; i < test::effort(2000); ++i) {
    const auto [first, second] = somePair(i % 4, random);
    const auto related = relateLines(lineOf(first), lineOf(second));
    const auto swapped = relateLines(lineOf(second), lineOf(first));
    EXPECT_EQ(swapped.which, related.which);
    EXPECT_EQ(swapped.distance, related.distance);
    EXPECT_EQ(swapped.product, related.product);
    EXPECT_EQ(swapped.point, related.point);
    EXPECT_EQ(swapped.perpendicular, related.perpendicular);
  }
}

TEST(RelateLines, MultipleOfOne_MultipliesTheProductAndTurnsSameIntoOpposite) { // law (5)
  RandomNumbers random(181);
  for (int i = 0; i < test::effort(2000); ++i) {
    const auto [first, second] = somePair(i % 4, random);
    const Line<Rational> line = lineOf(first);
    const Rational k = random.nonZeroRational();
    const auto related = relateLines(line, lineOf(second));
    const auto scaled = relateLines({line.direction * k, line.moment * k}, lineOf(second));
    const auto expected = k > 0                                     ? related.which
                          : related.which == LineLineCase::Same     ? LineLineCase::Opposite
                          : related.which == LineLineCase::Opposite ? LineLineCase::Same
                                                                    : related.which;
    EXPECT_EQ(scaled.which, expected);
    EXPECT_EQ(scaled.product, related.product * k);
    EXPECT_EQ(scaled.distance, related.distance);
    EXPECT_EQ(scaled.point, related.point);
    EXPECT_EQ(scaled.perpendicular, related.perpendicular);
  }
}

TEST(RelateLines, PluckerCoordinatesScaled_DescribeTheSameLine) {
  RandomNumbers random(87);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Line<Rational> line = lineAlong(random.vector(), random.nonZeroVector());
    const Rational k = random.nonZeroRational();
    const Line<Rational> scaled{line.direction * k, line.moment * k};
    EXPECT_EQ(relateLines(line, scaled).which, k > 0 ? LineLineCase::Same : LineLineCase::Opposite);
    EXPECT_EQ(nearestToOrigin(scaled), nearestToOrigin(line)); // law (3)
  }
}

TEST(RelateLines, NumbersOfNoLine_AreACaseOfTheirOwn) {
  const Line<Rational> axis = lineAlong(ExactVec3(0, 0, 0), ExactVec3(1, 0, 0));
  const Line<Rational> none{ExactVec3(1, 0, 0), ExactVec3(2, 0, 0)};
  EXPECT_EQ(relateLines(axis, none).which, LineLineCase::NotALine);
  EXPECT_EQ(relateLines(none, axis).which, LineLineCase::NotALine);
  EXPECT_EQ(relateLines(none, axis).product, 2);
}

TEST(NearestPoints, OfAnyTwoLines_AreTheFeetOfTheirCommonPerpendicular) {
  RandomNumbers random(57);
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 point = random.vector();
    const ExactVec3 other = i % 3 == 0 ? point : random.vector();
    const auto first = lineAlong(point, random.nonZeroVector());
    const auto second = lineAlong(other, random.nonZeroVector());
    if (isZero(cross(first.direction, second.direction)))
      continue;
    const auto nearest = nearestPoints(first, second);
    EXPECT_EQ(cross(nearest.first, first.direction), first.moment); // law (1)
    EXPECT_EQ(cross(nearest.second, second.direction), second.moment);
    const ExactVec3 way = nearest.second - nearest.first;
    EXPECT_EQ(dot(way, first.direction), 0);
    EXPECT_EQ(dot(way, second.direction), 0);
    const auto related = relateLines(first, second);
    EXPECT_EQ(isZero(way), related.which == LineLineCase::Intersecting); // law (2)
    EXPECT_EQ(Surd::root(dot(way, way)), related.distance);
    const auto swapped = nearestPoints(second, first); // law (3)
    EXPECT_EQ(swapped.first, nearest.second);
    EXPECT_EQ(swapped.second, nearest.first);
  }
}

TEST(RelateLines, LinesDrawnApart_MeetOnlyAtZero) {
  for (int k = 0; k <= 60; ++k) {
    const Rational gap = powerOfTen(-k);
    const auto related = relateLines(lineAlong(ExactVec3(0, 0, 0), ExactVec3(1, 2, 0)),
                                     lineAlong(ExactVec3(0, 0, gap), ExactVec3(3, -1, 0)));
    EXPECT_EQ(related.which, LineLineCase::Skew);
    EXPECT_EQ(related.distance, Surd(gap));
  }
}

TEST(RelateLines, DoublesWhoseRelationIsRounded_AreLinesAllTheSame) {
  const auto line = lineAlong<double>({0.1, 0.2, 0.3}, {0.7, 0.11, 0.13});
  ASSERT_NE(relation(line), 0);
  EXPECT_EQ(relateLines(line, lineAlong<double>({5, 0, 0}, {0, 0, 1})).which, LineLineCase::Skew);
}

TEST(RelateLines, DoublesOnSmallIntegers_FindTheSameProductAndSkewLines) {
  // Products of integers this small are integers that a double holds.
  RandomNumbers random(88);
  for (int i = 0; i < test::effort(2000); ++i) {
    const auto [first, second] = somePair(3, random);
    const auto exact = relateLines(lineOf(first), lineOf(second));
    const auto rounded = relateLines(lineAlong(toDouble(first.origin), toDouble(first.direction)),
                                     lineAlong(toDouble(second.origin), toDouble(second.direction)));
    EXPECT_EQ(rounded.product, toDouble(exact.product));
    if (exact.which == LineLineCase::Skew) {
      EXPECT_EQ(rounded.which, LineLineCase::Skew);
      EXPECT_DOUBLE_EQ(rounded.distance, toDouble(exact.distance));
    }
  }
}

} // namespace
} // namespace halfspace
