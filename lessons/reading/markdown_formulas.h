// Takes the formulas and live values out of Markdown, as their letters mean something else there.
#pragma once

#include "lessons/reading/markdown.h"

namespace halfspace {

/// A text in which each formula is one character that stands for it, and that means nothing in Markdown.
struct MarkdownWithoutFormulas {
  std::string markdown;
  std::vector<MarkdownFormula> formulas;
  std::vector<std::size_t> loneDollars{}; ///< the places in the text of those without a partner
};

/// Requires at most `maxMarkdownBytes`, so that there are characters enough.
[[nodiscard]] MarkdownWithoutFormulas takeFormulas(std::string_view text);

/// Where the next formula stands in such a text, or in a piece of it.
struct FormulaPlace {
  std::size_t begin; ///< the size of the text where there is none
  std::size_t end;
  std::size_t formula; ///< its index
};
[[nodiscard]] FormulaPlace nextFormula(std::string_view text);

} // namespace halfspace
