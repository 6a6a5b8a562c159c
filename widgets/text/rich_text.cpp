#include "widgets/text/rich_text.h"

#include "lessons/lesson/prose.h"
#include "widgets/text/unbroken.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextList>
#include <QTextObjectInterface>

#include <algorithm>
#include <utility>

Q_DECLARE_METATYPE(halfspace::Typesetter::Picture)

namespace halfspace {

namespace {

// Placeholders are a number between two characters that no text has.
constexpr QChar placeholderBegin(0xE000);
constexpr QChar placeholderEnd(0xE001);

constexpr int mathObject = QTextFormat::UserObject + 1;
constexpr int pictureProperty = QTextFormat::UserProperty + 1;
constexpr int indexProperty = QTextFormat::UserProperty + 2;

/// Formulas that reach deeper below the baseline (in em) make room for themselves; others hang into the
/// line's own.
constexpr double hangingDepth = 0.33;

/// The size of formulas, in heights of the text's x. Those whose x is as high as the text's (2.26) look too
/// large beside it.
constexpr double inlineSize = 2.1;

/// Space between paragraphs and between the items of a list, as part of the type's size.
constexpr double paragraphGap = 0.55;
constexpr double itemGap = 0.12;

const QString textStyle = QStringLiteral("\\textstyle ");
/// Without a space before it, even behind \right).
const QString closing = QStringLiteral("\\mathclose");

/// Finds the formulas of a Markdown text.
class MathScanner {
public:
  explicit MathScanner(QString markdown) : m_text(std::move(markdown)) {
    m_text.remove(placeholderBegin).remove(placeholderEnd);
  }

  [[nodiscard]] MarkdownWithMath scan() {
    while (m_next < m_text.size()) {
      const QChar character = m_text[m_next];
      if (character == u'\\')
        copy(2);
      else if (character == u'`')
        passCode();
      else if (character != u'$' || !takeFormula())
        copy(1);
    }
    return std::move(m_found);
  }

private:
  void copy(int count) {
    m_found.markdown += m_text.mid(m_next, count);
    m_next += count;
  }

  [[nodiscard]] int runLength(int at) const {
    int end = at;
    while (end < m_text.size() && m_text[end] == m_text[at])
      ++end;
    return end - at;
  }

  void passCode() {
    const int fence = runLength(m_next);
    const int close = m_text.indexOf(QString(fence, u'`'), m_next + fence);
    copy(close < 0 ? fence : close + fence - m_next);
  }

  /// Replaces a formula that begins here by a placeholder; false if none does.
  bool takeFormula() {
    const int dollars = std::min(runLength(m_next), 2);
    const int begin = m_next + dollars;
    const int end = closingDollar(begin, dollars);
    if (end <= begin)
      return false;
    const bool large = dollars == 2 || isAlone(m_next, end + dollars);
    const QString latex = takeSource(begin, end);
    m_next = end + dollars;
    m_found.markdown += placeholderBegin + QString::number(m_found.formulas.size()) + placeholderEnd;
    m_found.formulas << (large ? latex : textStyle + latex + takeAttached());
    return true;
  }

  QString takeSource(int begin, int end) {
    QString latex = m_text.mid(begin, end - begin).trimmed();
    m_found.sources.push_back({m_text.indexOf(latex, begin), latex});
    return latex;
  }

  /// What the end of a line would tear off a formula, as lines may break behind every object: the rest of
  /// `$a$ = $b$`, and punctuation.
  QString takeAttached() {
    static const QRegularExpression related(QStringLiteral(" (?:([=<>]) \\$|\\$(?=\\\\approx))(?!\\$)"));
    QString attached;
    const auto match = related.match(m_text, m_next, QRegularExpression::NormalMatch,
                                     QRegularExpression::AnchoredMatchOption);
    const int begin = match.capturedEnd();
    const int end = match.hasMatch() ? closingDollar(begin, 1) : -1;
    if (end > begin) {
      attached = " " + match.captured(1) + " " + takeSource(begin, end);
      m_next = end + 1;
    }
    if (m_next < m_text.size() && QStringLiteral(",.;:!?").contains(m_text[m_next]))
      attached += closing + "{\\text{" + QString(m_text[m_next++]) + "}}";
    return attached;
  }

  /// Where the partner of the dollars before `begin` stands; −1 if they have none in their paragraph.
  [[nodiscard]] int closingDollar(int begin, int dollars) const {
    for (int at = begin; at < m_text.size(); ++at) {
      if (m_text[at] == u'\\')
        ++at;
      else if (m_text[at] == u'\n' && at + 1 < m_text.size() && m_text[at + 1] == u'\n')
        return -1;
      else if (m_text[at] == u'$' && runLength(at) >= dollars)
        return dollars == 1 && m_text[at - 1].isSpace() ? -1 : at;
    }
    return -1;
  }

  /// Whether nothing else stands in the paragraph.
  [[nodiscard]] bool isAlone(int begin, int end) const {
    const int before = m_text.lastIndexOf(QLatin1String("\n\n"), begin);
    const int after = m_text.indexOf(QLatin1String("\n\n"), end);
    const QString around =
        m_text.mid(before + 1, begin - before - 1) + m_text.mid(end, after < 0 ? -1 : after - end);
    return around.trimmed().isEmpty();
  }

