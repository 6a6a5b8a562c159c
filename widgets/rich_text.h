// Lesson words: Markdown with `$…$` formulas as a document that can be laid out and painted.
#pragma once

#include "widgets/typeset/typesetter.h"

#include <QFont>
#include <QTextCursor>
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

/// A text ready to be painted, and to be read out. HTML stands as it is written, links lead nowhere, and
/// nothing is loaded: an image is its description.
class RichText {
public:
  /// The typesetter must outlive the text.
  RichText(const QString &markdown, const Typesetter &typesetter, RichTextStyle style);
  RichText(RichText &&) noexcept;
  RichText &operator=(RichText &&) noexcept;
  ~RichText();

  /// Becomes another text. Where only formulas differ, as with new values of the same words, all else stays
  /// laid out as it is.
  void setMarkdown(const QString &markdown);

  /// On one page without margins.
  [[nodiscard]] QTextDocument &document() const { return *m_document; }
  /// Formulas included: for screen readers.
  [[nodiscard]] QString plain() const;

private:
  void makeDocument();
  void placeFormula(QTextCursor place, int index);
  void replaceFormulas(const QStringList &before);

  const Typesetter *m_typesetter;
  RichTextStyle m_style;
  MarkdownWithMath m_text;
  QString m_plain; ///< with placeholders
  std::unique_ptr<QTextDocument> m_document;
};

} // namespace halfspace
