// Texts as YAML has them.
#pragma once

#include <string>
#include <string_view>

namespace halfspace {

/// A text on one line as YAML reads it back, in single quotes where it needs some: also within brackets and
/// braces, and as a name. Requires a text without ends of lines.
[[nodiscard]] std::string yamlText(std::string_view text);

/// The same of a text of several lines, behind the name of a field without an indent. None of its lines has
/// white space alone, and it neither begins nor ends with any.
[[nodiscard]] std::string yamlLines(std::string_view text);

} // namespace halfspace