  QString m_text;
  MarkdownWithMath m_found;
  int m_next = 0;
};

/// A formula without what was put around it.
QString asWritten(QString formula) {
  static const QRegularExpression attached(QRegularExpression::escape(closing) +
                                           QStringLiteral("\\{\\\\text\\{(.)\\}\\}$"));
  if (formula.startsWith(textStyle))
    formula.remove(0, textStyle.size());
  return formula.replace(attached, QStringLiteral("\\1"));
}

/// Draws the formulas of a document.
class MathObject : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)
public:
  using QObject::QObject;

  /// The room that the formula takes. Qt sets the bottom of a normal object on the baseline, and the middle
  /// of a middle one a quarter of the x-height above it.
  QSizeF intrinsicSize(QTextDocument *, int, const QTextFormat &format) override {
    const Typesetter::Picture picture = pictureOf(format);
    const double x = xHeight(format);
    const double ascent = picture->ascent() * x * inlineSize;
    const double depth = picture->depth() * x * inlineSize;
    const double width = picture->width() * x * inlineSize;
    return hangs(*picture) ? QSizeF(width, ascent)
                           : QSizeF(width, std::max(2 * ascent - x / 2, 2 * depth + x / 2));
  }

  void drawObject(QPainter *painter, const QRectF &rect, QTextDocument *, int,
                  const QTextFormat &format) override {
    const Typesetter::Picture picture = pictureOf(format);
    const double x = xHeight(format);
    const double baseline = hangs(*picture) ? rect.bottom() : rect.center().y() + x / 4;
    picture->paint(*painter, {rect.left(), baseline}, x * inlineSize,
                   [&](const QString &) { return format.foreground().color(); });
  }

  [[nodiscard]] static bool hangs(const MathPicture &picture) { return picture.depth() <= hangingDepth; }

private:
  [[nodiscard]] static Typesetter::Picture pictureOf(const QTextFormat &format) {
    return format.property(pictureProperty).value<Typesetter::Picture>();
  }
  [[nodiscard]] static double xHeight(const QTextFormat &format) {
    return QFontMetricsF(format.toCharFormat().font()).xHeight();
  }
};

/// Opens nothing, whatever the text names.
class ClosedDocument : public QTextDocument {
protected:
  QVariant loadResource(int, const QUrl &) override { return {}; }
};

void setInk(QTextDocument &document, const RichTextStyle &style) {
  QTextCursor all(&document);
  all.select(QTextCursor::Document);
  QTextCharFormat ink;
  ink.setForeground(style.ink);
  ink.setAnchor(false);
  ink.setAnchorHref({});
  ink.setFontUnderline(false);
  all.mergeCharFormat(ink);
}

void setSpacing(QTextDocument &document, const RichTextStyle &style) {
  const double size = QFontInfo(style.font).pixelSize();
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    QTextBlockFormat format = block.blockFormat();
    format.setTopMargin(0);
    const QTextBlock next = block.next();
    const bool betweenItems = block.textList() && next.isValid() && next.textList();
    format.setBottomMargin(next.isValid() ? size * (betweenItems ? itemGap : paragraphGap) : 0);
    format.setLineHeight(100 * richLineSpacing, QTextBlockFormat::ProportionalHeight);
    QTextCursor(block).setBlockFormat(format);
  }
}

void replaceImages(QTextDocument &document) {
  for (QTextCursor image = document.find(QString(QChar::ObjectReplacementCharacter)); !image.isNull();
       image = document.find(QString(QChar::ObjectReplacementCharacter), image)) {
    const QString description = image.charFormat().stringProperty(QTextFormat::ImageAltText);
    image.insertText(description, QTextCharFormat());
  }
}

/// The document with its placeholders.
std::unique_ptr<QTextDocument> documentOf(const QString &markdown, const RichTextStyle &style) {
  auto document = std::make_unique<ClosedDocument>();
  document->setUndoRedoEnabled(false);
  document->setDefaultFont(style.font);
  document->setDocumentMargin(0);
  document->setIndentWidth(QFontInfo(style.font).pixelSize() * 1.4);
  document->documentLayout()->registerHandler(mathObject, new MathObject(document.get()));
  document->setMarkdown(unbroken(markdown), QTextDocument::MarkdownFeatures(QTextDocument::MarkdownNoHTML) |
                                                QTextDocument::MarkdownDialectGitHub);
  return document;
}

/// The formula that a character of the document is, if it is one.
QTextCharFormat formatAt(QTextDocument &document, int position) {
  QTextCursor cursor(&document);
  cursor.setPosition(position + 1); // its format is that of the character before
  return cursor.charFormat();
}

