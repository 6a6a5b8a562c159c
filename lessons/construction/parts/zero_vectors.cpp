#include "lessons/construction/parts/zero_vectors.h"

#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"

#include <utility>

namespace halfspace {
namespace {

bool isZeroVector(const Term &vector) { return isZero(vectorOf(vector)); }

} // namespace

std::string crossProductWords(const Term &normal) {
  return isZeroVector(normal) ? words("The zero vector: u and v lie along one line and have no normal.")
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
