// Lesson words: Markdown with `$…$` formulas as a document that can be laid out and painted.
#pragma once

#include "widgets/typeset/typesetter.h"

#include <QFont>
#include <QTextDocument>

#include <memory>

namespace halfspace {

/// Markdown in which every formula stands as a placeholder.
struct MarkdownWithMath {
  QString markdown;
  QStringList formulas; ///< LaTeX, in order: set as in a line of text, or large when alone in a paragraph or
                        ///< in `$$…$$`
};

/// Takes the formulas out. A `$` in code or after a backslash is no formula, nor is one without a partner in
/// its paragraph.
[[nodiscard]] MarkdownWithMath separateMath(const QString &markdown);

/// The distance of lines, as part of their height. Qt puts the extra space below each line.
inline constexpr double richLineSpacing = 1.28;

/// What rich text looks like.
struct RichTextStyle {
  QFont font;
  QColor ink;
};

/// A text ready to be painted, and to be read out.
struct RichText {
  std::unique_ptr<QTextDocument> document; ///< on one page without margins
  QString plain;                           ///< formulas included: for screen readers
};

/// HTML stands as it is written, links lead nowhere, and nothing is loaded: an image is its description.
[[nodiscard]] RichText makeRichText(const QString &markdown, const Typesetter &typesetter,
                                    const RichTextStyle &style);

/// The plain text alone.
[[nodiscard]] QString plainRichText(const QString &markdown);

} // namespace halfspace
