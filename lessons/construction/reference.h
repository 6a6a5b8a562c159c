// All constructions in writing, for authors of lessons.
#pragma once

#include <string>

namespace halfspace {

/// What each construction looks at and makes, and the names of its cases, values, lines and marks, as
/// Markdown.
[[nodiscard]] std::string referenceOfConstructions();

} // namespace halfspace
