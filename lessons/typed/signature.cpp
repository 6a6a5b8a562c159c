#include "lessons/typed/signature.h"

#include "lessons/construction/construction.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/typed/typed_use.h"

namespace halfspace {
namespace {

/// Where points stand of which the scene has too few: no three on one line, no four in one plane.
ExactVec3 usualPlace(std::size_t index) {
  const int size = 4 * static_cast<int>(1 + index / 4);
  ExactVec3 place(0);
  if (index % 4 > 0)
    place[static_cast<int>(index % 4) - 1] = size;
  return place;
}

const ExactVec3 usualDirection{1, 2, 2};
const Rational usualLength = 4;
/// It lies within every triangle and every segment.
const Rational usualFreedom{1, 4};

ArgumentPlace placeOf(const CoordinateSpec &spec, std::size_t index) {
  switch (spec.role) {
  case CoordinateRole::Position:
    return {PointObject::kind, false, formulaOf(usualPlace(index))};
  case CoordinateRole::Direction:
    return {VectorObject::kind, false, formulaOf(usualDirection)};
  default:
    return {NumberObject::kind, false, Formula{FormulaKind::Number, usualLength}};
  }
}

/// Where something lies is told by numbers alone.
ArgumentPlace freedomPlace() { return {"", false, Formula{FormulaKind::Number, usualFreedom}}; }

std::vector<ArgumentPlace> points(std::size_t count) {
  std::vector<ArgumentPlace> places;
  for (std::size_t i = 0; i < count; ++i)
    places.push_back(placeOf({"", CoordinateRole::Position}, i));
  return places;
}

} // namespace

std::vector<Signature> signaturesOf(const Kind &kind) {
  if (kind.shape)
    return {};
  Signature byCoordinates{kind.word, {}, false, nullptr, &kind};
  if (kind.binding)
    byCoordinates.places.push_back({kind.binding->host});
  for (std::size_t i = 0; i < kind.fewestCoordinates(); ++i)
    byCoordinates.places.push_back(kind.binding ? freedomPlace() : placeOf(kind.coordinates[i], i));
  std::vector<Signature> all{std::move(byCoordinates)};
  if (kind.word == NumberObject::kind)
    all.front().places.resize(1);
  if (kind.word == LineObject::kind || kind.word == RayObject::kind || kind.word == VectorObject::kind)
    all.push_back({kind.word, points(2), false, nullptr, &kind});
  if (kind.word == PlaneObject::kind)
    all.push_back({kind.word, points(3), false, nullptr, &kind});
  return all;
}

Signature signatureOf(const Construction &construction) {
  Signature signature{
      construction.word.empty() ? construction.id : construction.word, {}, true, &construction, nullptr};
  for (const ConstructionRole &role : construction.roles)
    signature.places.push_back({role.kind, role.isList});
  return signature;
}

std::vector<Signature> signaturesOf(std::string_view word) {
  if (const Kind *kind = findKind(word))
    return signaturesOf(*kind);
  std::vector<Signature> all;
  for (const Construction &construction : constructions())
    if (construction.id == word || (construction.word == word && !word.empty()))
      all.push_back(signatureOf(construction));
  return all;
}

std::string wordsFor(const Signature &signature) {
  return signature.construction ? objectsWantedBy(*signature.construction) : signature.kind->noun();
}

} // namespace halfspace
