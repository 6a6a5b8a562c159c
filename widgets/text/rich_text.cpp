#include "widgets/text/rich_text.h"

#include "widgets/text/formula_among_words.h"
#include "widgets/text/markdown_writer.h"
#include "widgets/text/math_object.h"
#include "widgets/text/picture_object.h"
#include "widgets/text/unbroken.h"

#include <QAbstractTextDocumentLayout>
#include <QTextBlock>
#include <QTextCursor>

#include <algorithm>
#include <utility>

namespace halfspace {

namespace {

constexpr QChar formulaCharacter(QChar::ObjectReplacementCharacter);

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

/// The format of the character at a place.
QTextCharFormat formatAt(const QTextDocument &document, int place) {
  QTextCursor behind(document.findBlock(place));
  behind.setPosition(place + 1); // its format is that of the character before
  return behind.charFormat();
}

/// The document's text, with the description of each picture in its place.
QString textWithDescriptions(const QTextDocument &document) {
  const QString text = document.toPlainText();
  QString described;
  for (int place = 0; place < text.size(); ++place) {
    const QTextCharFormat format =
        text[place] == formulaCharacter ? formatAt(document, place) : QTextCharFormat();
    described += isPictureObject(format) ? pictureDescription(format) : QString(text[place]);
  }
  return described;
}

} // namespace

RichText::RichText(FilledMarkdown words, const Typesetter &typesetter, RichTextStyle style)
    : m_typesetter(&typesetter), m_style(std::move(style)), m_words(std::move(words)) {
  makeDocument();
}

RichText::RichText(RichText &&) noexcept = default;
RichText &RichText::operator=(RichText &&) noexcept = default;
RichText::~RichText() = default;

void RichText::setWords(FilledMarkdown words) {
  const FilledMarkdown before = std::exchange(m_words, std::move(words));
  if (m_words.blocks == before.blocks)
    replaceFormulas(before.formulas);
  else
    makeDocument();
}

void RichText::setStyle(RichTextStyle style) {
  dropDocument();
  m_style = std::move(style);
  makeDocument();
}

QString RichText::plain() const {
  QString plain;
  auto formula = m_shown.begin();
  for (const QChar character : m_plain)
    if (character == formulaCharacter)
      plain += plainFormula(*formula++);
    else
      plain += character;
  return plain;
}

QString RichText::plainFormula(std::size_t formula) const {
  const QString plain = QString::fromStdString(plainText(m_words.formulas[formula], m_typesetter->macros()));
  return m_failed.count(formula) == 0
             ? plain
             : tr("%1 (a formula that cannot be read: %2)").arg(plain, problemOf(formula));
}

QString RichText::problemOf(std::size_t formula) const {
  const auto failed = m_failed.find(formula);
  if (failed == m_failed.end())
    return {};
  const int column = failed->second->errorColumn();
  const QString sentence = failed->second->error();
  return column > 0 ? tr("Column %1: %2").arg(column).arg(sentence) : sentence;
}

QString RichText::problemAt(QPointF place) const {
  const int character = m_failed.empty() ? -1 : characterAt(*m_document, place);
  if (character < 0 || m_document->characterAt(character) != formulaCharacter)
    return {};
  const QTextCharFormat format = formatAt(*m_document, character);
  return isPictureObject(format) ? QString() : problemOf(mathObjectNumber(format));
}

QString RichText::linkAt(QPointF place) const { return m_document->documentLayout()->anchorAt(place); }

std::vector<QTextCursor> RichText::links() const {
  std::vector<QTextCursor> links;
  QString last;
  for (QTextBlock block = m_document->begin(); block.isValid(); block = block.next(), last.clear())
    for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
      const QTextFragment fragment = piece.fragment();
      const QString address = fragment.charFormat().anchorHref();
      if (!address.isEmpty() && address != last) {
        links.emplace_back(block);
        links.back().setPosition(fragment.position());
      }
      if (!address.isEmpty())
        links.back().setPosition(fragment.position() + fragment.length(), QTextCursor::KeepAnchor);
      last = address;
    }
  return links;
}

/// The room that its pictures took is free again.
void RichText::dropDocument() {
  m_document.reset();
  *m_style.pictures.pixelsLeft += std::exchange(m_pixelsTaken, 0);
}

void RichText::makeDocument() {
  dropDocument();
  const int pixelsBefore = *m_style.pictures.pixelsLeft;
  m_document = std::make_unique<QTextDocument>();
  m_document->setUndoRedoEnabled(false);
  m_document->setDefaultFont(m_style.font);
  m_document->setDocumentMargin(0);
  enableMathObjects(*m_document);
  enablePictureObjects(*m_document);
  m_failed.clear();
  m_shown = writeMarkdown(
      m_words.blocks, m_style,
      [this](std::size_t formula, const QTextCharFormat &text) { return formulaFormat(formula, text); },
      *m_document);
  m_pixelsTaken = pixelsBefore - *m_style.pictures.pixelsLeft;
  m_plain = breakable(textWithDescriptions(*m_document));
}

QTextCharFormat RichText::formulaFormat(std::size_t formula, QTextCharFormat text) {
  const Typesetter::Picture picture = pictureOf(m_words.formulas[formula], *m_typesetter);
  const bool failed = !picture->error().isEmpty();
  m_failed.erase(formula);
  if (failed)
    m_failed[formula] = picture;
  text.setForeground(failed && m_style.warning.isValid() ? m_style.warning : m_style.ink);
  text.setFont(m_style.font, QTextCharFormat::FontPropertiesSpecifiedOnly);
  return mathObjectFormat(picture, formula, text);
}

/// Sets those that are not as they were.
void RichText::replaceFormulas(const std::vector<FilledFormula> &before) {
  QTextCursor place(m_document.get());
  place.beginEditBlock();
  for (int at = 0; at < m_document->characterCount(); ++at) {
    if (m_document->characterAt(at) != formulaCharacter)
      continue;
    place.setPosition(at);
    place.setPosition(at + 1, QTextCursor::KeepAnchor);
    if (isPictureObject(place.charFormat()))
      continue;
    const std::size_t formula = mathObjectNumber(place.charFormat());
    if (m_words.formulas[formula] != before[formula])
      place.insertText(formulaCharacter, formulaFormat(formula, place.charFormat()));
  }
  place.endEditBlock();
}

} // namespace halfspace
