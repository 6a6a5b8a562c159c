// Constructions of distances, middles, mirror images and angles, each beside formulas of its own, on ten
// thousand small whole inputs, the degenerate ones among them: with numbers from −3 to 3 vectors vanish,
// points coincide, and planes and lines are parallel, perpendicular and the same all the time.
#include "lessons/construction/construction.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "tests/effort.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>
#include <string>

namespace halfspace {
namespace {

using namespace test;

constexpr int inputs = effort(10'000);
constexpr int largest = 3;

/// Whole numbers, apart from the program's own.
using Whole = std::array<long, 3>;

long times(const Whole &a, const Whole &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Whole minus(const Whole &a, const Whole &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
bool isNothing(const Whole &a) { return times(a, a) == 0; }
/// (a·a)(b·b) − (a·b)², which is 0 exactly for vectors on one line (Lagrange).
long areaSquare(const Whole &a, const Whole &b) {
  return times(a, a) * times(b, b) - times(a, b) * times(a, b);
}

ExactVec3 exact(const Whole &a) { return {int(a[0]), int(a[1]), int(a[2])}; }

class Seeded {
public:
  explicit Seeded(std::uint64_t seed) : m_engine(seed) {}
  Whole any() { return {one(), one(), one()}; }
  /// Of two like things the second is often a multiple of the first, or at a right angle to it.
  Whole beside(const Whole &first) {
    switch (std::uniform_int_distribution<int>(0, 3)(m_engine)) {
    case 0:
      return {-2 * first[0], -2 * first[1], -2 * first[2]};
    case 1:
      return {-first[1], first[0], 0};
    default:
      return any();
    }
  }

private:
  int one() { return std::uniform_int_distribution<int>(-largest, largest)(m_engine); }
  std::mt19937_64 m_engine;
};

/// What a construction comes to of two objects, in the order of its roles.
class Found {
public:
  Found(const char *id, const Object &first, const Object &second)
      : m_evaluation(evaluate(sceneOf(*findConstruction(id), {first, second}))),
        m_outcome(lastOutcome(m_evaluation)) {}

  [[nodiscard]] const std::string &caseName() const { return m_outcome.told->name; }
  [[nodiscard]] bool has(const std::string &name) const { return find(name) != nullptr; }
  [[nodiscard]] Surd number(const std::string &name) const { return std::get<Surd>(*find(name)); }
  [[nodiscard]] std::optional<Object> made(const std::string &name) const {
    for (const MadeObject &each : m_outcome.objects)
      if (each.name == name)
        return each.object;
    return {};
  }

private:
  [[nodiscard]] const Value *find(const std::string &name) const {
    for (const NamedValue &value : *m_outcome.values)
      if (value.name == name)
        return &value.value;
    return nullptr;
  }

  Evaluation m_evaluation;
  const Outcome &m_outcome;
};

/// The number ≥ 0 whose square this is.
Surd rootOf(long numerator, long denominator = 1) {
  return Surd::root(Rational(int(numerator), int(denominator)));
}

/// Asks about so many inputs; `check` is handed the random numbers. The cases that came up are these.
template <class Check> void sweep(std::uint64_t seed, const std::set<std::string> &cases, Check check) {
  Seeded random(seed);
  std::set<std::string> seen;
  for (int i = 0; i < inputs && !testing::Test::HasFailure(); ++i)
    seen.insert(check(random));
  if (!isWatched) {
    EXPECT_EQ(seen, cases);
  }
}

TEST(PointPoint, OnTenThousandInputs_IsTheRootOfTheSquares) {
  sweep(1, {"apart", "same"}, [](Seeded &random) {
    const Whole a = random.any();
    const Whole b = random.any();
    const Found found("point-point", PointObject{exact(a)}, PointObject{exact(b)});
    EXPECT_EQ(found.caseName(), a == b ? "same" : "apart");
    EXPECT_EQ(found.number("distance"), rootOf(times(a, a) - 2 * times(a, b) + times(b, b)));
    return found.caseName();
  });
}

TEST(Midpoint, OnTenThousandInputs_IsHalfOfTheSum) {
  sweep(2, {"apart", "same"}, [](Seeded &random) {
    const Whole a = random.any();
    const Whole b = random.any();
    const Found found("midpoint", PointObject{exact(a)}, PointObject{exact(b)});
    EXPECT_EQ(found.caseName(), a == b ? "same" : "apart");
    const ExactVec3 middle = objectAs<PointObject>(found.made("M").value())->at;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(middle[axis] * 2, int(a.at(std::size_t(axis)) + b.at(std::size_t(axis))));
    return found.caseName();
  });
}

/// Where a direction leads from a point of the mirror, or a point is seen: times n·n.
Whole mirrored(const Whole &way, const Whole &n) {
  Whole image{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    image.at(axis) = way.at(axis) * times(n, n) - 2 * times(way, n) * n.at(axis);
  return image;
}

TEST(MirrorPoint, OnTenThousandInputs_IsAsFarOnTheOtherSide) {
  sweep(3, {"positive", "negative", "on", "zero-normal"}, [](Seeded &random) {
    const Whole p = random.any();
    const Whole n = random.any();
    const Whole q = random.any();
    const Found found("mirror-point", PlaneObject{exact(p), exact(n)}, PointObject{exact(q)});
    const long f = times(n, q) - times(n, p);
    EXPECT_EQ(found.caseName(), isNothing(n) ? "zero-normal"
                                : f > 0      ? "positive"
                                : f < 0      ? "negative"
                                             : "on");
    EXPECT_EQ(found.made("S").has_value(), !isNothing(n));
    if (isNothing(n))
      return found.caseName();
    const Surd distance = found.number("signed_distance");
    EXPECT_EQ(f < 0 ? -distance : distance, rootOf(f * f, times(n, n)));
    const ExactVec3 image = objectAs<PointObject>(*found.made("S"))->at;
    EXPECT_EQ(ExactVec3((image - exact(p)) * Rational(int(times(n, n)))), exact(mirrored(minus(q, p), n)));
    const ExactVec3 foot = objectAs<PointObject>(*found.made("F"))->at;
    EXPECT_EQ(ExactVec3(foot * Rational(2)), ExactVec3(image + exact(q)));
    return found.caseName();
  });
}

std::string mirrorCase(const Whole &n, const Whole &r, long height, long slope) {
  if (isNothing(n))
    return "zero-normal";
  if (isNothing(r))
    return "zero-direction";
  if (slope == 0)
    return height == 0 ? "in-plane" : "parallel";
  return height * slope > 0 ? "behind" : "hit";
}

TEST(MirrorRay, OnTenThousandInputs_StartsInTheMirrorAndIsTurnedThere) {
  sweep(4, {"hit", "behind", "parallel", "in-plane", "zero-direction", "zero-normal"}, [](Seeded &random) {
    const Whole p = random.any();
    const Whole n = random.any();
    const Whole q = random.any();
    const Whole r = random.beside(n);
    const Found found("mirror-ray", PlaneObject{exact(p), exact(n)}, RayObject{exact(q), exact(r)});
    const long height = times(n, q) - times(n, p);
    const long slope = times(n, r);
    EXPECT_EQ(found.caseName(), mirrorCase(n, r, height, slope));
    EXPECT_EQ(found.made("R").has_value(), found.caseName() == "hit");
    if (found.caseName() != "hit")
      return found.caseName();
    const RayObject sent = objectAs<RayObject>(*found.made("R")).value();
    EXPECT_EQ(ExactVec3((sent.origin - exact(q)) * Rational(int(slope))),
              ExactVec3(exact(r) * Rational(int(-height))));
    EXPECT_EQ(ExactVec3(sent.direction * Rational(int(times(n, n)))), exact(mirrored(r, n)));
    return found.caseName();
  });
}

/// The case of an angle by what its two vectors' products are.
std::string angleCase(const Whole &a, const Whole &b, const char *zero) {
  if (isNothing(a) || isNothing(b))
    return zero;
  return areaSquare(a, b) == 0 ? "parallel" : times(a, b) == 0 ? "perpendicular" : "oblique";
}

/// cos² = (a·b)²/((a·a)(b·b)), where there is an angle.
void expectRatio(const Found &found, const char *name, const Whole &a, const Whole &b) {
  const long squares = times(a, a) * times(b, b);
  EXPECT_EQ(found.has(name), squares != 0);
  if (squares != 0) {
    EXPECT_EQ(found.number(name), rootOf(times(a, b) * times(a, b), squares));
  }
}

TEST(PlaneAngle, OnTenThousandInputs_HasTheCosineOfTheNormalsWithoutSign) {
  sweep(5, {"parallel", "oblique", "perpendicular", "zero-normal"}, [](Seeded &random) {
    const Whole n = random.any();
    const Whole m = random.beside(n);
    const Found found("plane-angle", PlaneObject{exact(random.any()), exact(n)},
                      PlaneObject{exact(random.any()), exact(m)});
    EXPECT_EQ(found.caseName(), angleCase(n, m, "zero-normal"));
    expectRatio(found, "cosine", n, m);
    return found.caseName();
  });
}

TEST(LineAngle, OnTenThousandInputs_HasTheCosineOfTheDirectionsWithoutSign) {
  sweep(6, {"parallel", "oblique", "perpendicular", "zero-direction"}, [](Seeded &random) {
    const Whole v = random.any();
    const Whole w = random.beside(v);
    const Found found("line-angle", LineObject{exact(random.any()), exact(v)},
                      LineObject{exact(random.any()), exact(w)});
    EXPECT_EQ(found.caseName(), angleCase(v, w, "zero-direction"));
    expectRatio(found, "cosine", v, w);
    return found.caseName();
  });
}

TEST(LinePlaneAngle, OnTenThousandInputs_HasTheCosineToTheNormalForASine) {
  const std::set<std::string> cases{"parallel", "oblique", "perpendicular", "zero-direction", "zero-normal"};
  sweep(7, cases, [](Seeded &random) {
    const Whole n = random.any();
    const Whole v = random.beside(n);
    const Found found("line-plane-angle", LineObject{exact(random.any()), exact(v)},
                      PlaneObject{exact(random.any()), exact(n)});
    const std::string toNormal = angleCase(v, n, isNothing(n) ? "zero-normal" : "zero-direction");
    EXPECT_EQ(found.caseName(), toNormal == "parallel"        ? "perpendicular"
                                : toNormal == "perpendicular" ? "parallel"
                                                              : toNormal);
    expectRatio(found, "sine", v, n);
    return found.caseName();
  });
}

std::string planesCase(const Whole &n, const Whole &m, long reach) {
  if (isNothing(n) || isNothing(m))
    return "zero-normal";
  if (areaSquare(n, m) != 0)
    return "meet";
  return reach == 0 ? "coincident" : "parallel";
}

TEST(PlaneDistance, OnTenThousandInputs_IsHowFarTheWayReachesAlongTheNormal) {
  sweep(8, {"meet", "parallel", "coincident", "zero-normal"}, [](Seeded &random) {
    const Whole n = random.any();
    const Whole m = random.beside(n);
    const Whole p = random.any();
    const Whole q = random.any();
    const Found found("plane-distance", PlaneObject{exact(p), exact(n)}, PlaneObject{exact(q), exact(m)});
    const long reach = times(n, minus(q, p));
    EXPECT_EQ(found.caseName(), planesCase(n, m, reach));
    EXPECT_EQ(found.has("distance"), found.caseName() != "zero-normal");
    if (found.has("distance")) {
      EXPECT_EQ(found.number("distance"),
                found.caseName() == "meet" ? Surd(0) : rootOf(reach * reach, times(n, n)));
    }
    return found.caseName();
  });
}

/// Two lines: skew by the volume over the area of the base, parallel by the height of a parallelogram.
TEST(ClosestPoints, OnTenThousandInputs_AnswersForTheDistanceOfTwoLines) {
  sweep(9, {"skew", "meet", "parallel", "coincident", "zero-direction"}, [](Seeded &random) {
    const Whole a = random.any();
    const Whole v = random.any();
    const Whole b = random.any();
    const Whole u = random.beside(v);
    const Found found("closest-points", LineObject{exact(a), exact(v)}, LineObject{exact(b), exact(u)});
    const Whole w = minus(b, a);
    EXPECT_EQ(found.has("distance"), !isNothing(v) && !isNothing(u));
    if (!found.has("distance"))
      return found.caseName();
    const long volume = v[0] * (u[1] * w[2] - u[2] * w[1]) - v[1] * (u[0] * w[2] - u[2] * w[0]) +
                        v[2] * (u[0] * w[1] - u[1] * w[0]);
    EXPECT_EQ(found.number("distance"), areaSquare(v, u) == 0 ? rootOf(areaSquare(w, v), times(v, v))
                                                              : rootOf(volume * volume, areaSquare(v, u)));
    return found.caseName();
  });
}

/// A ray between two mirrors that stand at a right angle comes back the way it went.
TEST(MirrorRay, InTwoMirrorsAtARightAngle_ComesBack) {
  const Scene scene{{{"E", PlaneObject{{0, 0, 0}, {1, 0, 0}}},
                     {"F", PlaneObject{{0, 0, 0}, {0, 1, 0}}},
                     {"L", RayObject{{3, 5, 1}, {-1, -1, 0}}},
                     {"first", ConstructionUse{"mirror-ray", {{"E", "E"}, {"L", "L"}}}},
                     {"second", ConstructionUse{"mirror-ray", {{"E", "F"}, {"L", "first.R"}}}}}};
  const Evaluation evaluation = evaluate(scene);
  const RayObject back = objectAs<RayObject>(lastOutcome(evaluation).objects.at(0).object).value();
  EXPECT_EQ(back.origin, ExactVec3(2, 0, 1));
  EXPECT_EQ(back.direction, ExactVec3(1, 1, 0));
}

} // namespace
} // namespace halfspace
