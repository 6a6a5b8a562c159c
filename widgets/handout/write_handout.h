// A handout as a file.
#pragma once

#include "widgets/handout/handout_block.h"
#include "widgets/handout/handout_look.h"
#include "widgets/handout/set_words.h"

namespace halfspace {

/// A tagged PDF of the pages that it takes, with a bookmark for each step. The same handout gives the same
/// bytes.
[[nodiscard]] std::string writeHandout(const HandoutText &handout, const HandoutLook &look,
                                       const HandoutFonts &fonts);

} // namespace halfspace
