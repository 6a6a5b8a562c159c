#include "lessons/fitting/objects_between.h"

#include "lessons/formula/plane_through.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/vector.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

/// Two points tell where these start and where they lead.
constexpr std::array leadingKinds{LineObject::kind, RayObject::kind, VectorObject::kind};

/// Its planes cannot stand where planes can: whoever has three points wants a plane.
constexpr std::string_view planeOfLessons = "plane-through-points";

Formula named(const std::string &id) { return {FormulaKind::Name, {}, id}; }

std::string_view kindFor(CoordinateRole role) {
  switch (role) {
  case CoordinateRole::Position:
    return PointObject::kind;
  case CoordinateRole::Direction:
    return VectorObject::kind;
  default:
    return NumberObject::kind;
  }
}

/// Whether an object of the kind is told by so many coordinates, and stands somewhere in space.
bool canBeTold(const Kind &kind, std::size_t coordinates) {
  return !kind.binding && !kind.shape && kind.leavableVertices == 0 && kind.word != planeOfLessons &&
         kind.coordinates.size() == coordinates && kind.coordinates.front().role == CoordinateRole::Position;
}

/// Each coordinate by the first object that is left and fits; nothing where one has none.
std::optional<DerivedObject> toldBy(const Kind &kind, std::vector<SeenObject> objects) {
  if (!canBeTold(kind, objects.size()))
    return {};
  DerivedObject derived{&kind, {}};
  for (const CoordinateSpec &spec : kind.coordinates) {
    const auto fitting = std::find_if(objects.begin(), objects.end(), [&](const SeenObject &each) {
      return each.kind == kindFor(spec.role);
    });
    if (fitting == objects.end())
      return {};
    derived.coordinates.push_back(named(fitting->id));
    objects.erase(fitting);
  }
  return derived;
}

bool areLedThrough(const Kind &kind, std::size_t points) {
  return points == 2 && std::find(leadingKinds.begin(), leadingKinds.end(), kind.word) != leadingKinds.end();
}

/// An object through points that are not its coordinates.
std::optional<DerivedObject> through(const Kind &kind, const std::vector<SeenObject> &points) {
  if (std::any_of(points.begin(), points.end(),
                  [](const SeenObject &each) { return each.kind != PointObject::kind; }))
    return {};
  if (areLedThrough(kind, points.size()))
    return DerivedObject{&kind, {named(points[0].id), wayBetween(named(points[0].id), named(points[1].id))}};
  if (kind.word == PlaneObject::kind && points.size() == 3)
    return planeThrough({points[0].id, points[1].id, points[2].id});
  return {};
}

} // namespace

DerivedObject planeThrough(const std::array<std::string, 3> &points) {
  return {findKind(PlaneObject::kind), planeThrough(named(points[0]), named(points[1]), named(points[2]))};
}

std::vector<DerivedObject> objectsBetween(const std::vector<SeenObject> &objects) {
  std::vector<DerivedObject> found;
  if (objects.size() < 2)
    return found;
  for (const Kind &kind : kinds()) {
    auto derived = toldBy(kind, objects);
    if (!derived)
      derived = through(kind, objects);
    if (derived)
      found.push_back(std::move(*derived));
  }
  return found;
}

} // namespace halfspace
