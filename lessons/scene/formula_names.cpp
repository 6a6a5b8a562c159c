#include "lessons/scene/formula_names.h"

#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"

namespace halfspace {
namespace {

template <class IsMeant>
std::optional<NamedCoordinate> findIn(std::string_view id, const KindOfId &kindOfId, const IsMeant &isMeant) {
  const Kind *kind = kindOfId(id);
  for (std::size_t index = 0; kind && index < kind->fewestCoordinates(); ++index)
    if (const CoordinateSpec &spec = kind->coordinates[index]; isMeant(spec))
      return NamedCoordinate{std::string(id), index, spec.role};
  return {};
}

} // namespace

std::string valueNameOf(const Kind &kind, std::size_t index) {
  if (kind.word == NumberObject::kind && index > 0)
    return {};
  const std::string_view name = kind.coordinates.at(index).name;
  return std::string(name.empty() ? "at" : name);
}

std::optional<NamedCoordinate> coordinateNamed(std::string_view name, const KindOfId &kindOfId) {
  if (auto whole = findIn(name, kindOfId, [](const CoordinateSpec &spec) { return spec.goesByObject(); }))
    return whole;
  const auto dot = name.rfind('.');
  if (dot == std::string_view::npos)
    return {};
  const std::string_view own = name.substr(dot + 1);
  return findIn(name.substr(0, dot), kindOfId, [&](const CoordinateSpec &spec) { return spec.name == own; });
}

} // namespace halfspace
