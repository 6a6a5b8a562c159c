// New numbers for the scene of a step.
#pragma once

#include "lessons/lesson/lesson.h"

#include <cstdint>

namespace halfspace {

/// The scene with other short numbers, see short_numbers.h, that is seen well from the direction `from` (not
/// zero), where chance allows: nothing flat edge-on, no line end-on, and no face too small. Where the step
/// asks a question its answer may become another one, as often as chance has it: special cases are rare.
[[nodiscard]] Scene withNewNumbers(const Scene &scene, const LessonStep &step, const glm::dvec3 &from,
                                   std::uint64_t seed);

/// The scene with the coordinates that its objects have in another one, wherever they are there and built
/// alike.
[[nodiscard]] Scene withNumbersOf(const Scene &other, Scene scene);

} // namespace halfspace
