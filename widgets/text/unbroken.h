// Where lines of running text may not break.
#pragma once

#include <QString>

namespace halfspace {

/// No line breaks beside it, and it is as high as a letter, though it has no width.
inline constexpr QChar wordJoiner(0x2060);

/// The text with `t = −10/3` and `|n|` kept in one line each: no break beside a relation or inside the bars.
/// It is one character longer for each bar.
[[nodiscard]] QString unbroken(QString text);
/// The same text with breaks allowed again, for whoever reads it out.
[[nodiscard]] QString breakable(QString text);

} // namespace halfspace
