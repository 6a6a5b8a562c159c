#include "lessons/object/kinds/box.h"

#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/object/solid.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <array>

namespace halfspace {
namespace {

/// Whether a corner has the length along an axis added: x, y, z are the bits 1, 2, 4 of its number.
bool isAcross(std::size_t corner, std::size_t axis) { return (corner >> axis) % 2 == 1; }

SolidMesh<Rational> mesh(const Object &box) {
  SolidMesh<Rational> mesh;
  for (std::size_t i = 0; i < 8; ++i) {
    ExactVec3 corner = box[0];
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (isAcross(i, axis))
        corner[static_cast<int>(axis)] += box[axis + 1].x;
    mesh.vertices.push_back(corner);
  }
  mesh.faces = {{4, 5, 7, 6}, {0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

template <class Kind> Term lengthTerm(const Given<Kind> &box, std::size_t axis) {
  return coordinateTerm(box, axis + 1).marked({});
}

/// P₀ + (a, 0, c)
Term corner(const Given<Object> &box, std::size_t index) {
  Term lowest = coordinateTerm(box, 0);
  if (index == 0)
    return lowest;
  std::vector<Term> way;
  for (std::size_t axis = 0; axis < 3; ++axis)
    way.push_back(isAcross(index, axis) ? lengthTerm(box, axis) : Term(0));
  return lowest + list(std::move(way));
}

/// (a, 0, 0), or backwards (−a, 0, 0)
Term way(const Given<Object> &box, std::size_t from, std::size_t to) {
  std::vector<Term> coordinates;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Term length = lengthTerm(box, axis);
    coordinates.push_back(isAcross(from, axis) == isAcross(to, axis) ? Term(0)
                          : isAcross(to, axis)                       ? length
                                                                     : -length);
  }
  return list(std::move(coordinates));
}

/// By the plane in which it lies: x = 2.
std::string face(const Given<Object> &box, std::size_t index) {
  static constexpr std::array<std::pair<std::size_t, bool>, 6> faces{
      {{2, true}, {2, false}, {1, false}, {1, true}, {0, false}, {0, true}}};
  static constexpr std::array axes{"x", "y", "z"};
  const auto &[axis, isFar] = faces.at(index);
  Rational at = box.object[0][static_cast<int>(axis)];
  if (isFar)
    at += box.object[axis + 1].x;
  return words("the face {axis}{value}", {{"axis", axes.at(axis)}, {"value", relatedText(Term(at))}});
}

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<Mark> marks;
  drawSolid(given, marks);
  marks.push_back(pointMark(given, 0, Subject::Triangle));
  return marks;
}

std::vector<Handle> ownHandles(const std::string &name, const Object &box) {
  return {lengthHandle(name, box, 1, 0), lengthHandle(name, box, 2, 1), lengthHandle(name, box, 3, 2)};
}

} // namespace

BoxTerms termsOf(const Given<BoxObject> &box) {
  return {coordinateTerm(box, 0), {lengthTerm(box, 0), lengthTerm(box, 1), lengthTerm(box, 2)}};
}

namespace object_kinds {

SolidKind boxSolid() { return {BoxObject::kind, mesh, corner, way, face}; }

Kind box() {
  return {.word = BoxObject::kind,
          .noun = [] { return words("a box"); },
          .meaning = "a box along the axes, by its lowest corner and three lengths",
          .subject = Subject::Triangle,
          .coordinates = {{"P0", CoordinateRole::Position},
                          {"a", CoordinateRole::Length},
                          {"b", CoordinateRole::Length},
                          {"c", CoordinateRole::Length}},
          .leavableVertices = 0,
          .shape = {},
          .binding = {},
          .settle = settleLengths,
          .draw = draw,
          .ownHandles = ownHandles,
          .offer = offerSolid,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
