// A sentence is a claim: it is said only where it holds. Thousands of scenes, the special cases beside them
// too, are asked what they say, and each sentence is weighed by its condition in claims/.
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/construction_ids.h"
#include "tests/lessons/construction/random_objects.h"
#include "tests/test_name.h"

#include "lessons/object/coordinate_limits.h"
#include "lessons/object/corners.h"
#include "lessons/object/solid.h"
#include "tests/effort.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

using namespace test;

/// As many as it takes to come to every sentence that is not the rarest.
constexpr int scenesPerWriting = effort(400);
constexpr std::array writings{Writing::SmallIntegers, Writing::Halves, Writing::Fractions};

/// Of so many scenes each special arrangement has one.
constexpr int scenesForOneOfEach = 8;

/// So many of a scene's special neighbours are visited, others in the next scene: a solid has dozens.
constexpr std::size_t mostNeighbours = 6;

/// All that is said of the objects, by the ids of the lines; that of the case has none.
std::vector<std::pair<std::string, std::string>> textsAbout(const Construction &construction,
                                                            const std::vector<Object> &objects) {
  const Evaluation evaluation = evaluate(sceneOf(construction, objects));
  const Outcome &outcome = lastOutcome(evaluation);
  std::vector<std::pair<std::string, std::string>> texts{{"", outcome.told->description}};
  for (const std::string &id : outcome.explanation->ids())
    texts.emplace_back(id, outcome.explanation->find(id)->sentence);
  return texts;
}

/// Its vectors point nowhere, and its corners are one point, where it can be so.
void makeZero(Object &object) {
  Object zero = object;
  for (std::size_t i = 0; i < coordinatesOf(zero).size(); ++i)
    coordinate(zero, i) = ExactVec3(0);
  zero.kind().settle(zero);
  if (!refusedCoordinateOf(zero))
    object = zero;
}

/// Planes and lines have constants of zero then.
void bringToOrigin(std::vector<Object> &objects) {
  for (Object &object : objects) {
    object[0] = ExactVec3(0);
    object.kind().settle(object);
  }
}

/// Of a triangle: its last corner is moved until the sides at a corner, the first or second, are
/// perpendicular.
void makeRightAngle(Object &object, std::size_t corner) {
  if (kindOf(object) == TriangleObject::kind)
    object[2] = object[corner] + cross(object[1] - object[0], object[2] - object[0]);
}

/// Of a triangle, polygon or prism; of others none.
std::vector<std::size_t> someCornersOf(const Object &object) {
  return kindOf(object) == TriangleObject::kind ? std::vector<std::size_t>{0, 1, 2} : cornersOf(object);
}

/// The last corner comes to another place, which is told by the first two.
template <class Place> void moveLastCorner(Object &object, Place place) {
  const std::vector<std::size_t> corners = someCornersOf(object);
  if (corners.empty())
    return;
  object[corners.back()] = place(object[corners[0]], object[corners[1]]);
  object.kind().settle(object);
}

void bringCornersTogether(Object &object) {
  moveLastCorner(object, [](const ExactVec3 &first, const ExactVec3 &) { return first; });
}

void bringCornersIntoLine(Object &object) {
  moveLastCorner(object, [](const ExactVec3 &first, const ExactVec3 &second) -> ExactVec3 {
    return second * Rational(2) - first;
  });
}

/// A place on a solid, with the faces that it lies on.
struct PlaceOnSolid {
  ExactVec3 at;
  std::vector<std::size_t> faces;
};

/// Where the corners are, or the middles of the edges.
std::vector<PlaceOnSolid> placesOn(const SolidMesh<Rational> &mesh, bool areMiddles) {
  std::vector<PlaceOnSolid> places;
  for (const auto &face : mesh.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t from = face[i];
      const std::uint32_t to = areMiddles ? face[(i + 1) % face.size()] : from;
      PlaceOnSolid place{ExactVec3((mesh.vertices[from] + mesh.vertices[to]) / Rational(2)), {}};
      for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        if (std::ranges::count(mesh.faces[f], from) > 0 && std::ranges::count(mesh.faces[f], to) > 0)
          place.faces.push_back(f);
      places.push_back(std::move(place));
    }
  return places;
}

/// Of a solid and a ray, which then goes in through a corner, or the middle of an edge, and comes out through
/// another: two that have no face in common.
void aimThrough(std::vector<Object> &objects, bool entersMiddle, bool leavesMiddle) {
  if (!findSolidKind(kindOf(objects.front())))
    return;
  const SolidMesh<Rational> mesh = meshOf(objects.front());
  for (const PlaceOnSolid &in : placesOn(mesh, entersMiddle))
    for (const PlaceOnSolid &out : placesOn(mesh, leavesMiddle))
      if (std::ranges::find_first_of(in.faces, out.faces) == in.faces.end()) {
        objects.back()[0] = in.at * Rational(2) - out.at;
        objects.back()[1] = out.at - in.at;
        return;
      }
}

/// What comes by chance too seldom.
void arrange(std::vector<Object> &objects, int arrangement) {
  switch (arrangement) {
  case 0:
    return bringToOrigin(objects);
  case 1:
    aimThrough(objects, false, false);
    return makeRightAngle(objects.front(), 0);
  case 2:
    bringToOrigin(objects);
    aimThrough(objects, true, false);
    return makeRightAngle(objects.front(), 1);
  case 3:
    std::for_each(objects.begin(), objects.end(), makeZero);
    return;
  case 4:
    return makeZero(objects.back());
  case 5:
    aimThrough(objects, false, true);
    return bringCornersTogether(objects.front());
  case 6:
    aimThrough(objects, true, true);
    return bringCornersIntoLine(objects.front());
  default:
    return; // as they came
  }
}

