// The ray of a torpedo that a flying saucer fires: from where the saucer is, along its barrel, which
// is just so long, wherever it points (note PG 7).
#include "geometry/surd.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/shots.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/letters.h"
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

/// The direction of a torpedo is so many times the arrow along the barrel.
struct Factor {
  Rational value; ///< 0 where nothing is fired
  bool isExact = true;
};

struct Out : Naming, UfoTerms {
  Shot shot;
  bool isByHand = true;
  ExactVec3 saucer; ///< where it is in the frame
  Factor factor;
  Term aim; ///< along the barrel: g, or what chance makes of it
  Term Q, r;
};

/// So many digits of the factor that makes an arrow as long as the barrel are kept where it is no fraction.
constexpr int factorDigits = 4;

/// Times this an arrow ≠ 0 is as long as a barrel that has a length, exactly or nearly: the direction is the
/// arrow's in any case.
Factor factorOf(const ExactVec3 &arrow, const Rational &barrelLength) {
  const Surd length = Surd::root(dot(arrow, arrow));
  if (length.isRational())
    return {barrelLength / length.rationalPart(), true};
  const double factor = toDouble(barrelLength) / toDouble(length);
  const int exponent = static_cast<int>(std::floor(std::log10(factor)));
  return {roundToMultiple(factor, powerOfTen(exponent + 1 - factorDigits)), false};
}

Out compute(const In &in) {
  const auto &[start, velocity, barrel, barrelLength] = in.U.object;
  const Rational &frame = in.frame.object.value;
  const Rational &seed = in.seed.object.value;
  const Shot shot = shotAt(frame, seed);
  const ExactVec3 aim = seed == 0 ? barrel : randomBarrel(seed, shot);
  const bool canFire = !isZero(aim) && barrelLength > 0;
  const Factor factor = canFire ? factorOf(aim, barrelLength) : Factor();
  const UfoTerms letters = termsOf(in.U);
  return {in,
          letters,
          shot,
          seed == 0,
          start + velocity * (frame / framesPerVelocity),
          factor,
          seed == 0 ? letters.g : name(in.own(vectorLetter("d")), aim).marked(in.mark("d")),
          madeName(in, "L", "Q", start + velocity * (shot.frame / framesPerVelocity)),
          madeName(in, "L", "r", ExactVec3(aim * factor.value))};
}

bool canFire(const Out &at) { return at.factor.value != 0; }

CaseWords tell(const In &, const Out &at) {
  if (isZero(vectorOf(at.aim)))
    return {"zero-direction",
            words("The barrel {g} is the zero vector: it points nowhere, so nothing is fired.",
                  {{"g", plainText(at.aim)}}),
            true};
  if (!canFire(at))
    return {"zero-direction",
            words("{l}: a barrel without a length gives no direction, so nothing is fired.",
                  {{"l", equation(at.l)}}),
            true};
  if (at.isByHand)
    return {"by-hand", words("The saucer fires from {Q} along its barrel.", {{"Q", plainText(at.Q)}})};
  return {"seeded", words("The saucer fires by itself. This is shot number {number}.",
                          {{"number", toText(at.shot.number + 1)}})};
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  if (!canFire(at))
    return {};
  return {listed("length", norm(at.aim)), listed("start", at.Q), listed("direction", at.r)};
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (!canFire(at))
    return {};
  return {{"L", RayObject{vectorOf(at.Q), vectorOf(at.r)}}};
}

WorkingLine startLine(const Out &at) {
  if (at.shot.frame == 0)
    return line(withResult(at.Q == at.S), words("The saucer fires from where it starts."));
  const Rational part = at.shot.frame / framesPerVelocity;
  return asked(withNumbers(at.Q == at.S + Term(part) * at.c),
               words("Where the saucer is when it fires: it flies {c} in {frames} frames.",
                     {{"c", plainText(at.c)}, {"frames", std::to_string(framesPerVelocity)}}));
}

WorkingLine lengthLine(const Out &at) {
  return asked(withNumbers(norm(at.aim)), words("How long the arrow is that tells where the barrel points."));
}

Term factorTerm(const Out &at) { return at.l / norm(at.aim); }

WorkingLine factorLine(const Out &at) {
  return line(withNumbers(factorTerm(at)),
              words("Divided by its length an arrow is one unit long; times {l} it is as long as the barrel.",
                    {{"l", plainText(at.l)}}));
}

WorkingLine directionLine(const Out &at) {
  if (at.factor.isExact)
    return asked(withNumbers(at.r == factorTerm(at) * at.aim), words("The direction of the torpedo."));
  return asked(
      withNumbers(at.r == Term(at.factor.value) * at.aim),
      words("The direction of the torpedo. The factor is rounded to {digits} digits: so this is exactly the "
            "barrel's direction, and nearly its length.",
            {{"digits", std::to_string(factorDigits)}}));
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  if (!canFire(at))
    return lines;
  lines.add("start", [&at] { return startLine(at); });
  lines.add("length", [&at] { return lengthLine(at); });
  lines.add("factor", [&at] { return factorLine(at); });
  lines.add("direction", [&at] { return directionLine(at); });
  return lines;
}

// The saucer, in scene units: a ring with a dome above and a keel below.
constexpr double rimRadius = 2.1;
constexpr double domeRadius = 0.95;
constexpr double domeHeight = 0.85;
constexpr double keelRadius = 0.8;
constexpr double keelDepth = 0.5;
constexpr std::size_t sides = 12;

Place onRing(const Place &middle, double radius, double height, std::size_t side) {
  const double angle = 2 * std::numbers::pi * static_cast<double>(side) / static_cast<double>(sides);
  return middle + Place(radius * std::cos(angle), radius * std::sin(angle), height);
}

void drawSaucer(Figure &figure, const In &in, const Out &at) {
  const Place middle = place(at.saucer);
  const bool hasFlownOn = at.saucer != vectorOf(at.Q);
  std::size_t number = 0;
  const auto add = [&](std::vector<Place> corners) {
    std::string id = in.mark("saucer") + (number > 0 ? "/" + std::to_string(number) : "");
    ++number;
    PolygonMark part{{std::move(id), Role::Given, Subject::Neutral}, std::move(corners)};
    part.passes = hasFlownOn;
    figure.add(inLook(in.U.look, std::move(part)));
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
  if (!canFire(at))
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
       .lines = {"start", "length", "factor", "direction"},
       .marks = {"saucer", "d", "L", "L.Q", "L.r"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
