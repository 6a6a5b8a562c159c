#include "widgets/working/working_panel.h"

#include "widgets/colors.h"
#include "widgets/numbers/number_field.h"
#include "widgets/numbers/number_words.h"
#include "widgets/picture/term_formula.h"
#include "widgets/working/blank_field.h"

#include <QApplication>
#include <QScrollBar>

#include <algorithm>
#include <cmath>

namespace halfspace {

namespace {

constexpr QSize usualSize(400, 480);

// The room of a blank without a field, in em of the formulas.
constexpr double blankWidth = 4;
constexpr double blankAscent = 1.1;
/// A field or a blank reaches so far below the baseline, likewise.
constexpr double blankDepth = 0.4;

} // namespace

WorkingPanel::WorkingPanel(const Typesetter &typesetter, QWidget *parent)
    : QAbstractScrollArea(parent), m_typesetter(typesetter), m_theme(themes().front()), m_scrub(*this) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Working"));
  viewport()->setMouseTracking(true);
  viewport()->setAutoFillBackground(false);
  connect(qApp, &QApplication::focusChanged, this,
          [this](QWidget *, QWidget *focused) { followFocus(focused); });
  connectScrub();
}

WorkingPanel::~WorkingPanel() {
  // A field with a text that is no number complains when it loses the focus, as it does while it is deleted.
  if (m_typed)
    m_typed->field->disconnect(this);
}

void WorkingPanel::setWorking(const Working &working, Fade fade, std::map<std::string, LineRemark> remarks) {
  m_fade = std::move(fade);
  m_asks = true;
  const bool saysMore = remarks != m_remarks;
  m_remarks = std::move(remarks);
  showLines(working);
  if (saysMore)
    followFocus(QApplication::focusWidget()); // what is said about a line makes it taller
}

void WorkingPanel::setWorkingWithoutNumbers(const Working &working) {
  m_fade = {};
  for (const WorkingLine &line : working.lines)
    if (hasNumbers(line))
      m_fade.gaps.emplace(line.id, resultGap(line));
  m_asks = false;
  m_remarks.clear();
  showLines(working);
}

void WorkingPanel::showLines(const Working &working) {
  m_working = working;
  const bool lostFocus = matchFields();
  typesetLines();
  if (m_current && *m_current >= m_lines.size())
    m_current.reset();
  placeLines();
  updateAccessibleText();
  if (lostFocus)
    focusField();
}

void WorkingPanel::typesetLines() {
  std::vector<TypesetLine> lines;
  for (const WorkingLine &line : m_working.lines)
    lines.push_back(hides(line.id) ? typesetPartially(line) : typeset(line));
  m_lines = std::move(lines);
}

Typesetter::Picture WorkingPanel::pictureOf(const math::Row &formula) const {
  return formula.empty() ? nullptr : m_typesetter.picture(formula);
}

void WorkingPanel::setPiece(TypesetLine &line, LinePiece piece, TraceableFormula formula) const {
  const auto index = static_cast<std::size_t>(piece);
  line.pieces[index] = pictureOf(formula.row);
  line.numbers[index] = std::move(formula.numbers);
}

TypesetLine WorkingPanel::typeset(const WorkingLine &line) const {
  const auto before = std::find_if(m_lines.begin(), m_lines.end(),
                                   [&](const TypesetLine &each) { return each.source.id == line.id; });
  const bool hasBefore = before != m_lines.end() && !before->isPartial;
  TypesetLine typeset{line};
  for (const LinePiece piece : linePieces) {
    const auto index = static_cast<std::size_t>(piece);
    if (hasBefore && areInterchangeable(before->source, line, piece)) {
      typeset.pieces[index] = before->pieces[index];
      typeset.numbers[index] = before->numbers[index];
    } else {
      setPiece(typeset, piece, formulaOf(line, piece));
    }
  }
  return typeset;
}

TypesetLine WorkingPanel::typesetPartially(const WorkingLine &line) const {
  TypesetLine typeset{line};
  typeset.isPartial = true;
  const Gap *gap = gapOf(line.id);
  if (!gap) {
    typeset.pieces[0] = pictureOf(formulaOf(symbolsOf(line)));
    return typeset;
  }
  for (const LinePiece piece : linePieces)
    setPiece(typeset, piece, formulaOf(line, piece, *gap, roomOfGap(line.id)));
  if (m_asks)
    typeset.told = pictureOf(formulaOf(toldFor(line, *gap, m_working)));
  return typeset;
}

math::Room WorkingPanel::roomOfGap(const std::string &lineId) const {
  const auto field = m_fields.find(lineId);
  if (field == m_fields.end())
    return {blankWidth, blankAscent, blankDepth};
  const QSizeF size = QSizeF(field->second->sizeHint()) / emPixelsOf(font());
  return {size.width(), size.height() - blankDepth, blankDepth};
}

void WorkingPanel::setTheme(const Theme &theme) {
  m_theme = theme;
  viewport()->update();
}

void WorkingPanel::setInkOf(std::function<QColor(const QString &)> inkOf) {
  m_inkOf = std::move(inkOf);
  viewport()->update();
}

