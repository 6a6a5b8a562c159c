#include "widgets/working_panel.h"

#include "widgets/blank_field.h"
#include "widgets/colors.h"
#include "widgets/number_field.h"
#include "widgets/number_words.h"
#include "widgets/picture/term_formula.h"

#include <QApplication>
#include <QScrollBar>

#include <algorithm>
#include <cmath>

namespace halfspace {

namespace {

constexpr QSize usualSize(400, 480);

/// What a screen reader says of a line.
QString spokenOf(const WorkingLine &line, bool blanked) {
  if (blanked)
    return QString::fromStdString(questionText(line));
  QString text = QString::fromStdString(plainText(line));
  if (!line.sentence.empty())
    text += QStringLiteral(". ") + QString::fromStdString(line.sentence);
  return text;
}

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

void WorkingPanel::setWorking(const Working &working) {
  m_lines.clear();
  for (const WorkingLine &line : working.lines)
    m_lines.push_back(typesetLine(line));
  if (m_current && *m_current >= m_lines.size())
    m_current.reset();
  placeLines();
  updateAccessibleText();
}

TypesetLine WorkingPanel::typesetLine(const WorkingLine &line) const {
  const auto pictureOf = [this](const math::Row &formula) {
    return formula.empty() ? nullptr : m_typesetter.picture(formula);
  };
  TypesetLine typeset{line, {}, line.blank ? pictureOf(promptOf(*line.blank)) : nullptr};
  for (const LinePiece piece : {LinePiece::Symbols, LinePiece::Numbers, LinePiece::Result}) {
    TraceableFormula formula = formulaOf(line, piece);
    const auto index = static_cast<std::size_t>(piece);
    typeset.pieces[index] = pictureOf(formula.row);
    typeset.numbers[index] = std::move(formula.numbers);
  }
  return typeset;
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

void WorkingPanel::hideNumbers() {
  if (m_numbersHidden)
    return;
  m_numbersHidden = true;
  m_blanks.clear();
  m_remarks.clear();
  placeLines();
  updateAccessibleText();
}

void WorkingPanel::setBlanks(std::set<std::string> lineIds, std::map<std::string, LineRemark> remarks) {
  if (!m_numbersHidden && lineIds == m_blanks && remarks == m_remarks)
    return;
  m_numbersHidden = false;
  m_blanks = std::move(lineIds);
  m_remarks = std::move(remarks);
  placeLines();
  updateAccessibleText();
  followFocus(QApplication::focusWidget()); // what is said about a line makes it taller
}

bool WorkingPanel::isBlank(const std::string &lineId) const {
  return m_numbersHidden || m_blanks.contains(lineId);
}

std::map<std::string, LineState> WorkingPanel::lineStates() const {
  std::map<std::string, LineState> states;
  for (const TypesetLine &line : m_lines) {
    LineState &state = states[line.source.id];
    state.blank = isBlank(line.source.id);
    if (const auto remark = remarkOf(line.source.id))
      state.remark = remark->text;
  }
  for (const auto &[line, field] : m_fields)
    states[line].field = field->sizeHint();
  return states;
}

void WorkingPanel::placeLines() {
  const bool lostFocus = matchFields();
  const QSize room = viewport()->size();
  m_placed = placeWorking(m_lines, lineStates(), font(), room.width());
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
  if (lostFocus)
    focusField();
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
  for (const TypesetLine &line : m_lines)
    texts << spokenOf(line.source, isBlank(line.source.id));
  setAccessibleDescription(texts.join(u'\n'));
}

PlacedWorking WorkingPanel::placed() const {
  PlacedWorking placed = m_placed;
  for (PlacedLine &line : placed.lines) {
    line.box.translate(-scrolled());
    for (std::vector<PlacedText> *texts : {&line.remark, &line.sentence})
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
  return QString::fromStdString(isBlank(line.id) ? halfspace::latexOf(line, LinePiece::Symbols)
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
  return QPointF(horizontalScrollBar()->value(), verticalScrollBar()->value());
}

std::optional<std::size_t> WorkingPanel::lineAt(QPointF position) const {
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    if (const QRectF &box = m_placed.lines[i].box; position.y() >= box.top() && position.y() < box.bottom())
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
