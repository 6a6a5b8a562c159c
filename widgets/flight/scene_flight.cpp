#include "widgets/flight/scene_flight.h"

#include <algorithm>

namespace halfspace {
namespace {

/// A flight goes on for so many frames behind the hit, and for so many where nothing is hit.
constexpr int framesBehindHit = 50;
constexpr int framesWithoutHit = 100;

/// After so many frames a torpedo has come to t, or a little farther.
Rational framesUntil(const Rational &t) { return roundUpToMultiple(t * framesPerLambda, frameStep); }

ChangeObject changed(const std::string &name, NumberObject number, const Rational &wanted) {
  number.value = std::clamp(wanted, number.from, number.to);
  return {name, number};
}

std::optional<NumberObject> numberIn(const Scene &scene, const std::string &name) {
  const Object *object = findObject(scene, name);
  return object ? objectAs<NumberObject>(*object) : std::nullopt;
}

} // namespace

const Crossing *SceneFlight::hitIn(const Evaluation &evaluation) const {
  return nearestOf(crossingsOf(evaluation, names.hits));
}

Rational SceneFlight::lastFrame(const Evaluation &evaluation) const {
  if (firesByItself())
    return frame.to;
  const Crossing *hit = hitIn(evaluation);
  const Rational last =
      hit ? Rational(framesUntil(hit->at->t) + framesBehindHit) : Rational(framesWithoutHit);
  return std::min(last, frame.to);
}

Rational SceneFlight::frameAt(double t, const Evaluation &evaluation) const {
  const Shot fired = shot();
  Rational flown = roundToMultiple(t * framesPerLambda, frameStep);
  for (const Crossing &crossing : crossingsOf(evaluation, names.hits).all)
    if (crossing.at && toDouble(crossing.at->t) == t) {
      flown = framesUntil(crossing.at->t);
      break;
    }
  const Rational there = fired.frame + flown;
  return firesByItself() // it stays with its shot
             ? std::clamp(there, fired.frame, Rational(fired.frame + framesPerShot - frameStep))
             : there;
}

ChangeObject SceneFlight::toFrame(const Rational &wanted) const {
  return changed(names.frame, frame, wanted);
}

ChangeObject SceneFlight::toSeed(int wanted) const { return changed(names.seed, seed, Rational(wanted)); }

std::optional<SceneFlight> flightIn(const Scene &scene, const StepFlight &names) {
  const auto frame = numberIn(scene, names.frame);
  const auto seed = numberIn(scene, names.seed);
  if (!frame || !seed)
    return {};
  return SceneFlight{names, *frame, *seed};
}

} // namespace halfspace
