#include "lessons/construction/parts/mirror_lines.h"

#include "lessons/construction/parts/worked_lines.h"

#include <utility>

namespace halfspace {

WorkingLine mirroredLine(const MirroredDirection &at, const Naming &naming, std::string sentence) {
  const Term product = dot(at.r, at.n);
  const Term times = product / dot(at.n, at.n); // how often n is the part of r along it
  const WordValues &letters = naming.letters;
  return asked(withNumbers(at.turned == at.r - 2 * times * at.n), std::move(sentence),
               {{at.r - times * at.n,
                 words("{answer} is the part across alone: take the part along {n} away twice.", letters)},
                {at.r + 2 * times * at.n,
                 words("{answer} is {r} with the part along {n} added: take it away twice.", letters)},
                {at.r - 2 * product * at.n,
                 words("{answer} is right only when |{n}| = 1: divide by {n}·{n}.", letters)}});
}

WorkingLine sameLengthLine(const MirroredDirection &at) {
  return line({withProducts(dot(at.r, at.r)), withProducts(dot(at.turned, at.turned))},
              words("The same number: both are equally long."));
}

} // namespace halfspace
