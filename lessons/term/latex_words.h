// Words for users in LaTeX.
#pragma once

#include <string>
#include <string_view>

namespace halfspace {

/// A sentence or a title as LaTeX that pdflatex sets. A character that it would stop at becomes a question
/// mark.
[[nodiscard]] std::string latexWords(std::string_view text);

} // namespace halfspace
