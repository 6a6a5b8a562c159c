#include "lessons/object/object.h"

#include "lessons/object/kind.h"
#include "lessons/object/point.h"
#include "lessons/object/solid.h"

#include <cassert>
#include <stdexcept>

namespace halfspace {

Object::Object() : Object(detail::kindNamed("point")) {}

Object::Object(const Kind &kind) : m_kind(&kind), m_coordinates(kind.fewestCoordinates(), ExactVec3(0)) {}

void Object::addVertex() {
  assert(size() < m_kind->coordinates.size());
  m_coordinates.emplace_back(0);
}

void Object::removeLastVertex() {
  assert(size() > m_kind->fewestCoordinates());
  m_coordinates.pop_back();
}

std::string_view kindOf(const Object &object) { return object.kind().word; }

std::optional<Object> makeObject(std::string_view word) {
  const Kind *kind = findKind(word);
  return kind ? std::optional(Object(*kind)) : std::nullopt;
}

std::span<const CoordinateSpec> coordinatesOf(const Object &object) {
  return std::span(object.kind().coordinates).first(object.size());
}

const Kind *findKind(std::string_view word) {
  for (const Kind &kind : kinds())
    if (kind.word == word)
      return &kind;
  return nullptr;
}

std::string_view seenKindOf(const Object &object) {
  if (object.kind().binding)
    return PointObject::kind;
  return findSolidKind(kindOf(object)) ? SolidObject::kind : kindOf(object);
}

const Kind &detail::kindNamed(std::string_view word) {
  const Kind *kind = findKind(word);
  if (!kind)
    throw std::logic_error("a struct of a kind that is not in the list");
  return *kind;
}

} // namespace halfspace
