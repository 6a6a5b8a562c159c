// The ray of a torpedo that a flying saucer fires: from where the saucer is, along its barrel, which is
// always 20 units long (note PG 7).
#include "geometry/surd.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/shots.h"
#include "lessons/construction/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/letters.h"
#include "lessons/object/ray.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <array>
#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

struct In : Naming {
  Given<UfoObject> U;
  Given<NumberObject> frame;
  Given<NumberObject> seed;
};

struct Out : Naming, UfoTerms {
  Shot shot;
  bool isByHand = true;
  ExactVec3 saucer; ///< where it is in the frame
  Term aim;         ///< along the barrel: b, or what chance makes of it
  Term Q, r;
};

/// The direction is rounded to this where its exact length would be no fraction.
const Rational directionStep(1, 1000);

/// So long as the barrel; zero for a zero barrel.
ExactVec3 directionOf(const ExactVec3 &barrel) {
  if (isZero(barrel))
    return barrel;
  const Surd length = Surd::root(dot(barrel, barrel));
  if (length.isRational())
    return barrel * (Rational(barrelLength) / length.rationalPart());
  const double factor = barrelLength / toDouble(length);
  ExactVec3 direction;
  for (int axis = 0; axis < 3; ++axis)
    direction[axis] = roundToMultiple(toDouble(barrel[axis]) * factor, directionStep);
  return direction;
}

Out compute(const In &in) {
  const auto &[start, velocity, barrel] = in.U.object;
  const Rational &frame = in.frame.object.value;
  const Rational &seed = in.seed.object.value;
  const Shot shot = shotAt(frame, seed, barrel);
  const UfoTerms letters = termsOf(in.U);
  return {in,
          letters,
          shot,
          seed == 0,
          start + velocity * (frame / framesPerVelocity),
          seed == 0 ? letters.b : name(in.own(vectorLetter("d")), shot.barrel).marked(in.mark("d")),
          madeName(in, "L", "Q", start + velocity * (shot.frame / framesPerVelocity)),
          madeName(in, "L", "r", directionOf(shot.barrel))};
}

bool hasBarrel(const Out &at) { return !isZero(at.shot.barrel); }

CaseWords tell(const In &, const Out &at) {
  if (!hasBarrel(at))
    return {"zero-direction",
            words("The barrel {b} is the zero vector: it points nowhere, so nothing is fired.",
                  {{"b", plainText(at.aim)}}),
            true};
  if (at.isByHand)
    return {"by-hand", words("The saucer fires from {Q} along its barrel.", {{"Q", plainText(at.Q)}})};
  return {"seeded", words("The saucer fires by itself. This is shot number {number}.",
                          {{"number", toText(at.shot.number + 1)}})};
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  if (!hasBarrel(at))
    return {};
  return {listed("length", norm(at.aim)), listed("start", at.Q), listed("direction", at.r)};
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (!hasBarrel(at))
    return {};
  return {{"L", RayObject{vectorOf(at.Q), vectorOf(at.r)}}};
}

WorkingLine startLine(const Out &at) {
  if (at.shot.frame == 0)
    return line(withResult(at.Q == at.S), words("The saucer fires from where it starts."));
  const Rational part = at.shot.frame / framesPerVelocity;
  return asked(withNumbers(at.Q == at.S + Term(part) * at.v),
               words("Where the saucer is when it fires: it flies {v} in {frames} frames.",
                     {{"v", plainText(at.v)}, {"frames", std::to_string(framesPerVelocity)}}));
}

WorkingLine lengthLine(const Out &at) {
  return asked(withNumbers(norm(at.aim)), words("How long the arrow is that tells where the barrel points."));
}

Term scaledAim(const Out &at) { return Term(barrelLength) / norm(at.aim) * at.aim; }

std::string sentenceForScaling() {
  return words("Divided by its length it is one unit long; times {barrel} it is as long as the barrel.",
               {{"barrel", std::to_string(barrelLength)}});
}

