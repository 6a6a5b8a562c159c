#include "lessons/construction/parts/zero_vectors.h"

#include "geometry/case_names.h"
#include "geometry/intersect_ray_plane.h"
#include "geometry/point_plane.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"

#include <utility>

namespace halfspace {
namespace {

bool isZeroVector(const Term &vector) { return isZero(vectorOf(vector)); }

} // namespace

CaseWords zeroNormalWords(const Naming &naming) {
  return {
      std::string(nameOf(PointPlaneCase::ZeroNormal)),
      words("The normal {n} is the zero vector: it points nowhere, so there is no plane.", naming.letters),
      true};
}

CaseWords zeroDirectionWords(const Naming &naming) {
  return {std::string(nameOf(RayPlaneCase::ZeroDirection)),
          words("The direction {r} is the zero vector: the ray goes nowhere.", naming.letters), true};
}

CaseWords zeroLineWords(const Naming &naming, std::string_view caseName) {
  return {
      std::string(caseName),
      words("The direction {v} is the zero vector: it points nowhere, so there is no line.", naming.letters),
      true};
}

CaseWords zeroLinesWords(const Naming &naming, std::string_view caseName, bool isFirstZero,
                         bool isSecondZero) {
  const auto sentence = [&] {
    if (isFirstZero && isSecondZero)
      return words("{g.v} and {h.v} are zero vectors: they point nowhere, so there are no lines.",
                   naming.letters);
    return isFirstZero
               ? words("{g.v} is the zero vector: it points nowhere, so {g} is no line.", naming.letters)
               : words("{h.v} is the zero vector: it points nowhere, so {h} is no line.", naming.letters);
  };
  return {std::string(caseName), sentence(), true};
}

std::string zeroWithoutPlane(const Naming &naming) {
  return words("Zero, because {n} is the zero vector: there is no plane.", naming.letters);
}

std::string zeroWithoutRay(const Naming &naming) {
  return words("Zero, because {r} is the zero vector: there is no ray.", naming.letters);
}

std::string allZeroWithoutRay(const Naming &naming) {
  return words("All are 0, because {r} is the zero vector: there is no line.", naming.letters);
}

std::string crossProductWords(const Term &normal) {
  return isZeroVector(normal) ? words("The zero vector: u and v lie along one line and span no plane.")
                              : words("Perpendicular to both sides.");
}

std::string perpWords(const Term &perp, std::string otherwise) {
  return isZeroVector(perp) ? words("The zero vector: u and v lie along one line, so it points nowhere.")
                            : std::move(otherwise);
}

std::string withoutDirectionWords(const Term &ray, const Term &edge) {
  if (isZeroVector(ray))
    return words("Zero, because {r} is the zero vector: there is no ray.", {{"r", plainText(ray)}});
  if (isZeroVector(edge))
    return words("Zero, because {e} is the zero vector: there is no edge.", {{"e", plainText(edge)}});
  return {};
}

} // namespace halfspace
