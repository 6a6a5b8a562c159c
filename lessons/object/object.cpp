#include "lessons/object/object.h"

#include "lessons/object/kind.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/mesh_shape.h"
#include "lessons/object/solid.h"
#include "lessons/words.h"

#include <cassert>
#include <stdexcept>
#include <utility>

namespace halfspace {

Object::Object() : Object(detail::kindNamed("point")) {}

Object::Object(const Kind &kind)
    : m_kind(&kind), m_coordinates(kind.fewestCoordinates(), ExactVec3(0)), m_shape(kind.shape) {}

void Object::addVertex() {
  assert(size() < m_kind->coordinates.size());
  m_coordinates.emplace_back(0);
}

void Object::removeLastVertex() {
  assert(size() > m_kind->fewestCoordinates());
  m_coordinates.pop_back();
}

void Object::setShape(std::shared_ptr<const MeshShape> shape) {
  assert(m_shape && shape);
  m_shape = std::move(shape);
}

bool Object::operator==(const Object &other) const {
  return m_kind == other.m_kind && m_coordinates == other.m_coordinates &&
         (m_shape == other.m_shape || *m_shape == *other.m_shape);
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

std::string nounOf(std::string_view kind) {
  return kind == SolidObject::kind ? words("a solid") : findKind(kind)->noun();
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
