// The ray of a torpedo that a flying saucer fires: from where the saucer is, along its barrel, which
// is just so long, wherever it points (note PG 7).
#include "lessons/construction/parts/shots.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/ray.h"

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

ExactVec3 placeIn(const UfoObject &saucer, const Rational &frame) {
  return saucer.start + saucer.velocity * (frame / framesPerVelocity);
}

struct Out : Computed<In>, UfoTerms {
  explicit Out(const In &objects) : Computed(objects), UfoTerms(termsOf(objects.U)) {}

  const UfoObject &saucer = in.U.object;
  Shot shot = shotAt(in.frame.object.value, in.seed.object.value);
  bool isByHand = in.seed.object.value == 0;
  ExactVec3 barrel = isByHand ? saucer.barrel : randomBarrel(in.seed.object.value, shot);
  /// The direction of a torpedo is so many times the arrow along the barrel.
  bool canFire = !isZero(barrel) && saucer.barrelLength > 0;
  Factor factor = canFire ? factorOf(barrel, saucer.barrelLength) : Factor();

  Term aim = isByHand ? g : drawnName(vectorLetter("d"), barrel); ///< along the barrel
  Term Q = madeName("L", "Q", placeIn(saucer, shot.frame));
  Term r = madeName("L", "r", ExactVec3(barrel *factor.value));
};

CaseWords tell(const Out &at) {
  if (isZero(at.barrel))
    return {"zero-direction",
            words("The barrel {g} is the zero vector: it points nowhere, so nothing is fired.",
                  {{"g", plainText(at.aim)}}),
            true};
  if (!at.canFire)
    return {"zero-direction",
            words("{l}: a barrel without a length gives no direction, so nothing is fired.",
                  {{"l", equation(at.l)}}),
            true};
  if (at.isByHand)
    return {"by-hand", words("The saucer fires from {Q} along its barrel.", {{"Q", plainText(at.Q)}})};
  return {"seeded", words("The saucer fires by itself. This is shot number {number}.",
                          {{"number", toText(at.shot.number + 1)}})};
}

WorkingLine startLine(const Out &at) {
  if (at.shot.frame == 0)
    return line(withResult(at.Q == at.S), words("The saucer fires from where it starts."));
  const Rational part = at.shot.frame / framesPerVelocity;
  return asked(withNumbers(at.Q == at.S + Term(part) * at.c),
               words("Where the saucer is when it fires: it flies {c} in {frames} frames.",
                     {{"c", plainText(at.c)}, {"frames", std::to_string(framesPerVelocity)}}));
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

void drawSaucer(Figure &figure, const Out &at) {
  const ExactVec3 now = placeIn(at.saucer, at.in.frame.object.value);
  const Place middle = place(now);
  const bool hasFlownOn = now != vectorOf(at.Q);
  std::size_t number = 0;
  const auto add = [&](std::vector<Place> corners) {
    PolygonMark part{{partOf(at.mark("saucer"), number), Role::Given, Subject::Neutral}, std::move(corners)};
    ++number;
    part.passes = hasFlownOn;
    figure.add(inLook(at.in.U.look, std::move(part)));
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

void drawRay(Figure &figure, const Out &at) {
  const Place from = place(at.Q);
  // Its arrow and its start have names enough.
  figure.add(RayMark{{at.mark("L"), Role::Derived, Subject::Ray}, from, unitOf(vectorOf(at.r))});
  figure.add(arrowOf(at.r, from, Role::Derived, Subject::Ray));
  figure.add(pointOf(at.Q, Role::Derived, Subject::Point));
}

Figure draw(const Out &at) {
  Figure figure;
  drawSaucer(figure, at);
  if (!at.canFire)
    return figure;
  if (!at.isByHand)
    figure.add(arrowOf(at.aim, place(at.Q), Role::Derived, Subject::Ray));
  drawRay(figure, at);
  return figure;
}

} // namespace

Construction torpedo_shot() {
  return taught<Out, UfoObject, NumberObject, NumberObject>(
      {.id = "torpedo-shot",
       .title = [] { return words("shot of the torpedo"); },
       .roles = {"U", "frame", "seed"},
       .makes = {{"L", RayObject::kind, &Out::canFire,
                  [](const Out &at) {
                    return RayObject{vectorOf(at.Q), vectorOf(at.r)};
                  }}},
       .letters = {"d"},
       .cases = {"by-hand", "seeded", "zero-direction"},
       .values = {{named::number("length"), &Out::canFire, [](const Out &at) { return norm(at.aim); }},
                  {named::vector("start"), &Out::canFire, &Out::Q},
                  {named::vector("direction"), &Out::canFire, &Out::r}},
       .lines = {{"start", &Out::canFire, startLine},
                 {"length", &Out::canFire, [](const Out &at) { return withNumbers(norm(at.aim)); },
                  says("How long the arrow is that tells where the barrel points.")},
                 {"factor", &Out::canFire, factorLine},
                 {"direction", &Out::canFire, directionLine}},
       .marks = {"saucer", "d", "L", "L.Q", "L.r"},
       .tell = tell,
       .draw = draw});
}

} // namespace halfspace