WorkingLine aimedLine(const Out &at) { return line(withNumbers(scaledAim(at)), sentenceForScaling()); }

bool isExact(const Out &at) { return Surd::root(dot(at.shot.barrel, at.shot.barrel)).isRational(); }

WorkingLine directionLine(const Out &at) {
  if (!isExact(at))
    return line(withResult(at.r), words("Rounded to thousandths. From here on the torpedo's direction is "
                                        "exactly this."));
  return line(withNumbers(at.r == scaledAim(at)), sentenceForScaling());
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  if (!hasBarrel(at))
    return lines;
  lines.add("start", [&at] { return startLine(at); });
  lines.add("length", [&at] { return lengthLine(at); });
  if (!isExact(at))
    lines.add("aimed", [&at] { return aimedLine(at); });
  lines.add("direction", [&at] { return directionLine(at); });
  return lines;
}

// The saucer, in scene units: a ring with a dome above and a keel below.
constexpr double rimRadius = 1.5;
constexpr double domeRadius = 0.65;
constexpr double domeHeight = 0.55;
constexpr double keelRadius = 0.5;
constexpr double keelDepth = 0.4;
constexpr std::size_t sides = 12;

Place onRing(const Place &middle, double radius, double height, std::size_t side) {
  const double angle = 2 * std::numbers::pi * static_cast<double>(side) / static_cast<double>(sides);
  return middle + Place(radius * std::cos(angle), radius * std::sin(angle), height);
}

void drawSaucer(Figure &figure, const In &in, const Out &at) {
  const Place middle = place(at.saucer);
  std::size_t number = 0;
  const auto add = [&](std::vector<Place> corners) {
    std::string id = in.mark("saucer") + (number > 0 ? "/" + std::to_string(number) : "");
    ++number;
    figure.add(PolygonMark{{std::move(id), Role::Derived, Subject::Neutral}, std::move(corners)});
  };
  std::vector<Place> roof;
  for (std::size_t i = 0; i < sides; ++i) {
    roof.push_back(onRing(middle, domeRadius, domeHeight, i));
    add({onRing(middle, rimRadius, 0, i), onRing(middle, rimRadius, 0, i + 1),
         onRing(middle, domeRadius, domeHeight, i + 1), onRing(middle, domeRadius, domeHeight, i)});
    add({onRing(middle, rimRadius, 0, i + 1), onRing(middle, rimRadius, 0, i),
         onRing(middle, keelRadius, -keelDepth, i), onRing(middle, keelRadius, -keelDepth, i + 1)});
  }
  add(std::move(roof));
}

void drawRay(Figure &figure, const In &in, const Out &at) {
  const Place from = place(at.Q);
  // Its arrow and its start have names enough.
  figure.add(RayMark{{in.mark("L"), Role::Derived, Subject::Ray}, from, unitOf(vectorOf(at.r))});
  figure.add(arrowOf(at.r, from, Role::Derived, Subject::Ray));
  figure.add(pointOf(at.Q, Role::Derived, Subject::Point));
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  drawSaucer(figure, in, at);
  if (!hasBarrel(at))
    return figure;
  if (!at.isByHand)
    figure.add(arrowOf(at.aim, place(at.Q), Role::Derived, Subject::Ray));
  drawRay(figure, in, at);
  return figure;
}

std::vector<SpecialCase> nearby(const In &, const Out &) { return {}; }

} // namespace

Construction torpedo_shot() {
  return makeConstruction<In, Out, UfoObject, NumberObject, NumberObject>(
      "torpedo-shot", {"U", "frame", "seed"}, {{"L", "ray"}}, {"d"},
      {.cases = {"by-hand", "seeded", "zero-direction"},
       .values = {named::number("length"), named::vector("start"), named::vector("direction")},
       .lines = {"start", "length", "aimed", "direction"},
       .marks = {"saucer", "d", "L", "L.Q", "L.r"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
