#include "widgets/text/markdown_writer.h"

#include "widgets/text/unbroken.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextList>

#include <utility>

namespace halfspace {

namespace {

using Kind = MarkdownBlock::Kind;

/// Space between paragraphs and between the items of a list, and by how much a list is indented, as part of
/// the type's size.
constexpr double paragraphGap = 0.55;
constexpr double itemGap = 0.12;
constexpr double listIndent = 1.4;

/// By how much a quote is indented, in pixels.
constexpr double quoteIndent = 40;

/// How many sizes of type a first-level heading is above that of the text, less one.
constexpr int headingSizes = 4;

QString textOf(const MarkdownSpan &span) {
  switch (span.kind) {
  case MarkdownSpan::Kind::Formula:
    return QChar(QChar::ObjectReplacementCharacter);
  case MarkdownSpan::Kind::LineBreak:
    return QChar(QChar::LineSeparator);
  case MarkdownSpan::Kind::Text:
    break;
  }
  return QString::fromStdString(span.text).remove(QChar(QChar::ObjectReplacementCharacter));
}

/// The text of each piece, without places where a line must not end. Those depend on what stands in the next.
QStringList unbrokenTexts(const std::vector<MarkdownSpan> &spans) {
  QStringList texts;
  for (const MarkdownSpan &span : spans)
    texts << textOf(span);
  const QString whole = unbroken(texts.join(QString()));
  int begin = 0;
  for (QString &text : texts) {
    const int length = text.size() + text.count(QChar('|'));
    text = whole.mid(begin, length);
    begin += length;
  }
  return texts;
}

QTextListFormat listFormat(char mark, int level) {
  QTextListFormat format;
  format.setIndent(level);
  format.setStyle(mark == '*'   ? QTextListFormat::ListCircle
                  : mark == '+' ? QTextListFormat::ListSquare
                  : mark == '-' ? QTextListFormat::ListDisc
                                : QTextListFormat::ListDecimal);
  if (format.style() == QTextListFormat::ListDecimal)
    format.setNumberSuffix(QChar::fromLatin1(mark));
  return format;
}

class MarkdownWriter {
public:
  MarkdownWriter(const RichTextStyle &style, const FormulaFormat &formulaFormat, QTextDocument &document)
      : m_style(style), m_formulaFormat(formulaFormat), m_document(document), m_cursor(&document) {}

  std::vector<std::size_t> write(const std::vector<MarkdownBlock> &blocks) {
    m_document.setIndentWidth(typeSize() * listIndent);
    m_cursor.beginEditBlock(); // it is laid out once
    writeBlocks(blocks);
    setSpacing();
    m_cursor.endEditBlock();
    return std::move(m_formulas);
  }

private:
  /// A list that is being written.
  struct OpenList {
    QTextListFormat format;
    QTextList *list = nullptr;           ///< once it has an item
    const MarkdownBlock *item = nullptr; ///< the present one, while nothing of it is written
  };

  void writeBlocks(const std::vector<MarkdownBlock> &blocks) {
    for (const MarkdownBlock &block : blocks)
      writeBlock(block);
  }

  void writeBlock(const MarkdownBlock &block) {
    switch (block.kind) {
    case Kind::Paragraph:
    case Kind::Heading:
    case Kind::Code:
    case Kind::Rule:
      return writeWords(block);
    case Kind::Quote:
      ++m_quotes;
      writeBlocks(block.children);
      --m_quotes;
      return;
    case Kind::List:
      return writeList(block);
    case Kind::Item:
      m_lists.back().item = &block;
      return writeBlocks(block.children);
    }
  }

  void writeList(const MarkdownBlock &list) {
    if (!m_lists.empty())
      m_lists.back().item = nullptr; // an item that begins with a list has no line for a mark of its own
    m_lists.push_back({listFormat(list.mark, static_cast<int>(m_lists.size()) + 1)});
    writeBlocks(list.children);
    m_lists.pop_back();
  }

  void writeWords(const MarkdownBlock &block) {
    if (block.kind == Kind::Code && block.spans.empty())
      return; // no line is no empty line
    startParagraph(block);
    const QStringList texts = unbrokenTexts(block.spans);
    int index = 0;
    for (const MarkdownSpan &span : block.spans) {
      const QString &text = texts[index++];
      if (block.kind == Kind::Code && span.kind == MarkdownSpan::Kind::LineBreak)
        startParagraph(block);
      else
        m_cursor.insertText(text, spanFormat(block, span));
      if (span.kind == MarkdownSpan::Kind::Formula) {
        m_formulas.push_back(span.formula);
        // A line of formulas alone would end on its baseline, and their depth be cut off.
        m_cursor.insertText(wordJoiner, textFormat(block));
      }
    }
  }

