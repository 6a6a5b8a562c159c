// A kind of objects. Each stands in one file of lessons/object/, and its file's name in the list of
// lessons/CMakeLists.txt, from which the table is generated. From it follow the file format, the names for
// --set, the rows of the inspector, the handles, the picture and what others snap to.
#pragma once

#include "lessons/figure/mark.h"
#include "lessons/object/binding.h"
#include "lessons/object/given.h"
#include "lessons/object/handle.h"
#include "lessons/object/surroundings.h"

namespace halfspace {

/// All that is said of a kind. None of it has a default: what is left out does not compile.
struct Kind {
  std::string_view word;          ///< in files, in small letters: plane
  std::string (*noun)();          ///< in sentences, with its article: “a plane”
  std::string_view meaning;       ///< for the documentation, in half a sentence
  std::optional<Subject> subject; ///< of its marks, by which further objects take another look; nothing of a
                                  ///< thing, which needs none, and of what is not drawn
  /// With all vertices that there may be, which stand last. A direction starts from the first coordinate, a
  /// position.
  std::vector<CoordinateSpec> coordinates;
  std::size_t leavableVertices; ///< so many of the last vertices may be missing
  std::shared_ptr<const MeshShape>
      shape;                      ///< that its objects begin with; null where they have coordinates alone
  std::optional<Binding> binding; ///< of what lies on another object; nothing for free ones
  /// Brings the coordinates within what the kind allows: a number within its bounds, a length not below 0.
  void (*settle)(Object &);
  /// The marks, with the ids of the object and its coordinates: `E`, `E.n`. What has no length or no area is
  /// left out.
  std::vector<Mark> (*draw)(const Given<Object> &);
  /// The handles besides those of positions and directions.
  std::vector<Handle> (*ownHandles)(const std::string &name, const Object &);
  /// Adds what others can snap to on it.
  void (*offer)(const Given<Object> &, Surroundings &);
  /// Adds what a handle of one of its coordinates catches at, besides the places that every position catches
  /// at.
  void (*aim)(const Given<Object> &, const Handle &, const Surroundings &, std::vector<SnapTarget> &);

  [[nodiscard]] std::size_t fewestCoordinates() const { return coordinates.size() - leavableVertices; }
};

/// All kinds, in the order of the CMake list.
[[nodiscard]] const std::vector<Kind> &kinds();

/// The kind of this word, or null.
[[nodiscard]] const Kind *findKind(std::string_view word);

/// What an object, or those that may stand in a role, are called in sentences: “a plane”. The word is that of
/// a kind, or of solids.
[[nodiscard]] std::string nounOf(std::string_view kind);

/// The word of the kind that others look at: of a bound object it is a point, of a box a solid.
[[nodiscard]] std::string_view seenKindOf(const Object &object);

// For kinds that have none:
void settleNothing(Object &object);
[[nodiscard]] std::vector<Mark> drawNothing(const Given<Object> &given);
[[nodiscard]] std::vector<Handle> noHandles(const std::string &name, const Object &object);
void offerNothing(const Given<Object> &given, Surroundings &found);
void aimAtNothing(const Given<Object> &given, const Handle &handle, const Surroundings &found,
                  std::vector<SnapTarget> &targets);

// What several kinds have:

/// What the mark of the whole object has; its label is the object's letter.
[[nodiscard]] MarkBase wholeOf(const Given<Object> &given, Subject subject);
/// What the mark of a coordinate has.
[[nodiscard]] MarkBase partOf(const Given<Object> &given, std::size_t index, Subject subject);
/// The point of a position, and the arrow of a direction ≠ 0 from the first position.
[[nodiscard]] PointMark pointMark(const Given<Object> &given, std::size_t index, Subject subject);
[[nodiscard]] ArrowMark arrowMark(const Given<Object> &given, std::size_t index, Subject subject);

/// Adds the points of all positions.
void addPoints(const Given<Object> &given, Subject subject, std::vector<Mark> &marks);
/// Adds a face: filled where it is flat and convex; else its sides alone, as marks that accompany it.
void addFace(const MarkBase &base, const std::vector<ExactVec3> &corners, std::vector<Mark> &marks);
/// The id of the mark of a face: that of the object for the first, one that accompanies it for the others.
[[nodiscard]] std::string faceId(const std::string &object, std::size_t face);
/// Adds faces, given by the indices of their corners. The first is the mark of the whole
/// object, the others accompany it.
void addFaces(const Given<Object> &given, Subject subject, const std::vector<ExactVec3> &corners,
              const std::vector<std::vector<std::size_t>> &faces, std::vector<Mark> &marks);

/// Adds the object's position as a point, “start Q”.
void offerPoint(const Given<Object> &given, std::size_t index, std::string words, Surroundings &found);
/// Adds a coordinate as a vertex; the edge between two, where they differ; and the corners of a face in their
/// order, with the edges between neighbours.
void offerVertex(const Given<Object> &given, std::size_t index, Surroundings &found);
void offerEdge(const Given<Object> &given, std::size_t from, std::size_t to, Surroundings &found);
void offerRing(const Given<Object> &given, const std::vector<std::size_t> &corners, Surroundings &found);

/// Perpendicular to the plane of the first three positions; zero where they lie on one line.
[[nodiscard]] ExactVec3 normalOfCorners(const Object &object);
/// Adds the first three positions as vertices, with the edges between them and their plane.
void offerCorners(const Given<Object> &given, Surroundings &found);
/// Adds what a direction that leads somewhere catches at.
void aimDirections(const Given<Object> &given, const Handle &handle, const Surroundings &found,
                   std::vector<SnapTarget> &targets);
/// The same, and what the start of that direction catches at, of a line or a ray: the first two coordinates.
void aimStartAndDirection(const Given<Object> &given, const Handle &handle, const Surroundings &found,
                          std::vector<SnapTarget> &targets);

/// One handle, which moves all positions together: at or above their middle, snapped as the first.
[[nodiscard]] std::vector<Handle> wholeHandle(const std::string &name, const Object &object);
/// The handle of a length: on an axis (0, 1, 2) from the first position.
[[nodiscard]] Handle lengthHandle(const std::string &name, const Object &object, std::size_t index, int axis);
/// Settles an object whose lengths are not below 0.
void settleLengths(Object &object);

} // namespace halfspace
