// Lesson words: Markdown with `$…$` formulas as a document that can be laid out and painted.
#pragma once

#include "widgets/typeset/typesetter.h"

#include <QCoreApplication>
#include <QFont>
#include <QTextCursor>
#include <QTextDocument>
#include <QVector>

#include <map>
#include <memory>

namespace halfspace {

/// Markdown in which every formula stands as a placeholder.
struct MarkdownWithMath {
  /// What stands between dollars, without spaces at its ends.
  struct Source {
    int place; ///< in the text that was given
    QString latex;
  };

  QString markdown;
  QStringList formulas; ///< LaTeX, in order: set as in a line of text, or large when alone in a paragraph or
                        ///< in `$$…$$`
  QVector<Source> sources; ///< as they were written; some formulas above are made of two
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
  QColor warning{}; ///< for formulas that cannot be read; not valid: the ink
};

/// A text ready to be painted, and to be read out. HTML stands as it is written, links lead nowhere, and
/// nothing is loaded: an image is its description.
class RichText {
  Q_DECLARE_TR_FUNCTIONS(RichText)

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
  /// Why the formula at a place of the document cannot be read; empty where there is none, or it can.
  [[nodiscard]] QString problemAt(QPointF place) const;
  /// Formulas included, and what is wrong with some: for screen readers.
  [[nodiscard]] QString plain() const;

private:
  void makeDocument();
  void placeFormula(QTextCursor place, int index);
  void replaceFormulas(const QStringList &before);
  [[nodiscard]] QString problemOf(int formula) const;

  const Typesetter *m_typesetter;
  RichTextStyle m_style;
  MarkdownWithMath m_text;
  QString m_plain;                             ///< with placeholders
  std::map<int, Typesetter::Picture> m_failed; ///< formulas that cannot be read, by index
  std::unique_ptr<QTextDocument> m_document;
};

} // namespace halfspace
