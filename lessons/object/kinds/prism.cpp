// Prisms: a polygon and the same moved along an arrow.
#include "lessons/object/corners.h"
#include "lessons/object/kind.h"
#include "lessons/object/letters.h"
#include "lessons/object/solid.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

/// The arrow stands second: a direction starts from the first position, and vertices stand last.
constexpr std::size_t height = 1;

/// The base, the top, and a side for each corner of the base, which runs to the next one.
SolidMesh<Rational> mesh(const Object &prism) {
  SolidMesh<Rational> mesh;
  for (const std::size_t corner : cornersOf(prism))
    mesh.vertices.push_back(prism[corner]);
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.faces.resize(2);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.vertices.push_back(mesh.vertices[i] + prism[height]);
    mesh.faces[0].push_back((count - i) % count);
    mesh.faces[1].push_back(i + count);
    mesh.faces.push_back({i, next, next + count, i + count});
  }
  return mesh;
}

/// P₁ of the base, P₁ + h of the top.
Term corner(const Given<Object> &prism, std::size_t index) {
  const std::vector<std::size_t> base = cornersOf(prism.object);
  const Term below = coordinateTerm(prism, base[index % base.size()]);
  return index < base.size() ? below : below + coordinateTerm(prism, height);
}

/// P₁ − P₀ in the base and in the top, h or −h between them.
Term way(const Given<Object> &prism, std::size_t from, std::size_t to) {
  const std::size_t count = cornersOf(prism.object).size();
  const Term up = coordinateTerm(prism, height);
  if ((from < count) != (to < count))
    return from < count ? up : -up;
  return corner(prism, to % count) - corner(prism, from % count);
}

std::string face(const Given<Object> &prism, std::size_t index) {
  if (index < 2)
    return index == 0 ? words("the base") : words("the top");
  const std::vector<std::size_t> base = cornersOf(prism.object);
  const auto letter = [&](std::size_t corner) { return prism.letters[base[corner % base.size()]]; };
  return words("the side at {edge}", {{"edge", edgeName(letter(index - 2), letter(index - 1))}});
}

std::vector<Mark> draw(const Given<Object> &given) {
  std::vector<Mark> marks;
  drawSolid(given, marks);
  if (!isZero(given.object[height]))
    marks.push_back(arrowMark(given, height, Subject::Triangle));
  addPoints(given, Subject::Triangle, marks);
  return marks;
}

} // namespace

namespace object_kinds {

SolidKind prismSolid() { return {"prism", mesh, corner, way, face}; }

Kind prism() {
  return {.word = "prism",
          .noun = [] { return words("a prism"); },
          .meaning = "a prism by the corners of its base, three to eight, and the arrow to its top",
          .subject = Subject::Triangle,
          .coordinates = {{"P0", CoordinateRole::Position},
                          {"h", CoordinateRole::Direction},
                          {"P1", CoordinateRole::Position},
                          {"P2", CoordinateRole::Position},
                          {"P3", CoordinateRole::Position},
                          {"P4", CoordinateRole::Position},
                          {"P5", CoordinateRole::Position},
                          {"P6", CoordinateRole::Position},
                          {"P7", CoordinateRole::Position}},
          .leavableVertices = 5,
          .shape = {},
          .binding = {},
          .settle = settleNothing,
          .draw = draw,
          .ownHandles = wholeHandle,
          .offer = offerSolid,
          .aim = aimDirections};
}

} // namespace object_kinds
} // namespace halfspace
