// The Markdown of lessons as blocks of a handout.
#pragma once

#include "lessons/lesson/filled_markdown.h"
#include "widgets/formula/math_font.h"
#include "widgets/handout/handout_block.h"
#include "widgets/picture/theme.h"

#include <functional>
#include <optional>

namespace halfspace {

/// What formulas are set with.
struct FormulaSetting {
  const math::MathFonts &fonts;
  const Macros &macros;
  /// The colour of what is marked with a mark's id; nothing: that of the words.
  std::function<std::optional<Color>(const std::string &mark)> inkOf;
};

/// A row of a formula in type, with its plain text.
[[nodiscard]] InlineFormula inlineFormula(const math::Row &row, std::string plain,
                                          const FormulaSetting &setting);

/// The blocks of a text. A picture is described in words, and a link is the words that it has.
[[nodiscard]] HandoutBlocks handoutBlocks(const FilledMarkdown &markdown, const FormulaSetting &setting);

/// The text of all its paragraphs as one.
[[nodiscard]] InlineText oneParagraph(const FilledMarkdown &markdown, const FormulaSetting &setting);

} // namespace halfspace
