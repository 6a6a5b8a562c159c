#include "lessons/object/kinds/tetrahedron.h"

#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/object/solid.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

SolidMesh<Rational> mesh(const Object &corners) {
  return {{corners[0], corners[1], corners[2], corners[3]}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
}

Term corner(const Given<Object> &given, std::size_t index) { return coordinateTerm(given, index); }

Term way(const Given<Object> &given, std::size_t from, std::size_t to) {
  return corner(given, to) - corner(given, from);
}

std::string face(const Given<Object> &given, std::size_t index) {
  const SolidMesh<Rational> all = mesh(given.object);
  std::string corners;
  for (const std::uint32_t corner : all.faces[index]) {
    const Symbol &letter = given.letters[corner];
    corners += (corners.empty() || letter.owner.empty() ? "" : ", ") + plainText(letter);
  }
  return words("the face {corners}", {{"corners", corners}});
}

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<Mark> marks;
  drawSolid(given, marks);
  addPoints(given, Subject::Triangle, marks);
  return marks;
}

} // namespace

std::array<Term, 4> cornerTermsOf(const Given<TetrahedronObject> &tetrahedron) {
  return {coordinateTerm(tetrahedron, 0), coordinateTerm(tetrahedron, 1), coordinateTerm(tetrahedron, 2),
          coordinateTerm(tetrahedron, 3)};
}

namespace object_kinds {

SolidKind tetrahedronSolid() { return {TetrahedronObject::kind, mesh, corner, way, face}; }

Kind tetrahedron() {
  return {.word = TetrahedronObject::kind,
          .noun = [] { return words("a tetrahedron"); },
          .meaning = "a tetrahedron by its corners",
          .subject = Subject::Triangle,
          .coordinates = {{"P0", CoordinateRole::Position},
                          {"P1", CoordinateRole::Position},
                          {"P2", CoordinateRole::Position},
                          {"P3", CoordinateRole::Position}},
          .leavableVertices = 0,
          .shape = {},
          .binding = {},
          .settle = settleNothing,
          .draw = draw,
          .ownHandles = wholeHandle,
          .offer = offerSolid,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
