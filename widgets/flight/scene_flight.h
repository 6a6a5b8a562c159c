// What a scene says of a torpedo's flight.
#pragma once

#include "lessons/construction/crossings.h"
#include "lessons/construction/parts/shots.h"
#include "lessons/lesson/lesson.h"
#include "lessons/object/kinds/number.h"
#include "lessons/scene/edit.h"
#include "lessons/scene/evaluation.h"

#include <optional>

namespace halfspace {

/// Frames of the clock are rounded to this, so that the numbers stay short.
inline const Rational frameStep(1, 100);

/// A flight as it stands in one frame. It is changed by edits of the two numbers that it follows from.
struct SceneFlight {
  StepFlight names;
  NumberObject frame;
  NumberObject seed; ///< of chance; 0: it is fired by hand

  [[nodiscard]] bool firesByItself() const { return seed.value != 0; }
  /// The shot that is on its way.
  [[nodiscard]] Shot shot() const { return shotAt(frame.value, seed.value); }
  /// The parameter to which the torpedo has come if it has hit nothing.
  [[nodiscard]] Rational elapsed() const { return parameterAt(frame.value, shot()); }
  /// What the torpedo hits first; nothing: nullptr.
  [[nodiscard]] const Crossing *hitIn(const Evaluation &evaluation) const;
  /// Fired by itself it goes on; by hand until the explosion is over.
  [[nodiscard]] Rational lastFrame(const Evaluation &evaluation) const;
  /// The frame in which the torpedo of this shot has come to t; where that is a crossing's, all of the way.
  [[nodiscard]] Rational frameAt(double t, const Evaluation &evaluation) const;

  /// As near to a frame, or to a seed, as the number may come.
  [[nodiscard]] ChangeObject toFrame(const Rational &wanted) const;
  [[nodiscard]] ChangeObject toSeed(int wanted) const;
};

/// Nothing where the scene has no such numbers.
[[nodiscard]] std::optional<SceneFlight> flightIn(const Scene &scene, const StepFlight &names);

} // namespace halfspace
