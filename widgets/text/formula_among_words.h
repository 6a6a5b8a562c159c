// Formulas as they are set among words.
#pragma once

#include "lessons/lesson/filled_markdown.h"
#include "widgets/typeset/typesetter.h"

namespace halfspace {

/// The formula with what follows it. Where its LaTeX cannot be read, its source as it was written, with an
/// error. Never null.
[[nodiscard]] Typesetter::Picture pictureOf(const FilledFormula &formula, const Typesetter &typesetter);

} // namespace halfspace
