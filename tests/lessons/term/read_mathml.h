// MathML read back, for comparison with what other notations say.
#pragma once

#include <string>

namespace halfspace::test {

/// A `<math>` element as plain text writes the same: 2⁻³ for <msup>, a/b for <mfrac>, det[…] for a table
/// between bars. Parentheses, spaces and arrows above letters are left out. Throws where it is no XML.
[[nodiscard]] std::string plainMathMl(const std::string &math);

/// Plain text without what `plainMathMl` leaves out.
[[nodiscard]] std::string withoutGrouping(std::string text);

} // namespace halfspace::test
