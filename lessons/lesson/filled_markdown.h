// A lesson's words with what their live values are at present. Nothing of them is read again for it.
#pragma once

#include "lessons/lesson/live_values.h"
#include "lessons/lesson/macros.h"
#include "lessons/reading/markdown.h"

namespace halfspace {

/// LaTeX as it was written, or a number.
using FormulaSide = std::variant<std::string, LiveNumber>;

/// What stands among words as one formula.
struct FilledFormula {
  std::vector<FormulaSide> sides{}; ///< one or two
  std::string relation{};           ///< between two: =, < or >; empty where the second begins with its own
  bool large = false;               ///< see `MarkdownFormula`
  std::string punctuation{};        ///< that follows it
  bool operator==(const FilledFormula &) const = default;
};

/// Blocks as those of `Markdown`. A live value is a formula where it is a number, alone or with what it is
/// said to be equal to, else text.
struct FilledMarkdown {
  std::vector<MarkdownBlock> blocks{};
  std::vector<FilledFormula> formulas{}; ///< in the order of the spans, each of one
  bool operator==(const FilledMarkdown &) const = default;
};

/// Whether some of the words become others as the scene does.
[[nodiscard]] bool hasLiveValues(const Markdown &markdown);

/// A rounded number's ≈ takes the place of an = before it.
[[nodiscard]] FilledMarkdown filledIn(const Markdown &markdown, const LiveValueOf &valueOf);

/// The same with the names of live values, in their braces.
[[nodiscard]] FilledMarkdown withNames(const Markdown &markdown);

/// Without what follows it.
[[nodiscard]] std::string latexOf(const FilledFormula &formula);
/// On one line, with what follows it.
[[nodiscard]] std::string plainText(const FilledFormula &formula, const Macros &macros = {});

} // namespace halfspace
