// The one owner of state: which lesson, which step, which scene.
#pragma once

#include "lessons/construction/outcome.h"
#include "lessons/scene/scene.h"

namespace halfspace {

struct Session {
  std::string lesson; ///< the lesson's id
  int step = 0;       ///< the step shown, from 0
  Scene scene;
  bool operator==(const Session &) const = default;
};

/// Something a user did to an object: its new value.
struct Edit {
  std::string object; ///< the entry's name
  Object value;
};

/// Coordinates are bounded so that every picture and every exact number stays within reason.
inline const Rational coordinateLimit = 1000000000;
/// The most digits of a coordinate's numerator or denominator.
inline constexpr std::size_t coordinateDigits = 40;

/// The sentences for a number that is beyond the two bounds.
[[nodiscard]] std::string sentenceForTooLarge();
[[nodiscard]] std::string sentenceForTooLong();

/// Whether a typed number may become a coordinate; if not, the sentence that says why.
[[nodiscard]] std::optional<std::string> refuseCoordinate(const Rational &value);

/// The session after an edit: unchanged when there is no such object, it is of another kind, or a coordinate
/// is one that `refuseCoordinate` refuses.
[[nodiscard]] Session apply(Session session, const Edit &edit);

/// Evaluates the scene from top to bottom. The last construction's values, working and case are the outcome;
/// the figure holds the marks of all, and marks for objects that no construction draws. Requires what the
/// readers check: every construction exists, and its roles name objects above it of the right kinds.
[[nodiscard]] Outcome evaluate(const Scene &scene);

} // namespace halfspace
