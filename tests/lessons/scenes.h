// Scenes that several tests begin with, and exact values that print themselves.
#pragma once

#include "lessons/object/kind.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/scene/evaluation.h"
#include "lessons/scene/hand/handles.h"
#include "lessons/scene/session.h"

#include <ostream>
#include <stdexcept>

// GoogleTest finds it by the type's own namespace.
namespace glm {
inline void PrintTo(const halfspace::ExactVec3 &v, std::ostream *stream) {
  *stream << "(" << halfspace::toText(v.x) << ", " << halfspace::toText(v.y) << ", " << halfspace::toText(v.z)
          << ")";
}
} // namespace glm

namespace halfspace::test {

inline Rational q(int numerator, int denominator = 1) { return Rational(numerator, denominator); }

inline Entry planeE() { return {"E", PlaneObject{{5, 4, 7}, {1, 2, 2}}}; }
inline Entry pointQ() { return {"Q", PointObject{{11, 15, 8}}}; }
inline Entry rayL() { return {"L", RayObject{{11, 15, 8}, {-1, 3, 2}}}; }
inline Entry triangleT() { return {"T", TriangleObject{{9, 9, 0}, {1, 9, 4}, {5, 2, 9}}}; }

/// A plane and a point with their distance.
inline Scene distanceScene() {
  return {{planeE(), pointQ(), {"distance", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "Q"}}}}}};
}

/// A construction over objects that are named after its roles, those of a list with their places behind; its
/// own entry is called `it`.
inline Scene sceneOf(const Construction &construction, const std::vector<Object> &objects) {
  Scene scene;
  ConstructionUse use{std::string(construction.id), {}};
  std::size_t next = 0;
  for (const ConstructionRole &role : construction.roles) {
    RoleObjects names;
    for (std::size_t place = 0; place < countIn(role, construction.roles.size(), objects.size()); ++place) {
      names.ids.push_back(role.isList ? role.name + std::to_string(place) : role.name);
      scene.entries.push_back({names.ids.back(), objects[next++]});
    }
    use.roles[role.name] = std::move(names);
  }
  scene.entries.push_back({"it", std::move(use)});
  return scene;
}

/// Gives a coordinate of a scene another value; a single number is its x.
inline void setCoordinate(Scene &scene, const CoordinateId &id, const ExactVec3 &value) {
  Object object = *findObject(scene, id.object);
  object[id.index] = value;
  setObject(scene, id.object, std::move(object));
}

/// The outcome of the last construction; the test fails where there is none.
inline const Outcome &lastOutcome(const Evaluation &evaluation) {
  const EvaluatedEntry *last = evaluation.lastConstruction();
  if (!last)
    throw std::out_of_range("no construction");
  return *last->outcome;
}
inline std::string lastCase(const Scene &scene) { return lastOutcome(evaluate(scene)).told->name; }
inline bool isDegenerate(const Scene &scene) { return lastOutcome(evaluate(scene)).told->degenerate; }

/// The lines of the last construction by their own ids: `f`, not `distance.f`.
inline Working ownLines(const Evaluation &evaluation) {
  Working working;
  const Explanation &lines = *lastOutcome(evaluation).explanation;
  for (const std::string &id : lines.ids())
    working.add(*lines.find(id));
  return working;
}
inline Working ownLines(const Scene &scene) { return ownLines(evaluate(scene)); }

/// The scene after edits; the test fails where one is refused.
inline Scene edited(Scene scene, const std::vector<Edit> &edits) {
  for (const Edit &edit : edits) {
    auto next = apply(std::move(scene), edit);
    if (!next)
      throw std::invalid_argument(next.problem().sentence);
    scene = std::move(*next);
  }
  return scene;
}

/// An evaluation in which nothing but these values is there, of an entry `it`.
inline Evaluation withValues(std::vector<NamedValue> values, std::string caseName = {}) {
  const auto nothing = [] { return Explanation(); };
  const auto outcome = std::make_shared<const Outcome>(
      Outcome{{},
              Lazy<CaseWords>([caseName] {
                return CaseWords{caseName, "", false};
              }),
              Lazy<std::vector<NamedValue>>([values] { return values; }),
              Lazy<Explanation>(nothing),
              Lazy<Figure>([] { return Figure(); }),
              Lazy<std::vector<SpecialCase>>([] { return std::vector<SpecialCase>(); }),
              Lazy<Crossings>([] { return Crossings(); }),
              nullptr});
  return {{{"it", "any", {}, {}, {}, outcome}}};
}

/// The handle of a scene with this id; the test fails where there is none.
inline Handle handle(const Scene &scene, const std::string &id) {
  for (Handle &each : handlesOf(scene))
    if (each.id == id)
      return each;
  throw std::out_of_range("no handle " + id);
}

} // namespace halfspace::test
