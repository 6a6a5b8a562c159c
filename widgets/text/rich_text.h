// Lesson words: Markdown with `$…$` formulas as a document that can be laid out and painted.
#pragma once

#include "lessons/lesson/filled_markdown.h"
#include "widgets/text/rich_text_style.h"
#include "widgets/typeset/typesetter.h"

#include <QCoreApplication>
#include <QTextCharFormat>
#include <QTextCursor>
#include <QTextDocument>

#include <map>
#include <memory>

namespace halfspace {

/// A text ready to be painted, and to be read out.
class RichText {
  Q_DECLARE_TR_FUNCTIONS(RichText)

public:
  /// The typesetter must outlive the text.
  RichText(FilledMarkdown words, const Typesetter &typesetter, RichTextStyle style);
  RichText(RichText &&) noexcept;
  RichText &operator=(RichText &&) noexcept;
  ~RichText();

  /// Becomes another text. Where only formulas differ, as with new values of the same words, all else stays
  /// laid out as it is.
  void setWords(FilledMarkdown words);
  [[nodiscard]] const FilledMarkdown &words() const { return m_words; }

  void setStyle(RichTextStyle style);

  /// On one page without margins.
  [[nodiscard]] QTextDocument &document() const { return *m_document; }
  /// Why the formula at a place of the document cannot be read; empty where there is none, or it can.
  [[nodiscard]] QString problemAt(QPointF place) const;
  /// The address of the link at a place of the document; empty where there is none.
  [[nodiscard]] QString linkAt(QPointF place) const;
  /// The links as selections, in the order of the text.
  [[nodiscard]] std::vector<QTextCursor> links() const;
  /// Formulas included, and what is wrong with some, and pictures' descriptions: for screen readers.
  [[nodiscard]] QString plain() const;

private:
  void makeDocument();
  void dropDocument();
  [[nodiscard]] QTextCharFormat formulaFormat(std::size_t formula, QTextCharFormat text);
  void replaceFormulas(const std::vector<FilledFormula> &before);
  [[nodiscard]] QString problemOf(std::size_t formula) const;
  [[nodiscard]] QString plainFormula(std::size_t formula) const;

  const Typesetter *m_typesetter;
  RichTextStyle m_style;
  FilledMarkdown m_words;
  QString m_plain;                                     ///< with a character for each formula
  std::vector<std::size_t> m_shown;                    ///< the formulas, in the order of the document
  std::map<std::size_t, Typesetter::Picture> m_failed; ///< formulas that cannot be read
  int m_pixelsTaken = 0;                               ///< of the room for the page's pictures
  std::unique_ptr<QTextDocument> m_document;
};

} // namespace halfspace
