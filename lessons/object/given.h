// An object with what it is called in its scene.
#pragma once

#include "lessons/figure/look.h"
#include "lessons/object/object.h"
#include "lessons/term/term.h"

namespace halfspace {

/// An object as a construction looks at it, and as it is drawn.
template <class Kind> struct Given {
  std::string id;              ///< `E`, or `distance.F` for what a construction made
  Symbol symbol;               ///< of the object itself
  std::vector<Symbol> letters; ///< of its coordinates, in their order
  Kind object;
  bool isFree = true; ///< its coordinates are those of the scene; not so of what was made, or lies on another
  Look look{};        ///< of its marks
  bool operator==(const Given &) const = default;
};

/// The id of a coordinate and of the mark that shows it: `E.n`; a point's is that of the point.
[[nodiscard]] inline std::string coordinateId(const std::string &object, const CoordinateSpec &spec) {
  return spec.name.empty() ? object : object + "." + std::string(spec.name);
}

/// The same object, which is of this kind, by its kind.
template <class Kind> [[nodiscard]] Given<Kind> as(const Given<Object> &given) {
  return {given.id,     given.symbol, given.letters, objectAs<Kind>(given.object).value(),
          given.isFree, given.look};
}

} // namespace halfspace
