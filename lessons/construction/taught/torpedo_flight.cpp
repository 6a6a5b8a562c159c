// A torpedo on its way: where it is in a frame, and whether it has reached what it hits first (note PG 7).
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/fragments.h"
#include "lessons/construction/parts/shots.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfspace {
namespace {

struct In : Naming {
  Given<RayObject> L;
  Given<NumberObject> frame;
  Given<NumberObject> seed;
  GivenMeshes meshes;
};

struct Out : Naming, RayTerms {
  Rational elapsed; ///< λ by the frame
  FirstHits first;
  Term lambda, M;
};

bool hits(const Out &at) { return !at.first.fragments.empty(); }
bool hasExploded(const Out &at) { return hits(at) && at.elapsed >= at.first.t; }
bool isFired(const Out &at) { return at.elapsed > 0; }
bool isDegenerate(const In &in) { return isZero(in.L.object.direction); }

Out compute(const In &in) {
  const Rational &frame = in.frame.object.value;
  const Shot shot = shotAt(frame, in.seed.object.value);
  const Rational elapsed = parameterAt(frame, shot);
  const FirstHits first = isDegenerate(in) ? FirstHits() : firstHits(in.L.object, in.meshes);
  const bool ends = !first.fragments.empty() && elapsed >= first.t;
  const Rational lambda = ends ? first.t : elapsed;
  const RayTerms ray = termsOf(in.L);
  const Term origin = ends ? crossingTerm(ray, triangleOf(in.meshes, first.fragments.front()))
                           : (coordinateTerm(in.frame, 0) - Term(shot.frame)) / Term(framesPerLambda);
  return {in,
          ray,
          elapsed,
          first,
          name(in.own(letter("λ", "M")), lambda).standingFor(origin),
          name(in.own(letter("M")), ExactVec3(in.L.object.origin + in.L.object.direction * lambda))
              .marked(in.mark("M"))};
}

CaseWords tell(const In &in, const Out &at) {
  if (isDegenerate(in))
    return zeroDirectionWords(at);
  const WordValues now{{"lambda", equation(at.lambda)}};
  if (hasExploded(at))
    return {"exploded", words("The torpedo has hit {fragment}, at {lambda}.",
                              {{"fragment", nameOf(in.meshes, at.first.fragments.front())},
                               {"lambda", equation(at.lambda)}})};
  if (!isFired(at))
    return {
        "waiting",
        hits(at)
            ? words("{lambda}: the torpedo is not fired yet. What it will hit, and when, is known already.",
                    now)
            : words("{lambda}: the torpedo is not fired yet. It will not explode.", now)};
  return {"flying",
          hits(at)
              ? words("The torpedo flies, at {lambda}. What it will hit, and when, is known already.", now)
              : words("The torpedo flies, at {lambda}, and will not explode.", now)};
}

std::vector<NamedValue> valuesOf(const In &in, const Out &at) {
  if (isDegenerate(in))
    return {};
  return {listed("lambda", at.lambda), listed("place", at.M)};
}

std::vector<MadeObject> make(const In &, const Out &) { return {}; }

std::string placeWords(const Out &at) {
  if (hasExploded(at))
    return words("The torpedo has reached what it hits.");
  const WordValues values{{"frames", std::to_string(framesPerLambda)}};
  return isFired(at)
             ? words("Where the torpedo is now. Its parameter grows by 1 in {frames} frames.", values)
             : words("Where the torpedo will start, or behind it. Its parameter grows by 1 in {frames} "
                     "frames.",
                     values);
}

Explanation explain(const In &in, const Out &at) {
  Explanation lines;
  if (isDegenerate(in))
    return lines;
  lines.add("place", [&at] { return asked(withNumbers(at.M == at.Q + at.lambda * at.r), placeWords(at)); });
  return lines;
}

// The explosion, in scene units: sparks to all sides that grow while λ does, every other one shorter.
constexpr double longSpark = 2.4;
constexpr double shortSpark = 1.5;
constexpr double sparkBegin = 0.35; ///< as a share of its end
constexpr int sparks = 32;
/// It is as large as it gets after so much of λ.
constexpr double blastDuration = 0.5;

/// Evenly over all directions: equal steps in height, the golden angle around.
Place sparkDirection(int spark) {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  const double height = 1 - (2.0 * spark + 1) / sparks;
  const double across = std::sqrt(1 - height * height);
  return {across * std::cos(golden * spark), across * std::sin(golden * spark), height};
}

void drawBlast(Figure &figure, const In &in, const Out &at) {
  const double age = toDouble(Rational(at.elapsed - at.first.t));
  const double grown = std::sqrt(std::min(1.0, age / blastDuration));
  if (!(grown > 0))
    return;
  const Place middle = place(at.M);
  for (int i = 0; i < sparks; ++i) {
    const bool isLong = i % 2 == 0;
    const Place end = sparkDirection(i) * (grown * (isLong ? longSpark : shortSpark));
    figure.add(SegmentMark{
        {in.mark("M") + "/spark" + std::to_string(i), isLong ? Role::Warning : Role::Result, Subject::Point},
        middle + end * sparkBegin,
        middle + end});
  }
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  if (isDegenerate(in))
    return figure;
  if (hasExploded(at))
    drawBlast(figure, in, at);
  else if (isFired(at))
    figure.add(
        SegmentMark{{in.mark("M") + "/trail", Role::Result, Subject::Point}, place(at.Q), place(at.M)});
  PointMark torpedo = pointOf(at.M, isFired(at) ? Role::Result : Role::Ghost, Subject::Point);
  if (at.elapsed == 0)
    torpedo.label.clear(); // the start has a letter of its own
  figure.add(std::move(torpedo));
  for (Mark &mark : figure.marks)
    baseOf(mark).passes = true;
  return figure;
}

std::vector<SpecialCase> nearby(const In &, const Out &) { return {}; }

} // namespace

Construction torpedo_flight() {
  return makeConstruction<In, Out, RayObject, NumberObject, NumberObject, Several<MeshObject>>(
      "torpedo-flight", {"L", "frame", "seed", "meshes"}, {}, {"λM", "M"},
      {.cases = {"waiting", "flying", "exploded", "zero-direction"},
       .values = {named::number("lambda"), named::vector("place")},
       .lines = {"place"},
       .marks = {"M"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
