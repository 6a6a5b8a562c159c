// The objects of a scene: what can be dragged and typed.
#pragma once

#include "geometry/vector.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace halfspace {

using ExactVec3 = Vec3<Rational>;

struct Kind;
class MeshShape;

/// What a coordinate is.
enum class CoordinateRole : std::uint8_t {
  Position,  ///< a place in space: three numbers
  Direction, ///< an arrow drawn from the object's first position: three numbers
  Length,    ///< one number, in units of space
  Number,    ///< one number without a unit
};

/// How many numbers a coordinate of this role has.
[[nodiscard]] constexpr int numbersIn(CoordinateRole role) {
  return role == CoordinateRole::Position || role == CoordinateRole::Direction ? 3 : 1;
}

/// One of an object's coordinates, by the name that the notes give it. A point's only coordinate has no name
/// of its own: it goes by the point's.
struct CoordinateSpec {
  std::string_view name;
  CoordinateRole role;
  bool isTheObject = false; ///< it has a name in files; people call it as the object: the value of a number

  /// Whether people call it by the object's name.
  [[nodiscard]] bool goesByObject() const { return name.empty() || isTheObject; }
};

/// A kind's coordinates as a struct, for code that is about this kind: it has the kind's word, and
/// `coordinatesOf` gives references to them in the kind's order, std::tie(self.point, self.normal).
template <class T>
concept TypedObject = requires(T typed) {
  { T::kind } -> std::convertible_to<std::string_view>;
  T::coordinatesOf(typed);
};

/// The coordinates' struct of a kind whose objects have a shape besides.
template <class T>
concept ShapedObject = requires(T typed) {
  { typed.shape } -> std::convertible_to<std::shared_ptr<const MeshShape>>;
};

/// An object: its kind, and as many coordinates as that says; of a kind that says so a shape, which all
/// objects that have it share.
class Object {
public:
  /// A point at the origin.
  Object();
  /// All coordinates zero, with as few vertices as the kind has at least.
  explicit Object(const Kind &kind);
  template <TypedObject T>
  Object(const T &typed); // NOLINT(google-explicit-constructor): a typed object is one

  [[nodiscard]] const Kind &kind() const { return *m_kind; }
  [[nodiscard]] std::size_t size() const { return m_coordinates.size(); }
  /// A coordinate at an index below `size`; a single number is its x.
  [[nodiscard]] const ExactVec3 &operator[](std::size_t index) const { return m_coordinates.at(index); }
  [[nodiscard]] ExactVec3 &operator[](std::size_t index) { return m_coordinates.at(index); }

  /// Puts a vertex at the origin behind all coordinates, or takes the last one away. Requires a kind whose
  /// number of vertices allows it.
  void addVertex();
  void removeLastVertex();

  /// What it is made of; null for a kind of coordinates alone.
  [[nodiscard]] const std::shared_ptr<const MeshShape> &shape() const { return m_shape; }
  /// Requires a kind of objects with a shape, and one.
  void setShape(std::shared_ptr<const MeshShape> shape);

  bool operator==(const Object &other) const;

private:
  const Kind *m_kind;
  std::vector<ExactVec3> m_coordinates;
  std::shared_ptr<const MeshShape> m_shape;
};

/// The word for the object's kind in files: point, plane, ray …
[[nodiscard]] std::string_view kindOf(const Object &object);

/// An object of this kind with all coordinates zero, or nothing for an unknown word.
[[nodiscard]] std::optional<Object> makeObject(std::string_view kind);

/// Names and roles of the object's coordinates, as many as it has.
[[nodiscard]] std::span<const CoordinateSpec> coordinatesOf(const Object &object);

/// The coordinate at an index of `coordinatesOf`; a single number is its x.
[[nodiscard]] inline const ExactVec3 &coordinate(const Object &object, std::size_t index) {
  return object[index];
}
[[nodiscard]] inline ExactVec3 &coordinate(Object &object, std::size_t index) { return object[index]; }

/// The same object by the struct of its kind; nothing where it is of another.
template <TypedObject T> [[nodiscard]] std::optional<T> objectAs(const Object &object);

// --- how typed objects are read and written
// ------------------------------------------------------------------

namespace detail {
inline void write(const ExactVec3 &from, ExactVec3 &to) { to = from; }
inline void write(const Rational &from, ExactVec3 &to) { to = {from, 0, 0}; }
inline void read(const ExactVec3 &from, ExactVec3 &to) { to = from; }
inline void read(const ExactVec3 &from, Rational &to) { to = from.x; }
[[nodiscard]] const Kind &kindNamed(std::string_view word);
} // namespace detail

template <TypedObject T> Object::Object(const T &typed) : Object(detail::kindNamed(T::kind)) {
  std::apply(
      [this](const auto &...values) {
        std::size_t index = 0;
        (detail::write(values, m_coordinates.at(index++)), ...);
      },
      T::coordinatesOf(typed));
  if constexpr (ShapedObject<T>)
    if (typed.shape) // else that of the kind
      m_shape = typed.shape;
}

template <TypedObject T> std::optional<T> objectAs(const Object &object) {
  if (kindOf(object) != T::kind)
    return {};
  T typed;
  std::apply(
      [&](auto &...values) {
        std::size_t index = 0;
        (detail::read(object[index++], values), ...);
      },
      T::coordinatesOf(typed));
  if constexpr (ShapedObject<T>)
    typed.shape = object.shape();
  return typed;
}

} // namespace halfspace