/// The character under a place of the document; −1: none.
int characterAt(const QTextDocument &document, QPointF place) {
  constexpr double overhang = 0.2; // letters reach beyond their line by so much of its height
  const QTextBlock block =
      document.findBlock(std::max(document.documentLayout()->hitTest(place, Qt::FuzzyHit), 0));
  const QPointF inBlock = place - block.layout()->position();
  for (int i = 0; i < block.layout()->lineCount(); ++i) {
    const QTextLine line = block.layout()->lineAt(i);
    const double more = overhang * line.height();
    if (line.naturalTextRect().adjusted(0, -more, 0, more).contains(inBlock))
      return block.position() + line.xToCursor(inBlock.x(), QTextLine::CursorOnCharacter);
  }
  return -1;
}

/// A plain text with its formulas in the places of the placeholders.
QString withFormulas(QString plain, const QStringList &formulas, const Macros &macros) {
  for (int i = 0; i < formulas.size(); ++i) {
    const std::string latex = asWritten(formulas[i]).toStdString();
    plain.replace(placeholderBegin + QString::number(i) + placeholderEnd,
                  QString::fromStdString(plainProse(latex, macros)));
  }
  return plain;
}

} // namespace

MarkdownWithMath separateMath(const QString &markdown) { return MathScanner(markdown).scan(); }

RichText::RichText(const QString &markdown, const Typesetter &typesetter, RichTextStyle style)
    : m_typesetter(&typesetter), m_style(std::move(style)), m_text(separateMath(markdown)) {
  makeDocument();
}

RichText::RichText(RichText &&) noexcept = default;
RichText &RichText::operator=(RichText &&) noexcept = default;
RichText::~RichText() = default;

void RichText::setMarkdown(const QString &markdown) {
  const MarkdownWithMath before = std::exchange(m_text, separateMath(markdown));
  if (m_text.markdown == before.markdown)
    replaceFormulas(before.formulas);
  else
    makeDocument();
}

QString RichText::plain() const {
  QString plain = m_plain;
  for (const auto &[index, picture] : m_failed) {
    const QString placeholder = placeholderBegin + QString::number(index) + placeholderEnd;
    plain.replace(placeholder,
                  tr("%1 (a formula that cannot be read: %2)").arg(placeholder, problemOf(index)));
  }
  return withFormulas(plain, m_text.formulas, m_typesetter->macros());
}

QString RichText::problemOf(int formula) const {
  const auto failed = m_failed.find(formula);
  if (failed == m_failed.end())
    return {};
  const int column = failed->second->errorColumn();
  const QString sentence = failed->second->error();
  return column > 0 ? tr("Column %1: %2").arg(column).arg(sentence) : sentence;
}

QString RichText::problemAt(QPointF place) const {
  const int character = m_failed.empty() ? -1 : characterAt(*m_document, place);
  if (character < 0 || m_document->characterAt(character) != QChar::ObjectReplacementCharacter)
    return {};
  return problemOf(formatAt(*m_document, character).intProperty(indexProperty));
}

void RichText::makeDocument() {
  m_document = documentOf(m_text.markdown, m_style);
  m_failed.clear();
  QTextCursor changes(m_document.get());
  changes.beginEditBlock(); // it is laid out once
  replaceImages(*m_document);
  m_plain = m_document->toPlainText();
  setInk(*m_document, m_style);
  setSpacing(*m_document, m_style);
  const QRegularExpression placeholder(placeholderBegin + QStringLiteral("(\\d+)") + placeholderEnd);
  for (QTextCursor place = m_document->find(placeholder); !place.isNull();
       place = m_document->find(placeholder, place)) {
    const QString number = place.selectedText();
    placeFormula(place, number.mid(1, number.size() - 2).toInt());
  }
  changes.endEditBlock();
}

void RichText::placeFormula(QTextCursor place, int index) {
  Typesetter::Picture picture = m_typesetter->picture(m_text.formulas.value(index));
  if (!picture->error().isEmpty())
    picture = m_typesetter->picture(asWritten(m_text.formulas.value(index)));
  m_failed.erase(index);
  if (!picture->error().isEmpty())
    m_failed[index] = picture;
  QTextCharFormat format = place.charFormat();
  format.setForeground(picture->error().isEmpty() || !m_style.warning.isValid() ? m_style.ink
                                                                                : m_style.warning);
  format.setFont(m_style.font, QTextCharFormat::FontPropertiesSpecifiedOnly);
  format.setObjectType(mathObject);
  format.setProperty(pictureProperty, QVariant::fromValue(picture));
  format.setProperty(indexProperty, index);
  format.setVerticalAlignment(MathObject::hangs(*picture) ? QTextCharFormat::AlignNormal
                                                          : QTextCharFormat::AlignMiddle);
  place.insertText(QString(QChar::ObjectReplacementCharacter), format);
}

/// Sets those that are not as they were.
void RichText::replaceFormulas(const QStringList &before) {
  QTextCursor place(m_document.get());
  place.beginEditBlock();
  for (int at = 0; at < m_document->characterCount(); ++at) {
    if (m_document->characterAt(at) != QChar::ObjectReplacementCharacter)
      continue;
    place.setPosition(at);
    place.setPosition(at + 1, QTextCursor::KeepAnchor);
    const int index = place.charFormat().intProperty(indexProperty);
    if (m_text.formulas.value(index) != before.value(index))
      placeFormula(place, index);
  }
  place.endEditBlock();
}

} // namespace halfspace

#include "rich_text.moc"
