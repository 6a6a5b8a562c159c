#include "lessons/construction/parts/acute_angle.h"

#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <glm/geometric.hpp>

#include <utility>

namespace halfspace {
namespace {

/// A side of an angle is drawn no longer than this, in units of the picture: the cross product of two ways is
/// a normal that would leave it.
constexpr double longestSide = 6;

} // namespace

WorkingLine lengthLine(const Term &vector) {
  const WordValues letters{{"vector", plainText(vector)}};
  return asked(withProducts(norm(vector) == root(dot(vector, vector))),
               words("The length of {vector}.", letters),
               {{dot(vector, vector),
                 words("{answer} is {vector}·{vector}: its root is still to be taken.", letters)}});
}

WorkingLine acuteLine(const Term &ratio, const Term &a, const Term &b, std::string sentence) {
  const WordValues letters{{"a", plainText(a)}, {"b", plainText(b)}};
  const Term size = norm(dot(a, b));
  return asked(withNumbers(ratio == size / (norm(a) * norm(b))), std::move(sentence),
               {{size, words("{answer} is |{a}·{b}|: divide by |{a}| and by |{b}|.", letters)},
                {dot(a, b) / (norm(a) * norm(b)),
                 words("{answer} belongs to an angle of more than 90°: leave out the sign.")},
                {size / norm(a), words("{answer} is divided by |{a}| alone: divide by |{b}|, too.", letters)},
                {size / norm(b), words("{answer} is divided by |{b}| alone: divide by |{a}|, too.", letters)},
                {size / (dot(a, a) * dot(b, b)),
                 words("{answer} is divided by the squares of both lengths: take their roots.")}});
}

void addAngle(Figure &figure, const DrawnAngle &angle, const Place &corner, const AngleSide &first,
              const AngleSide &second) {
  MarkBase base = drawn(angle.letter, angle.role, Subject::Neutral);
  base.coordinates = degreesLatex(angle.degrees);
  if (angle.isRight)
    figure.add(RightAngleMark{std::move(base), corner, first.vector, second.vector});
  else
    figure.add(ArcMark{std::move(base), corner, first.vector, second.vector});
  for (const auto &[which, side] : {std::pair("/first", first), std::pair("/second", second)}) {
    const MarkBase ghost{angle.letter->mark + which, Role::Ghost, side.subject};
    ArrowMark arrow{ghost, corner, side.vector, true};
    if (glm::length(side.vector) > longestSide)
      arrow.drawnLength = longestSide;
    figure.add(inLook(side.look, std::move(arrow)));
  }
}

} // namespace halfspace