  void startParagraph(const MarkdownBlock &block) {
    // The mark of an item takes its look from its paragraph: it is as large before a heading as elsewhere.
    const QTextCharFormat look = textFormat(m_lists.empty() ? block : MarkdownBlock());
    if (std::exchange(m_isEmpty, false)) {
      m_cursor.setBlockFormat(paragraphFormat(block));
      m_cursor.setBlockCharFormat(look);
    } else {
      m_cursor.insertBlock(paragraphFormat(block), look);
    }
    if (m_lists.empty() || !std::exchange(m_lists.back().item, nullptr))
      return;
    OpenList &open = m_lists.back();
    if (open.list)
      open.list->add(m_cursor.block());
    else
      open.list = m_cursor.createList(open.format);
  }

  [[nodiscard]] QTextBlockFormat paragraphFormat(const MarkdownBlock &block) const {
    QTextBlockFormat format;
    format.setHeadingLevel(block.level);
    if (block.kind == Kind::Rule)
      format.setProperty(QTextFormat::BlockTrailingHorizontalRulerWidth,
                         QTextLength(QTextLength::PercentageLength, 100));
    if (m_quotes > 0) {
      format.setLeftMargin(quoteIndent * m_quotes);
      format.setRightMargin(quoteIndent);
    }
    if (const MarkdownBlock *item = m_lists.empty() ? nullptr : m_lists.back().item) {
      if (item->ticked)
        format.setMarker(*item->ticked ? QTextBlockFormat::MarkerType::Checked
                                       : QTextBlockFormat::MarkerType::Unchecked);
    } else {
      format.setIndent(static_cast<int>(m_lists.size()));
    }
    return format;
  }

  [[nodiscard]] QTextCharFormat textFormat(const MarkdownBlock &block) const {
    QTextCharFormat format;
    format.setForeground(m_style.ink);
    if (block.kind == Kind::Heading) {
      format.setProperty(QTextFormat::FontSizeAdjustment, headingSizes - block.level);
      format.setFontWeight(QFont::Bold);
    }
    if (block.kind == Kind::Code)
      setFixedPitch(format);
    return format;
  }

  [[nodiscard]] QTextCharFormat spanFormat(const MarkdownBlock &block, const MarkdownSpan &span) const {
    QTextCharFormat format = textFormat(block);
    if (span.face.strong)
      format.setFontWeight(QFont::Bold);
    if (span.face.emphasized)
      format.setFontItalic(true);
    if (span.face.struck)
      format.setFontStrikeOut(true);
    if (span.face.code)
      setFixedPitch(format);
    return span.kind == MarkdownSpan::Kind::Formula ? m_formulaFormat(span.formula, format) : format;
  }

  static void setFixedPitch(QTextCharFormat &format) {
    const QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    format.setFontFamilies({fixed.family()});
    format.setFontStyleHint(fixed.styleHint());
    format.setFontFixedPitch(true);
  }

  void setSpacing() {
    for (QTextBlock block = m_document.begin(); block.isValid(); block = block.next()) {
      QTextBlockFormat format = block.blockFormat();
      const QTextBlock next = block.next();
      const bool betweenItems = block.textList() && next.isValid() && next.textList();
      format.setBottomMargin(next.isValid() ? typeSize() * (betweenItems ? itemGap : paragraphGap) : 0);
      format.setLineHeight(100 * richLineSpacing, QTextBlockFormat::ProportionalHeight);
      QTextCursor(block).setBlockFormat(format);
    }
  }

  [[nodiscard]] double typeSize() const { return QFontInfo(m_style.font).pixelSize(); }

  const RichTextStyle &m_style;
  const FormulaFormat &m_formulaFormat;
  QTextDocument &m_document;
  QTextCursor m_cursor;
  bool m_isEmpty = true;
  int m_quotes = 0;
  std::vector<OpenList> m_lists;
  std::vector<std::size_t> m_formulas;
};

} // namespace

std::vector<std::size_t> writeMarkdown(const std::vector<MarkdownBlock> &blocks, const RichTextStyle &style,
                                       const FormulaFormat &formulaFormat, QTextDocument &document) {
  return MarkdownWriter(style, formulaFormat, document).write(blocks);
}

} // namespace halfspace
