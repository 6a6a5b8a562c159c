#include "widgets/text/markdown_writer.h"

#include "lessons/lesson/term_links.h"
#include "widgets/text/picture_object.h"
#include "widgets/text/unbroken.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextList>
#include <QTextTable>

#include <algorithm>
#include <utility>

namespace halfspace {

namespace {

using Kind = MarkdownBlock::Kind;

/// Space between paragraphs and between the items of a list, and by how much a list is indented, as part of
/// the type's size.
constexpr double paragraphGap = 0.55;
constexpr double itemGap = 0.12;
constexpr double listIndent = 1.4;

/// Space around the words of a table's cell: above and below, and at the sides between columns.
constexpr double cellGap = 0.2;
constexpr double columnGap = 0.5;

/// By how much a quote is indented, in pixels.
constexpr double quoteIndent = 40;

/// How many sizes of type a first-level heading is above that of the text, less one.
constexpr int headingSizes = 4;

QString textOf(const MarkdownSpan &span) {
  switch (span.kind) {
  case MarkdownSpan::Kind::Formula:
  case MarkdownSpan::Kind::Picture:
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

Qt::Alignment alignmentOf(MarkdownBlock::Side side) {
  return side == MarkdownBlock::Side::Middle  ? Qt::AlignHCenter
         : side == MarkdownBlock::Side::Right ? Qt::AlignRight
                                              : Qt::AlignLeft;
}

bool hasPicture(const QTextBlock &block) {
  for (auto piece = block.begin(); !piece.atEnd(); ++piece)
    if (isPictureObject(piece.fragment().charFormat()))
      return true;
  return false;
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
    case Kind::Table:
      return writeTable(block);
    case Kind::Row: // a table writes them
    case Kind::Cell:
      return;
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
    writeSpans(block);
  }

  void writeSpans(const MarkdownBlock &block) {
    const QStringList texts = unbrokenTexts(block.spans);
    int index = 0;
    for (const MarkdownSpan &span : block.spans) {
      const QString &text = texts[index++];
      if (block.kind == Kind::Code && span.kind == MarkdownSpan::Kind::LineBreak)
        startParagraph(block);
      else if (span.kind == MarkdownSpan::Kind::Picture)
        writePicture(span, spanFormat(block, span));
      else
        m_cursor.insertText(text, spanFormat(block, span));
      if (span.kind == MarkdownSpan::Kind::Formula) {
        m_formulas.push_back(span.formula);
        // A line of formulas alone would end on its baseline, and their depth be cut off.
        m_cursor.insertText(wordJoiner, textFormat(block));
      }
    }
  }

  void writePicture(const MarkdownSpan &span, QTextCharFormat format) {
    const QString description = QString::fromStdString(span.text);
    if (m_style.pictures.folder.empty())
      return m_cursor.insertText(description, format);
    const auto image = readPicture(m_style.pictures, span.picture);
    if (image)
      return m_cursor.insertText(QChar(QChar::ObjectReplacementCharacter),
                                 pictureObjectFormat(*image, description, format));
    if (m_style.warning.isValid())
      format.setForeground(m_style.warning);
    m_cursor.insertText(
        QStringLiteral("%1 (%2)").arg(description, QString::fromStdString(image.problem().sentence)), format);
  }

  void writeTable(const MarkdownBlock &table) {
    const auto widest = std::max_element(
        table.children.begin(), table.children.end(),
        [](const MarkdownBlock &a, const MarkdownBlock &b) { return a.children.size() < b.children.size(); });
    if (widest == table.children.end() || widest->children.empty())
      return;
    if (!m_lists.empty())
      m_lists.back().item = nullptr; // an item that begins with a table has no line for its mark
    QTextTable *grid = m_cursor.insertTable(static_cast<int>(table.children.size()),
                                            static_cast<int>(widest->children.size()), tableFormat());
    int row = 0;
    for (const MarkdownBlock &cells : table.children) {
      int column = 0;
      for (const MarkdownBlock &cell : cells.children)
        writeCell(cell, cells.heading, grid->cellAt(row, column++));
      ++row;
    }
    m_cursor = grid->lastCursorPosition();
    m_cursor.movePosition(QTextCursor::NextBlock);
    m_isEmpty = true; // the paragraph behind a table is always there
  }

  void writeCell(const MarkdownBlock &cell, bool isHeading, QTextTableCell place) {
    QTextTableCellFormat format;
    format.setTopPadding(typeSize() * cellGap);
    format.setBottomPadding(typeSize() * cellGap);
    format.setRightPadding(typeSize() * columnGap);
    format.setLeftPadding(typeSize() * columnGap);
    if (isHeading) {
      format.setBottomBorder(1);
      format.setBottomBorderStyle(QTextFrameFormat::BorderStyle_Solid);
      format.setBottomBorderBrush(m_style.ink);
    }
    m_cursor = place.firstCursorPosition();
    QTextBlockFormat paragraph;
    paragraph.setAlignment(alignmentOf(cell.side));
    m_cursor.setBlockFormat(paragraph);
    m_inTableHead = isHeading;
    m_cursor.setBlockCharFormat(textFormat(cell));
    writeSpans(cell);
    place.setFormat(format); // at last: it stands where the look of the first paragraph's end does
    m_inTableHead = false;
  }

  [[nodiscard]] QTextTableFormat tableFormat() const {
    QTextTableFormat format;
    format.setBorder(0);
    format.setBorderCollapse(true);
    format.setCellSpacing(0);
    format.setCellPadding(0);
    format.setLeftMargin(m_document.indentWidth() * static_cast<double>(m_lists.size()) +
                         quoteIndent * m_quotes);
    format.setBottomMargin(typeSize() * paragraphGap);
    return format;
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
    if (m_inTableHead)
      format.setFontWeight(QFont::Bold);
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
    if (!span.face.link.empty())
      setLink(format, span.face.link);
    return span.kind == MarkdownSpan::Kind::Formula ? m_formulaFormat(span.formula, format) : format;
  }

  void setLink(QTextCharFormat &format, const std::string &address) const {
    format.setAnchor(true);
    format.setAnchorHref(QString::fromStdString(address));
    const bool isTerm = !termAt(address).empty(); // many words are: these must not shout
    format.setUnderlineStyle(isTerm ? QTextCharFormat::DotLine : QTextCharFormat::SingleUnderline);
    if (m_style.link.isValid() && !isTerm)
      format.setForeground(m_style.link);
  }

  static void setFixedPitch(QTextCharFormat &format) {
    const QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    format.setFontFamilies({fixed.family()});
    format.setFontStyleHint(fixed.styleHint());
    format.setFontFixedPitch(true);
  }

  void setSpacing() {
    for (QTextBlock block = m_document.begin(); block.isValid(); block = block.next()) {
      if (QTextCursor(block).currentTable())
        continue; // cells have their own
      QTextBlockFormat format = block.blockFormat();
      const QTextBlock next = block.next();
      const bool betweenItems = block.textList() && next.isValid() && next.textList();
      format.setBottomMargin(next.isValid() ? typeSize() * (betweenItems ? itemGap : paragraphGap) : 0);
      const double spacing =
          hasPicture(block) ? 1 : richLineSpacing; // beside a picture it would be part of its height
      format.setLineHeight(100 * spacing, QTextBlockFormat::ProportionalHeight);
      QTextCursor(block).setBlockFormat(format);
    }
  }

  [[nodiscard]] double typeSize() const { return QFontInfo(m_style.font).pixelSize(); }

  const RichTextStyle &m_style;
  const FormulaFormat &m_formulaFormat;
  QTextDocument &m_document;
  QTextCursor m_cursor;
  bool m_isEmpty = true;
  bool m_inTableHead = false;
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
