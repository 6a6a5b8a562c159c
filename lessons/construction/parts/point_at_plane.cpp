#include "lessons/construction/parts/point_at_plane.h"

#include "lessons/construction/parts/worked_lines.h"
#include "lessons/construction/parts/zero_vectors.h"
#include "lessons/object/drawing.h"
#include "lessons/object/letters.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"

#include <utility>

namespace halfspace {
namespace {

std::string distanceWords(const MeasuredPoint &at) {
  if (at.which == PointPlaneCase::On)
    return words("f({Q}) is 0, and so is the distance: 0 divided by any length is 0.", at.letters);
  if (isUnit(at.n))
    return words("Because |{n}| = 1, f({Q}) is the signed distance already.", at.letters);
  return words("{f} is not the distance: {n} is {length} long, so f({Q}) is {length} times the distance.",
               at.letters, {{"f", equation(at.f)}, {"length", plainText(calculated(norm(at.n)))}});
}

} // namespace

WorkingLine valueLine(const MeasuredPoint &at) {
  return asked(withNumbers(at.f == dot(at.n, at.Q - at.P0)),
               at.hasPlane ? words("Zero in the plane, positive on the side that {n} points to.", at.letters)
                           : zeroWithoutPlane(at),
               {{dot(at.n, at.Q),
                 words("{answer} is {n}·{Q}: {P0} is to be subtracted from {Q} first.", at.letters)}});
}

WorkingLine distanceLine(const MeasuredPoint &at) {
  const auto &letters = at.letters;
  return asked(
      withNumbers(at.dist == at.f / norm(at.n)), distanceWords(at),
      {{at.f, words("{answer} is f({Q}): {n} is not normalized, so divide by |{n}|.", letters)},
       {-at.dist, words("{answer} has the wrong sign: the distance has the sign of f({Q}).", letters)},
       {norm(at.f), words("{answer} is f({Q}) without its sign, and not divided by |{n}| either.", letters)},
       {at.f / dot(at.n, at.n),
        words("{answer} is f({Q})/({n}·{n}): divide by the root of {n}·{n}, |{n}|.", letters)}});
}

WorkingLine footLine(const MeasuredPoint &at) {
  return asked(withNumbers(at.F == at.Q - at.f / dot(at.n, at.n) * at.n),
               words("The foot: from {Q} straight along {n} to the plane, its nearest point.", at.letters));
}

void drawDistance(Figure &figure, const MeasuredPoint &at) {
  const Place foot = place(at.F);
  const Place q = place(at.Q);
  MarkBase distance = drawn(at.dist, Role::Result, Subject::Measure);
  distance.numbers = relatedLatex(calculated(at.dist));
  figure.add(SegmentMark{std::move(distance), foot, q});
  figure.add(RightAngleMark{
      {at.F->mark + "/angle", Role::Helper, Subject::Measure}, foot, q - foot, place(at.P0) - foot});
}

} // namespace halfspace