void WorkingPanel::setWholeWorking(std::function<Working()> working) { m_wholeWorking = std::move(working); }

void WorkingPanel::setHighlighted(std::set<std::string> markIds) {
  if (markIds == m_highlighted)
    return;
  m_highlighted = std::move(markIds);
  viewport()->update();
}

const Gap *WorkingPanel::gapOf(const std::string &lineId) const {
  const auto gap = m_fade.gaps.find(lineId);
  return gap == m_fade.gaps.end() ? nullptr : &gap->second;
}

bool WorkingPanel::hides(const std::string &lineId) const {
  return gapOf(lineId) || m_fade.waiting.contains(lineId);
}

std::map<std::string, QString> WorkingPanel::remarkTexts() const {
  std::map<std::string, QString> texts;
  for (const TypesetLine &line : m_lines)
    if (const auto remark = remarkOf(line.source.id))
      texts[line.source.id] = remark->text;
  return texts;
}

void WorkingPanel::placeLines() {
  const QSize room = viewport()->size();
  m_placed = placeWorking(m_lines, remarkTexts(), m_sentences, font(), room.width());
  const QSize content(static_cast<int>(std::ceil(m_placed.size.width())),
                      static_cast<int>(std::ceil(m_placed.size.height())));
  verticalScrollBar()->setRange(0, std::max(0, content.height() - room.height()));
  verticalScrollBar()->setPageStep(room.height());
  verticalScrollBar()->setSingleStep(fontMetrics().height() * 2);
  horizontalScrollBar()->setRange(0, std::max(0, content.width() - room.width()));
  horizontalScrollBar()->setPageStep(room.width());
  moveFields();
  followNumbers();
  viewport()->update();
}

std::optional<LineRemark> WorkingPanel::remarkOf(const std::string &lineId) const {
  if (m_typed && m_typed->place.line == lineId && !m_typed->refusal.isEmpty())
    return LineRemark{m_typed->refusal};
  const auto remark = m_remarks.find(lineId);
  return remark == m_remarks.end() ? std::nullopt : std::optional(remark->second);
}

void WorkingPanel::scrollContentsBy(int, int) {
  moveFields();
  moveNumberField();
  viewport()->update();
}

void WorkingPanel::updateAccessibleText() {
  if (const Term *chosen = m_chosenNumber ? shownNumbers().numberAt(*m_chosenNumber) : nullptr)
    return setAccessibleDescription(spokenWithOrigin(*chosen));
  QStringList texts;
  for (const WorkingLine &line : m_working.lines)
    texts << textOf(line);
  setAccessibleDescription(texts.join(u'\n'));
}

QString WorkingPanel::textOf(const WorkingLine &line) const {
  if (const Gap *gap = gapOf(line.id))
    return QString::fromStdString(questionText(line, *gap));
  if (hides(line.id))
    return QString::fromStdString(symbolsText(line));
  QString text = QString::fromStdString(plainText(line));
  if (!line.sentence.empty())
    text += QStringLiteral(". ") + QString::fromStdString(line.sentence);
  return text;
}

PlacedWorking WorkingPanel::placed() const {
  PlacedWorking placed = m_placed;
  for (PlacedLine &line : placed.lines) {
    line.box.translate(-scrolled());
    for (std::vector<PlacedText> *texts : {&line.heading, &line.remark, &line.sentence})
      for (PlacedText &text : *texts)
        text.baseline -= scrolled();
    if (!line.blank.isNull())
      line.blank.translate(-scrolled());
    for (PlacedFormula &formula : line.formulas)
      formula.baseline -= scrolled();
  }
  return placed;
}

QString WorkingPanel::latexOf(const WorkingLine &line) const {
  return QString::fromStdString(hides(line.id) ? halfspace::latexOf(line, LinePiece::Symbols)
                                               : halfspace::latexOf(line));
}

QString WorkingPanel::latexOfAll() const {
  QStringList lines;
  for (const TypesetLine &line : m_lines)
    lines << latexOf(line.source);
  return lines.join(QLatin1String(" \\\\\n"));
}

QSize WorkingPanel::sizeHint() const { return usualSize; }

QPointF WorkingPanel::scrolled() const {
  return {double(horizontalScrollBar()->value()), double(verticalScrollBar()->value())};
}

std::optional<std::size_t> WorkingPanel::lineAt(QPointF position) const {
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    if (m_placed.lines[i].box.contains(position))
      return i;
  return std::nullopt;
}

QString WorkingPanel::markAt(QPointF position) const {
  const auto line = lineAt(position);
  if (!line)
    return {};
  QString found;
  for (const PlacedFormula &formula : m_placed.lines[*line].formulas)
    for (const auto &[mark, box] : formula.picture->markBoxes()) // the innermost comes last
      if (formula.toWorking(box)
              .adjusted(-touchMargin, -touchMargin, touchMargin, touchMargin)
              .contains(position))
        found = mark;
  return found;
}

QColor WorkingPanel::inkOf(const QString &markId) const {
  return markId.isEmpty() || !m_inkOf ? toQColor(m_theme.ink) : m_inkOf(markId);
}

} // namespace halfspace
