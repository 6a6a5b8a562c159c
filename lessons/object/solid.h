// Solids, of whatever kind they are: what constructions look at that take a box as well as a prism.
#pragma once

#include "geometry/solid.h"
#include "lessons/figure/mark.h"
#include "lessons/object/given.h"
#include "lessons/object/surroundings.h"

namespace halfspace {

/// What a kind says of its objects that are solids. It stands in the file of the kind, and here among
/// `solidKinds`.
struct SolidKind {
  std::string_view word; ///< of the kind
  /// Corners and faces; the faces all run the same way round, outwards or inwards.
  SolidMesh<Rational> (*mesh)(const Object &);
  /// A corner in the letters of the object: P₁, P₁ + h; and the way along an edge: P₂ − P₁, h.
  Term (*corner)(const Given<Object> &, std::size_t index);
  Term (*way)(const Given<Object> &, std::size_t from, std::size_t to);
  /// A face in plain words, for sentences: the base, the face P₀P₁P₂.
  std::string (*face)(const Given<Object> &, std::size_t index);
};

[[nodiscard]] const std::vector<SolidKind> &solidKinds();

/// The kind of a solid by its word, or null.
[[nodiscard]] const SolidKind *findSolidKind(std::string_view word);

/// A solid as a construction looks at it.
struct SolidObject {
  static constexpr std::string_view kind = "solid"; ///< of a role, in which any of the kinds may stand

  Given<Object> own;        ///< as what it is in the scene
  SolidMesh<Rational> mesh; ///< faces counterclockwise seen from outside, where it has an inside
};

template <> [[nodiscard]] Given<SolidObject> as<SolidObject>(const Given<Object> &given);

/// The corners and faces of an object that is a solid; the faces counterclockwise seen from outside, where it
/// has an inside.
[[nodiscard]] SolidMesh<Rational> meshOf(const Object &solid);

/// Whether all corners lie in one plane, so that there is no inside.
[[nodiscard]] bool isFlat(const SolidMesh<Rational> &mesh);

/// A corner and the way along an edge in the letters of the object, and a face in plain words.
[[nodiscard]] Term cornerTerm(const Given<SolidObject> &solid, std::size_t index);
[[nodiscard]] Term wayTerm(const Given<SolidObject> &solid, std::size_t from, std::size_t to);
[[nodiscard]] std::string faceName(const Given<SolidObject> &solid, std::size_t index);

/// The words of the kinds that can stand in a role of this kind: itself, or all solids.
[[nodiscard]] std::vector<std::string_view> kindsSeenAs(std::string_view kind);
/// Whether an object of a kind can stand where one is needed: a box for a box, or for a solid.
[[nodiscard]] bool canStandFor(std::string_view needed, std::string_view kind);

/// Adds the faces of a solid as marks, and what others can snap to on it: all its corners and edges.
void drawSolid(const Given<Object> &given, std::vector<Mark> &marks);
void offerSolid(const Given<Object> &given, Surroundings &found);

namespace object_kinds {
[[nodiscard]] SolidKind boxSolid();
[[nodiscard]] SolidKind tetrahedronSolid();
[[nodiscard]] SolidKind prismSolid();
} // namespace object_kinds

} // namespace halfspace