/// The objects after a step into special cases nearby, in the next round into others.
std::vector<std::vector<Object>> specialNeighbours(const Construction &construction,
                                                   const std::vector<Object> &objects, int round) {
  std::vector<std::vector<Object>> neighbours;
  const Evaluation evaluation = evaluate(sceneOf(construction, objects));
  const auto &nearby = *lastOutcome(evaluation).nearby;
  const std::size_t step = nearby.size() / mostNeighbours + 1;
  for (std::size_t next = static_cast<std::size_t>(round) % step; next < nearby.size(); next += step) {
    const SpecialCase &special = nearby[next];
    if (!special.object || refusedCoordinateOf(*special.object))
      continue;
    std::size_t index = special.place;
    for (const ConstructionRole &role : construction.roles) {
      if (role.name == special.role)
        break;
      index += countIn(role, construction.roles.size(), objects.size());
    }
    neighbours.push_back(objects);
    neighbours.back().at(index) = *special.object;
  }
  return neighbours;
}

std::string describe(const std::vector<Object> &objects) {
  std::string text;
  for (const Object &object : objects) {
    text += std::string(kindOf(object));
    for (std::size_t i = 0; i < coordinatesOf(object).size(); ++i) {
      const ExactVec3 &at = coordinate(object, i);
      text += " (" + toText(at.x) + ", " + toText(at.y) + ", " + toText(at.z) + ")";
    }
    text += "; ";
  }
  return text;
}

/// What stands in the place of a name, so that it is no sentence itself.
const std::set<std::string, std::less<>> names{
    "the face {axis}{value}", "the face {corners}", "the base", "the top",        "the side at {edge}",
    "{before} and {last}",    "{before}, {last}",   "distance", "signed distance"};

/// Pieces of sentences stand in another order elsewhere, or with other endings.
bool isWhole(const Said &said) {
  return said.text.ends_with('.') || said.text.ends_with('?') || names.contains(said.english);
}

class ClaimsOfConstruction : public testing::TestWithParam<std::string> {
protected:
  ClaimsOfConstruction()
      : m_construction(*findConstruction(GetParam())), m_claims(claimsOf(m_construction)) {}

  void weighEverythingSaid(const std::vector<Object> &objects) {
    std::vector<const Object *> pointers;
    for (const Object &object : objects)
      pointers.push_back(&object);
    for (const auto &[line, text] : textsAbout(m_construction, objects))
      for (Said &said : sentencesIn(text)) {
        said.line = line;
        weigh(said, text, pointers, objects);
      }
  }

  void weigh(const Said &said, const std::string &text, Objects pointers,
             const std::vector<Object> &objects) {
    const auto found = m_claims.find(said.english);
    if (found == m_claims.end()) {
      if (m_unweighed.insert(said.english).second)
        ADD_FAILURE() << "nobody says what this claims: " << said.english << "\n  in: " << withoutMarks(text);
      return;
    }
    m_heard.insert(said.english);
    if (!isWhole(said) && m_false.insert(said.english).second)
      ADD_FAILURE() << "a piece of a sentence: " << said.english << "\n  in: " << withoutMarks(text);
    if (!found->second(pointers, said) && m_false.insert(said.english).second)
      ADD_FAILURE() << "false: " << said.line << ": " << withoutMarks(text)
                    << "\n  of: " << describe(objects);
  }

  /// A claim about a sentence that is never said weighs nothing.
  void expectAllHeard() const {
    for (const auto &[english, claim] : m_claims)
      EXPECT_TRUE(m_heard.contains(english)) << "never said: " << english;
  }

  const Construction &m_construction;
  const Claims &m_claims;

private:
  MarkedSentences m_marked;
  std::set<std::string> m_heard;
  std::set<std::string> m_unweighed;
  std::set<std::string> m_false;
};

TEST_P(ClaimsOfConstruction, InEveryScene_Hold) {
  for (const Writing writing : writings) {
    RandomObjects random(7'100'000 + static_cast<std::uint64_t>(writing));
    for (int i = 0; i < scenesPerWriting; ++i) {
      std::vector<Object> objects = random.objectsFor(m_construction, writing);
      arrange(objects, i % scenesForOneOfEach);
      weighEverythingSaid(objects);
      for (const auto &neighbour : specialNeighbours(m_construction, objects, i / scenesForOneOfEach))
        weighEverythingSaid(neighbour);
    }
  }
  // Fewer scenes do not come to every sentence.
  if (!isWatched)
    expectAllHeard();
}

INSTANTIATE_TEST_SUITE_P(Claims, ClaimsOfConstruction, testing::ValuesIn(test::constructionIds()),
                         test::testName);

TEST(MarkedSentences, OfSentencesWithinOthers_AreToldWithTheirTexts) {
  const MarkedSentences marked;
  const std::string text =
      words("{which} lies {where}.", {{"which", words("point {name}", {{"name", "Q"}})}, {"where", "there"}});
  const std::vector<Said> said = sentencesIn(text);
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(said[0].english, "point {name}");
  EXPECT_EQ(said[0].at("name"), "Q");
  EXPECT_EQ(said[1].english, "{which} lies {where}.");
  EXPECT_EQ(said[1].at("which"), "point Q");
  EXPECT_EQ(said[1].at("where"), "there");
  EXPECT_EQ(withoutMarks(text), "point Q lies there.");
}

} // namespace
} // namespace halfspace
