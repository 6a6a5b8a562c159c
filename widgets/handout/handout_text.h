// What a handout of a lesson says.
#pragma once

#include "widgets/handout/handout_block.h"
#include "widgets/handout/lesson_handout.h"

namespace halfspace {

[[nodiscard]] HandoutText handoutText(const HandoutRequest &request, const HandoutLook &look,
                                      const math::MathFonts &fonts);

} // namespace halfspace
