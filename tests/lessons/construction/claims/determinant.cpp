#include "lessons/object/kinds/vector.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

#include <algorithm>

namespace halfspace::test {
namespace {

struct ThreeVectors {
  explicit ThreeVectors(Objects objects)
      : vectors{{"u", objectAs<VectorObject>(*objects[0])->vector},
                {"v", objectAs<VectorObject>(*objects[1])->vector},
                {"w", objectAs<VectorObject>(*objects[2])->vector}},
        volume(volumeOf("u", "v", "w")) {
    vectors["n"] = perpendicular(vectors.at("u"), vectors.at("v"));
    vectors["p"] = perpendicular(vectors.at("v"), vectors.at("w"));
    vectors["q"] = perpendicular(vectors.at("u"), vectors.at("p"));
  }

  const ExactVec3 &operator[](const std::string &letter) const { return vectors.at(letter); }
  /// In this order, with its sign.
  Rational volumeOf(const std::string &a, const std::string &b, const std::string &c) const {
    return determinant(vectors.at(a), vectors.at(b), vectors.at(c));
  }
  bool isZero(const std::string &letter) const { return vanishes(vectors.at(letter)); }
  bool hasBase() const { return !isZero("n"); }
  bool hasZero() const { return isZero("u") || isZero("v") || isZero("w"); }
  /// Of two vectors ≠ 0, by the equality of Cauchy and Schwarz.
  bool areAlongOneLine(const std::string &a, const std::string &b) const {
    const Rational ab = product(vectors.at(a), vectors.at(b));
    return !isZero(a) && !isZero(b) &&
           ab * ab == product(vectors.at(a), vectors.at(a)) * product(vectors.at(b), vectors.at(b));
  }

  std::map<std::string, ExactVec3> vectors; ///< by their letters, the three and what is made of them
  Rational volume;                          ///< with its sign
};

bool isPositive(const ThreeVectors &at) { return at.volume > 0; }
bool isNegative(const ThreeVectors &at) { return at.volume < 0; }
bool isNothing(const ThreeVectors &at) { return at.volume == 0; }
bool isSomething(const ThreeVectors &at) { return at.volume != 0; }

/// Whether each vector is called by its own letter.
bool areInOrder(const Said &said) {
  return said.at("u") == "u" && said.at("v") == "v" && said.at("w") == "w";
}

/// What the line comes to that names it by its id.
const ExactVec3 &resultOf(const ThreeVectors &at, const Said &said) { return at[said.line]; }

/// How far w reaches along n, times |n|.
Rational reach(const ThreeVectors &at) { return product(at["n"], at["w"]); }

} // namespace

namespace claims {

Claims determinant() {
  return claimsAbout<ThreeVectors>({
      {"{D} is positive: {u}, {v} and {w}, in this order, are right-handed.",
       [](const ThreeVectors &at, const Said &said) { return isPositive(at) && areInOrder(said); }},
      {"{D} is negative: {u}, {v} and {w}, in this order, are left-handed.",
       [](const ThreeVectors &at, const Said &said) { return isNegative(at) && areInOrder(said); }},
      {"D = 0: {u}, {v} and {w} lie in one plane, and the box is flat.",
       [](const ThreeVectors &at) { return isNothing(at) && !at.hasZero(); }},
      {"{first} and {second} lie along one line: the box is flat, and D = 0.",
       [](const ThreeVectors &at, const Said &said) {
         return isNothing(at) && !at.hasZero() && at.areAlongOneLine(said.at("first"), said.at("second"));
       }},
      {"{zero} is the zero vector: there is no box, and D = 0.",
       [](const ThreeVectors &at, const Said &said) { return isNothing(at) && at.isZero(said.at("zero")); }},
      {"Perpendicular to {first} and to {second}.",
       [](const ThreeVectors &at, const Said &said) {
         const ExactVec3 &result = resultOf(at, said);
         return !vanishes(result) && product(result, at[said.at("first")]) == 0 &&
                product(result, at[said.at("second")]) == 0;
       }},
      {"The zero vector: {first} and {second} span no plane.",
       [](const ThreeVectors &at, const Said &said) {
         const std::string first = said.at("first");
         const std::string second = said.at("second");
         return vanishes(resultOf(at, said)) &&
                (at.isZero(first) || at.isZero(second) || at.areAlongOneLine(first, second));
       }},
      {"The area of the base, the parallelogram of {u} and {v}.",
       [](const ThreeVectors &at) { return at.hasBase(); }},
      {"0: {u} and {v} span no base.", [](const ThreeVectors &at) { return !at.hasBase(); }},
      {"This is how far {w} reaches along n: the height of the box.",
       [](const ThreeVectors &at) { return reach(at) > 0; }},
      {"Negative: {w} and n point to different sides of the base.",
       [](const ThreeVectors &at) { return reach(at) < 0; }},
      {"0: {w} is the zero vector.", [](const ThreeVectors &at) { return at.isZero("w"); }},
      {"0: {w} lies in the plane of the base.",
       [](const ThreeVectors &at) { return at.hasBase() && !at.isZero("w") && reach(at) == 0; }},
      {"0: the box has no volume.", isNothing},
      {"Positive: {w} and n are on the same side of the base.",
       [](const ThreeVectors &at) { return reach(at) > 0; }},
      {"Negative: {w} and n are on different sides of the base.",
       [](const ThreeVectors &at) { return reach(at) < 0; }},
      {"The volume of the box: the determinant without its sign.", always},
      {"{u} and {v} have changed places: this is −D.",
       [](const ThreeVectors &at) { return at.volumeOf("v", "u", "w") == -at.volume; }},
      {"Moved on in a circle, to {first}, {second}, {third}: this is D again.",
       [](const ThreeVectors &at, const Said &said) {
         return at.volumeOf(said.at("first"), said.at("second"), said.at("third")) == at.volume;
       }},
      {"By its last column: each number of {w} times what is left without its row and column. Signs: plus, "
       "minus, plus.",
       always},
      {"Three products with plus and three with minus.", always},
      {"The volume of the tetrahedron: a sixth of the box.", isSomething},
      {"0: the four corners lie in one plane.", isNothing},
      {"Each of {v} and {w} is multiplied by the dot product of the other two.", always},
  });
}

} // namespace claims
} // namespace halfspace::test
