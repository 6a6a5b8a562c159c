// Formulas as characters of a document.
#pragma once

#include "widgets/typeset/typesetter.h"

#include <QTextCharFormat>
#include <QTextDocument>

namespace halfspace {

/// Lets a document paint formulas.
void enableMathObjects(QTextDocument &document);

/// The format of the character that is a formula: it stands on the baseline of the text around it, in its
/// colour, and carries a number by which it is known. The font of the text tells its size.
[[nodiscard]] QTextCharFormat mathObjectFormat(const Typesetter::Picture &picture, std::size_t number,
                                               QTextCharFormat text);
[[nodiscard]] std::size_t mathObjectNumber(const QTextCharFormat &format);

} // namespace halfspace
