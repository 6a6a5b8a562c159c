// Writes the blocks of a Markdown text into a document.
#pragma once

#include "lessons/reading/markdown.h"
#include "widgets/text/rich_text_style.h"

#include <QTextCharFormat>
#include <QTextDocument>

#include <functional>

namespace halfspace {

/// The format of the character that a formula is, given that of text in its place.
using FormulaFormat = std::function<QTextCharFormat(std::size_t formula, const QTextCharFormat &text)>;

/// Writes into an empty document, in which each formula and each picture is one object replacement character
/// and nothing else is. Returns the formulas in the order in which they stand there.
std::vector<std::size_t> writeMarkdown(const std::vector<MarkdownBlock> &blocks, const RichTextStyle &style,
                                       const FormulaFormat &formulaFormat, QTextDocument &document);

} // namespace halfspace
