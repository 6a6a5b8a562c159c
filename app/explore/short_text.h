// Fields for a sentence or two.
#pragma once

#include <QPlainTextEdit>

namespace halfspace {

/// A field of so many lines, that Tab leaves.
[[nodiscard]] QPlainTextEdit *shortText(const QString &name, int lines);

} // namespace halfspace
