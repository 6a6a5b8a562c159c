// The sentences of constructions, held against what they claim: each stands exactly where its claim holds,
// which is calculated here from the coordinates alone.
#include "geometry/solid_shape.h"
#include "lessons/object/solid.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/random_objects.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <functional>

namespace halfspace {
namespace {

using namespace test;

constexpr int scenesPerWriting = 300;
/// Of so many scenes one has all that it can at the origin, where planes and lines have constants of zero,
/// and another has a triangle with a right angle.
constexpr int scenesForOneOfEach = 4;

/// A scene's objects in the order of the construction's roles, and the number behind a line's id.
struct Given {
  const std::vector<Object> &objects;
  std::size_t index = 0;

  [[nodiscard]] const ExactVec3 &at(std::size_t object, std::size_t coordinate) const {
    return objects[object][coordinate];
  }
};

/// What one of a line's sentences says, by words that stand in it alone.
struct Claim {
  std::string_view words;
  std::function<bool(const Given &)> holds;
};

/// All that a line can say. The line of a case has no id; # stands for a number in the id.
struct Claims {
  std::string_view construction;
  std::string_view line;
  std::vector<Claim> all;
};

// A triangle, the first object.
ExactVec3 sideU(const Given &given) { return given.at(0, 1) - given.at(0, 0); }
ExactVec3 sideV(const Given &given) { return given.at(0, 2) - given.at(0, 0); }
ExactVec3 normalOf(const Given &given) { return perpendicular(sideU(given), sideV(given)); }
bool isTriangle(const Given &given) { return !vanishes(normalOf(given)); }
bool isNoTriangle(const Given &given) { return !isTriangle(given); }

/// s and t of where the line of a ray, the second object, meets the plane of the triangle, by Cramer's rule.
struct Shares {
  Rational s, t;
};
Shares sharesOf(const Given &given) {
  const ExactVec3 back = -given.at(1, 1);
  const ExactVec3 toStart = given.at(1, 0) - given.at(0, 0);
  const Rational whole = determinant(sideU(given), sideV(given), back);
  return {determinant(toStart, sideV(given), back) / whole, determinant(sideU(given), toStart, back) / whole};
}

bool isFlatByShare(const Given &given) { return sharesOf(given).t == 0; }
bool isFlatByAngle(const Given &given) {
  return !isFlatByShare(given) && product(sideU(given), sideV(given)) == 0;
}

// A plane, the first object, and a ray, the second.
bool hasNormal(const Given &given) { return !vanishes(given.at(0, 1)); }
Rational planeConstant(const Given &given) { return product(given.at(0, 0), given.at(0, 1)); }
bool isRectangle(const Given &given) {
  const ExactVec3 &start = given.at(1, 0);
  return !vanishes(perpendicular(start, given.at(0, 1))) &&
         product(start, given.at(0, 1)) != planeConstant(given);
}

// Several planes and a ray, the last object.
const Object &rayOf(const Given &given) { return given.objects.back(); }
bool areAllPlanes(const Given &given) {
  return std::none_of(given.objects.begin(), given.objects.end() - 1,
                      [](const Object &plane) { return vanishes(plane[1]); }) &&
         !vanishes(rayOf(given)[1]);
}
bool someLacksNormal(const Given &given) {
  return std::any_of(given.objects.begin(), given.objects.end() - 1,
                     [](const Object &plane) { return vanishes(plane[1]); });
}

/// Whether n·(Q − P0) and n·r of some plane are such, where the planes and the ray are what they should be.
bool anyPlane(const Given &given,
              const std::function<bool(const Rational &rest, const Rational &slope)> &fits) {
  const Object &ray = rayOf(given);
  return areAllPlanes(given) &&
         std::any_of(given.objects.begin(), given.objects.end() - 1, [&](const Object &plane) {
           return fits(product(plane[1], ExactVec3(ray[0] - plane[0])), product(plane[1], ray[1]));
         });
}
bool liesInAPlane(const Given &given) {
  return anyPlane(given, [](const Rational &rest, const Rational &slope) { return rest == 0 && slope == 0; });
}
bool hitsAPlane(const Given &given) {
  return anyPlane(given, [](const Rational &rest, const Rational &slope) {
    return slope != 0 && rest.sign() * slope.sign() <= 0;
  });
}

// A polygon, the first object, and a ray, the second.
ExactVec3 edgeOf(const Given &given) {
  const Object &corners = given.objects[0];
  return corners[(given.index + 1) % corners.size()] - corners[given.index];
}
/// Six times the volume that the ray's direction spans with the edge: which way round it goes.
Rational turnOf(const Given &given) {
  return determinant(given.at(1, 1), ExactVec3(given.at(0, given.index) - given.at(1, 0)), edgeOf(given));
}
bool hasDirection(const Given &given) { return !vanishes(given.at(1, 1)); }

// A solid, the first object, and a ray, the second; the number is that of a face.
bool isConvex(const Given &given) { return shapeOf(meshOf(given.objects[0])) == SolidShape::Convex; }
bool isConvexWithALine(const Given &given) { return isConvex(given) && hasDirection(given); }

/// Whether the line has an edge of the face that goes around it this way, 1 or −1.
bool hasTurn(const Given &given, int way) {
  const SolidMesh<Rational> mesh = meshOf(given.objects[0]);
  const auto &face = mesh.faces[given.index];
  for (std::size_t i = 0; i < face.size(); ++i) {
    const ExactVec3 &from = mesh.vertices[face[i]];
    const ExactVec3 edge = mesh.vertices[face[(i + 1) % face.size()]] - from;
    if (determinant(given.at(1, 1), ExactVec3(from - given.at(1, 0)), edge).sign() == way)
      return true;
  }
  return false;
}
bool hasOneTurn(const Given &given) { return hasTurn(given, 1) != hasTurn(given, -1); }

enum class Common { Nothing, Point, Surface, Inside };

/// What the ray's line has in common with a convex solid: each face leaves a piece of the line.
Common commonOf(const Given &given) {
  const SolidMesh<Rational> mesh = meshOf(given.objects[0]);
  std::optional<Rational> begin;
  std::optional<Rational> end;
  bool isOnFace = false;
  for (const auto &face : mesh.faces) {
    const ExactVec3 &corner = mesh.vertices[face[0]];
    const ExactVec3 outwards =
        perpendicular(ExactVec3(mesh.vertices[face[1]] - corner), ExactVec3(mesh.vertices[face[2]] - corner));
    const Rational height = product(outwards, ExactVec3(given.at(1, 0) - corner));
    const Rational slope = product(outwards, given.at(1, 1));
    isOnFace = isOnFace || (slope == 0 && height == 0);
    if (slope == 0 && height > 0)
      return Common::Nothing;
    if (slope < 0)
      begin = begin ? std::max(*begin, Rational(-height / slope)) : -height / slope;
    if (slope > 0)
      end = end ? std::min(*end, Rational(-height / slope)) : -height / slope;
  }
  if (*begin > *end)
    return Common::Nothing;
  return *begin == *end ? Common::Point : isOnFace ? Common::Surface : Common::Inside;
}

/// Where all that the line passes goes around it one way.
Claim oneWayClaim(std::string_view words, Common common, int way = 0) {
  return {words, [common, way](const Given &given) {
            return isConvexWithALine(given) && hasOneTurn(given) && (way == 0 || hasTurn(given, way)) &&
                   commonOf(given) == common;
          }};
}

/// How many weights of a point, the second object, are negative.
long negativeWeights(const Given &given) {
  const ExactVec3 n = normalOf(given);
  const ExactVec3 &point = given.at(1, 0);
  if (vanishes(n) || product(n, ExactVec3(point - given.at(0, 0))) != 0)
    return 0;
  long count = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (product(n, perpendicular(ExactVec3(given.at(0, (i + 1) % 3) - point),
                                 ExactVec3(given.at(0, (i + 2) % 3) - point))) < 0)
      ++count;
  return count;
}

std::vector<Claim> normalClaims() {
  return {{"Perpendicular to", isTriangle}, {"The zero vector", isNoTriangle}};
}

std::vector<Claims> claims() {
  return {
      {"ray-plane-substitution",
       "",
       {{"lies in", liesInAPlane},
        {"hits no plane at a single point",
         [](const Given &given) { return liesInAPlane(given) && !hitsAPlane(given); }},
        {"meets no plane ahead",
         [](const Given &given) {
           return areAllPlanes(given) && !liesInAPlane(given) && !hitsAPlane(given);
         }},
        {"is no plane", someLacksNormal},
        {"the ray goes nowhere",
         [](const Given &given) { return !someLacksNormal(given) && vanishes(rayOf(given)[1]); }},
        {"hits ", [](const Given &given) { return hitsAPlane(given) || liesInAPlane(given); }}}},
      {"ray-triangle-perp", "normal", normalClaims()},
      {"ray-triangle-perp", "uperp", {{"perpendicular to u", isTriangle}, {"points nowhere", isNoTriangle}}},
      {"ray-triangle-perp", "vperp", {{"perpendicular to v", isTriangle}, {"points nowhere", isNoTriangle}}},
      {"ray-triangle-perp",
       "similar",
       {{"t is 0", isFlatByShare},
        {"u and v are perpendicular", isFlatByAngle},
        {"have the same shape",
         [](const Given &given) { return !isFlatByShare(given) && !isFlatByAngle(given); }}}},
      {"three-methods", "normal", normalClaims()},
      {"three-methods", "uperp", {{"perpendicular to u", isTriangle}, {"points nowhere", isNoTriangle}}},
      {"three-methods", "vperp", {{"perpendicular to v", isTriangle}, {"points nowhere", isNoTriangle}}},
      {"triangle-degenerate", "normal", normalClaims()},
      {"plane-parametric", "normal", normalClaims()},
      {"ray-plane-picture",
       "D",
       {{"passes through the origin",
         [](const Given &given) { return hasNormal(given) && planeConstant(given) == 0; }},
        {"there is no plane", [](const Given &given) { return !hasNormal(given); }},
        {"Positive", [](const Given &given) { return planeConstant(given) > 0; }},
        {"Negative", [](const Given &given) { return planeConstant(given) < 0; }}}},
      {"ray-plane-picture",
       "rectangle",
       {{"sides of a rectangle", isRectangle},
        {"no corners of a rectangle", [](const Given &given) { return !isRectangle(given); }}}},
      {"ray-polygon-pluecker",
       "edge#",
       {{"Positive", [](const Given &given) { return turnOf(given) > 0; }},
        {"Negative", [](const Given &given) { return turnOf(given) < 0; }},
        {"there is no ray", [](const Given &given) { return !hasDirection(given); }},
        {"there is no edge",
         [](const Given &given) { return hasDirection(given) && vanishes(edgeOf(given)); }},
        {"lie in one plane",
         [](const Given &given) {
           return turnOf(given) == 0 && hasDirection(given) && !vanishes(edgeOf(given));
         }}}},
      {"ray-solid-pluecker",
       "face#",
       {{"there is no line", [](const Given &given) { return isConvex(given) && !hasDirection(given); }},
        {"decide for a convex solid only", [](const Given &given) { return !isConvex(given); }},
        {"Both signs",
         [](const Given &given) {
           return isConvexWithALine(given) && hasTurn(given, 1) && hasTurn(given, -1);
         }},
        {"runs in the plane of",
         [](const Given &given) {
           return isConvexWithALine(given) && !hasTurn(given, 1) && !hasTurn(given, -1);
         }},
        oneWayClaim("only touches the solid", Common::Point),
        oneWayClaim("runs along the surface", Common::Surface),
        oneWayClaim("comes out through", Common::Inside, 1),
        oneWayClaim("goes in through", Common::Inside, -1)}},
      {"line-pluecker",
       "same",
       {{"is another point", [](const Given &given) { return product(given.at(0, 0), given.at(0, 1)) != 0; }},
        {"itself here", [](const Given &given) { return product(given.at(0, 0), given.at(0, 1)) == 0; }}}},
      {"plane-plane",
       "point",
       {{"goes through the origin",
         [](const Given &given) {
           return planeConstant(given) == 0 && product(given.at(1, 0), given.at(1, 1)) == 0;
         }},
        {"The point of the line that is nearest",
         [](const Given &given) {
           return planeConstant(given) != 0 || product(given.at(1, 0), given.at(1, 1)) != 0;
         }}}},
      {"barycentric",
       "",
       {{"One weight is negative", [](const Given &given) { return negativeWeights(given) == 1; }},
        {"Two weights are negative", [](const Given &given) { return negativeWeights(given) == 2; }},
        {"", [](const Given &) { return true; }}}},
  };
}

/// The sentences of a line with this id, each with the number in the place of #.
std::vector<std::pair<std::size_t, std::string>> sentencesOf(const Outcome &outcome, std::string_view line) {
  std::vector<std::pair<std::size_t, std::string>> all;
  if (line.empty())
    return {{0, outcome.told->description}};
  const bool isNumbered = line.ends_with('#');
  for (std::size_t i = 0; i < (isNumbered ? maxListedObjects : 1); ++i) {
    const std::string id =
        isNumbered ? std::string(line.substr(0, line.size() - 1)) + std::to_string(i) : std::string(line);
    if (outcome.explanation->has(id))
      all.emplace_back(i, outcome.explanation->find(id)->sentence);
  }
  return all;
}

void bringToOrigin(std::vector<Object> &objects) {
  for (Object &object : objects) {
    object[0] = ExactVec3(0);
    object.kind().settle(object);
  }
}

/// Of a triangle: the side v is turned until it is perpendicular to u.
void makeRightAngle(Object &object) {
  if (kindOf(object) == TriangleObject::kind)
    object[2] = object[0] + perpendicular(object[1] - object[0], object[2] - object[0]);
}

TEST(Sentences, OfSeededScenes_StandExactlyWhereTheirClaimsHold) {
  for (const Claims &each : claims()) {
    std::vector<bool> isHeard(each.all.size());
    const Construction &construction = *findConstruction(each.construction);
    for (const Writing writing : {Writing::SmallIntegers, Writing::Halves}) {
      RandomObjects random(20'250'000 + static_cast<std::uint64_t>(writing));
      for (int i = 0; i < scenesPerWriting; ++i) {
        std::vector<Object> objects = random.objectsFor(construction, writing);
        if (i % scenesForOneOfEach == 0)
          bringToOrigin(objects);
        if (i % scenesForOneOfEach == 1)
          makeRightAngle(objects.front());
        const Evaluation evaluation = evaluate(sceneOf(construction, objects));
        for (const auto &[index, sentence] : sentencesOf(lastOutcome(evaluation), each.line)) {
          SCOPED_TRACE(std::string(each.construction) + " " + std::string(each.line) + ", scene " +
                       std::to_string(i) + ": " + sentence);
          bool isClaimed = false;
          for (std::size_t k = 0; k < each.all.size(); ++k) {
            const auto &[words, holds] = each.all[k];
            const bool isSaid = sentence.find(words) != std::string::npos;
            isClaimed = isClaimed || isSaid;
            isHeard[k] = isHeard[k] || isSaid;
            ASSERT_EQ(isSaid, holds({objects, index})) << words;
          }
          ASSERT_TRUE(isClaimed) << "a sentence without a claim";
        }
      }
    }
    for (std::size_t k = 0; k < each.all.size(); ++k)
      EXPECT_TRUE(isHeard[k]) << each.construction << " " << each.line
                              << " never says: " << each.all[k].words;
  }
}

} // namespace
} // namespace halfspace
