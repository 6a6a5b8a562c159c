#include "lessons/object/solid.h"

#include "geometry/polygon.h"
#include "lessons/object/kind.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Six times the volume, negative where the faces run the other way round.
Rational signedVolume(const SolidMesh<Rational> &mesh) {
  Rational volume = 0;
  const auto &corners = mesh.vertices;
  for (const auto &face : mesh.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      volume += dot(corners[face[0]], cross(corners[face[i]], corners[face[i + 1]]));
  return volume;
}

/// P₁, or nothing where the corner has no letter of its own.
std::string letterOf(const Term &corner) {
  return corner->kind == TermKind::Name ? plainText(corner) : std::string();
}

std::string edgeWords(const Given<Object> &given, const Term &from, const Term &to) {
  const bool haveLetters = from->kind == TermKind::Name && to->kind == TermKind::Name;
  return haveLetters ? words("edge {name}", {{"name", letterOf(from) + letterOf(to)}})
                     : words("edge of {solid}", {{"solid", plainText(given.symbol)}});
}

std::string cornerWords(const Given<Object> &given, const Term &corner) {
  const std::string letter = letterOf(corner);
  return letter.empty() ? words("corner of {solid}", {{"solid", plainText(given.symbol)}})
                        : words("corner {name}", {{"name", letter}});
}

} // namespace

const std::vector<SolidKind> &solidKinds() {
  using namespace object_kinds;
  static const std::vector<SolidKind> table{boxSolid(), tetrahedronSolid(), prismSolid()};
  return table;
}

const SolidKind *findSolidKind(std::string_view word) {
  const auto &all = solidKinds();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const SolidKind &each) { return each.word == word; });
  return found == all.end() ? nullptr : &*found;
}

SolidMesh<Rational> meshOf(const Object &solid) {
  SolidMesh<Rational> mesh = findSolidKind(kindOf(solid))->mesh(solid);
  if (signedVolume(mesh) < 0)
    for (auto &face : mesh.faces)
      std::reverse(face.begin() + 1, face.end());
  return mesh;
}

template <> Given<SolidObject> as<SolidObject>(const Given<Object> &given) {
  return {given.id, given.symbol, given.letters, {given, meshOf(given.object)}, given.isFree, given.look};
}

bool isFlat(const SolidMesh<Rational> &mesh) {
  const auto corners = weighted(mesh.vertices);
  const Plane<Rational> plane = planeOf<Rational>(corners);
  return std::all_of(corners.begin(), corners.end(),
                     [&](const auto &corner) { return evaluate(plane, corner) == 0; });
}

Term cornerTerm(const Given<SolidObject> &solid, std::size_t index) {
  const Given<Object> &own = solid.object.own;
  return findSolidKind(kindOf(own.object))->corner(own, index);
}

Term wayTerm(const Given<SolidObject> &solid, std::size_t from, std::size_t to) {
  const Given<Object> &own = solid.object.own;
  return findSolidKind(kindOf(own.object))->way(own, from, to);
}

std::string faceName(const Given<SolidObject> &solid, std::size_t index) {
  const Given<Object> &own = solid.object.own;
  return findSolidKind(kindOf(own.object))->face(own, index);
}

std::vector<std::string_view> kindsSeenAs(std::string_view kind) {
  if (kind != SolidObject::kind)
    return {kind};
  std::vector<std::string_view> words;
  words.reserve(solidKinds().size());
  for (const SolidKind &each : solidKinds())
    words.push_back(each.word);
  return words;
}

bool canStandFor(std::string_view needed, std::string_view kind) {
  const auto kinds = kindsSeenAs(needed);
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

void drawSolid(const Given<Object> &given, std::vector<Mark> &marks) {
  const SolidMesh<Rational> mesh = meshOf(given.object);
  std::vector<std::vector<std::size_t>> faces;
  faces.reserve(mesh.faces.size());
  for (const auto &face : mesh.faces)
    faces.emplace_back(face.begin(), face.end());
  addFaces(given, Subject::Triangle, mesh.vertices, faces, marks);
}

void offerSolid(const Given<Object> &given, Surroundings &found) {
  const SolidKind &kind = *findSolidKind(kindOf(given.object));
  const SolidMesh<Rational> mesh = meshOf(given.object);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    found.points.push_back({mesh.vertices[i], cornerWords(given, kind.corner(given, i))});
  for (const FaceEdge &edge : edgesByEnds(mesh.faces)) {
    const ExactVec3 &from = mesh.vertices[edge.from];
    const ExactVec3 &to = mesh.vertices[edge.to];
    // Each is had by two faces, once in each direction.
    if (edge.from < edge.to && from != to)
      found.edges.push_back(
          {from, to, edgeWords(given, kind.corner(given, edge.from), kind.corner(given, edge.to))});
  }
}

} // namespace halfspace
