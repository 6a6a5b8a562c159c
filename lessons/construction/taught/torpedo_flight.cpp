// A torpedo on its way: where it is in a frame, and whether it has reached what it hits first (note PG 7).
#include "lessons/construction/parts/fragments.h"
#include "lessons/construction/parts/shots.h"
#include "lessons/construction/taught.h"

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

struct Out : Computed<In>, RayTerms {
  explicit Out(const In &objects) : Computed(objects), RayTerms(termsOf(objects.L)) {}

  bool hasRay = !isZero(in.L.object.direction);
  Shot shot = shotAt(in.frame.object.value, in.seed.object.value);
  Rational elapsed = parameterAt(in.frame.object.value, shot); ///< λ by the frame
  bool isFired = elapsed > 0;
  FirstHits first = hasRay ? firstHits(in.L.object, in.meshes) : FirstHits();
  bool hits = !first.fragments.empty();
  bool hasExploded = hits && elapsed >= first.t;
  Rational parameter = hasExploded ? first.t : elapsed;

  Term lambda =
      ownName(letter("λ", "M"), parameter)
          .standingFor(hasExploded ? crossingTerm(*this, triangleOf(in.meshes, first.fragments.front()))
                                   : (coordinateTerm(in.frame, 0) - Term(shot.frame)) / framesPerLambda);
  Term M = drawnName(letter("M"), ExactVec3(in.L.object.origin + in.L.object.direction * parameter));
};

CaseWords tell(const Out &at) {
  if (!at.hasRay)
    return zeroDirectionWords(at);
  const WordValues now{{"lambda", equation(at.lambda)}};
  if (at.hasExploded)
    return {"exploded", words("The torpedo has hit {fragment}, at {lambda}.",
                              {{"fragment", nameOf(at.in.meshes, at.first.fragments.front())},
                               {"lambda", equation(at.lambda)}})};
  if (!at.isFired)
    return {
        "waiting",
        at.hits
            ? words("{lambda}: the torpedo is not fired yet. What it will hit, and when, is known already.",
                    now)
            : words("{lambda}: the torpedo is not fired yet. It will not explode.", now)};
  return {"flying",
          at.hits
              ? words("The torpedo flies, at {lambda}. What it will hit, and when, is known already.", now)
              : words("The torpedo flies, at {lambda}, and will not explode.", now)};
}

std::string placeWords(const Out &at) {
  if (at.hasExploded)
    return words("The torpedo has reached what it hits.");
  const WordValues values{{"frames", std::to_string(framesPerLambda)}};
  return at.isFired
             ? words("Where the torpedo is now. Its parameter grows by 1 in {frames} frames.", values)
             : words("The torpedo is not fired yet. Once it is, its parameter grows by 1 in {frames} frames.",
                     values);
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

void drawBlast(Figure &figure, const Out &at) {
  const double age = toDouble(Rational(at.elapsed - at.first.t));
  const double grown = std::sqrt(std::min(1.0, age / blastDuration));
  if (!(grown > 0))
    return;
  const Place middle = place(at.M);
  for (int i = 0; i < sparks; ++i) {
    const bool isLong = i % 2 == 0;
    const Place end = sparkDirection(i) * (grown * (isLong ? longSpark : shortSpark));
    figure.add(SegmentMark{
        {at.mark("M") + "/spark" + std::to_string(i), isLong ? Role::Warning : Role::Result, Subject::Point},
        middle + end * sparkBegin,
        middle + end});
  }
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.hasRay)
    return figure;
  if (at.hasExploded)
    drawBlast(figure, at);
  else if (at.isFired)
    figure.add(
        SegmentMark{{at.mark("M") + "/trail", Role::Result, Subject::Point}, place(at.Q), place(at.M)});
  PointMark torpedo = pointOf(at.M, at.isFired ? Role::Result : Role::Ghost, Subject::Point);
  if (at.elapsed == 0)
    torpedo.label.clear(); // the start has a letter of its own
  figure.add(std::move(torpedo));
  for (std::size_t place = 0; place < figure.marks.size(); ++place)
    figure.marks.change(place, [](Mark &mark) { baseOf(mark).passes = true; });
  return figure;
}

} // namespace

Construction torpedo_flight() {
  return taught<Out, RayObject, NumberObject, NumberObject, Several<MeshObject>>(
      {.id = "torpedo-flight",
       .title = [] { return words("flight of the torpedo"); },
       .roles = {"L", "frame", "seed", "meshes"},
       .letters = {"λM", "M"},
       .cases = {"waiting", "flying", "exploded", "zero-direction"},
       .values = {{named::number("lambda"), &Out::hasRay, &Out::lambda},
                  {named::vector("place"), &Out::hasRay, &Out::M}},
       .lines = {{"place", &Out::hasRay,
                  [](const Out &at) { return withNumbers(at.M == at.Q + at.lambda * at.r); }, placeWords}},
       .marks = {"M"},
       .tell = tell,
       .draw = draw});
}

} // namespace halfspace
