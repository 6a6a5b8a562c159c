#include "widgets/working/working_block.h"

#include "widgets/colors.h"
#include "widgets/formula/term_formula.h"
#include "widgets/numbers/number_field.h"
#include "widgets/numbers/number_words.h"
#include "widgets/speak_by.h"
#include "widgets/working/blank_field.h"

#include <QAccessibleWidget>
#include <QApplication>

#include <algorithm>
#include <cmath>

namespace halfspace {

namespace {

/// Tells a screen reader of the lines.
class SpokenBlock : public QAccessibleWidget {
public:
  explicit SpokenBlock(WorkingBlock &block) : QAccessibleWidget(&block), m_block(block) {}

  [[nodiscard]] QString text(QAccessible::Text text) const override {
    return text == QAccessible::Description ? m_block.spoken() : QAccessibleWidget::text(text);
  }

private:
  const WorkingBlock &m_block;
};

constexpr int usualWidth = 400;
/// A field reaches so far below the baseline, in em of the formulas.
constexpr double fieldDepth = 0.4;

} // namespace

WorkingBlock::WorkingBlock(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_typesetter(typesetter), m_theme(themes().front()), m_scrub(*this) {
  speakBy<WorkingBlock, SpokenBlock>();
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Worked lines"));
  setMouseTracking(true);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  connect(qApp, &QApplication::focusChanged, this,
          [this](QWidget *, QWidget *focused) { followFocus(focused); });
  connectScrub();
}

WorkingBlock::~WorkingBlock() {
  // A field with a text that is no number complains when it loses the focus, as it does while it is deleted.
  if (m_typed)
    m_typed->field->disconnect(this);
}

void WorkingBlock::setWorking(const Working &working, Fade fade, std::map<std::string, LineRemark> remarks,
                              LineRange shown) {
  m_fade = std::move(fade);
  m_shown = {shown.begin, std::min(shown.end, working.lines.size())};
  const bool saysMore = remarks != m_remarks;
  m_remarks = std::move(remarks);
  showLines(working);
  if (saysMore)
    followFocus(QApplication::focusWidget()); // what is said about a line makes it taller
}

std::vector<WorkingLine> WorkingBlock::ownLines() const {
  const auto first = m_working.lines.begin();
  std::vector<WorkingLine> lines(first + static_cast<std::ptrdiff_t>(m_shown.begin),
                                 first + static_cast<std::ptrdiff_t>(m_shown.end));
  for (WorkingLine &line : lines)
    if (hides(line.id)) // a crossed sign of equality would tell what is asked
      for (Chain &chain : line.chains)
        chain = chain.asDemand();
  return lines;
}

void WorkingBlock::showLines(const Working &working) {
  m_working = working;
  const bool lostFocus = matchFields();
  typesetLines();
  if (m_current && *m_current >= m_lines.size())
    m_current.reset();
  placeLines();
  tellSpoken();
  if (lostFocus && !focusField())
    setFocus();
}

void WorkingBlock::typesetLines() {
  std::vector<TypesetLine> lines;
  for (const WorkingLine &line : ownLines())
    lines.push_back(hides(line.id) ? typesetPartially(line) : typeset(line));
  m_lines = std::move(lines);
}

Typesetter::Picture WorkingBlock::pictureOf(const math::Row &formula) const {
  return formula.empty() ? nullptr : m_typesetter.picture(formula);
}

void WorkingBlock::setPiece(TypesetLine &line, LinePiece piece, TraceableFormula formula) const {
  const auto index = static_cast<std::size_t>(piece);
  line.pieces[index] = pictureOf(formula.row);
  line.numbers[index] = std::move(formula.numbers);
}

TypesetLine WorkingBlock::typeset(const WorkingLine &line) const {
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

TypesetLine WorkingBlock::typesetPartially(const WorkingLine &line) const {
  TypesetLine typeset{line};
  typeset.isPartial = true;
  const Gap *gap = gapOf(line.id);
  if (!gap) {
    typeset.pieces[0] = pictureOf(formulaOf(symbolsOf(line)));
    return typeset;
  }
  for (const LinePiece piece : linePieces)
    setPiece(typeset, piece, formulaOf(line, piece, *gap, roomOfGap(line.id)));
  typeset.told = pictureOf(formulaOf(toldFor(line, *gap, m_working)));
  return typeset;
}

math::Room WorkingBlock::roomOfGap(const std::string &lineId) const {
  const QSizeF size = QSizeF(m_fields.at(lineId)->sizeHint()) / emPixelsOf(font());
  return {size.width(), size.height() - fieldDepth, fieldDepth};
}

void WorkingBlock::setTheme(const Theme &theme) {
  m_theme = theme;
  update();
}

void WorkingBlock::setInkOf(std::function<QColor(const QString &)> inkOf) {
  m_inkOf = std::move(inkOf);
  update();
}

void WorkingBlock::setHighlighted(std::set<std::string> markIds) {
  if (markIds == m_highlighted)
    return;
  m_highlighted = std::move(markIds);
  update();
}

const Gap *WorkingBlock::gapOf(const std::string &lineId) const {
  const auto gap = m_fade.gaps.find(lineId);
  return gap == m_fade.gaps.end() ? nullptr : &gap->second;
}

bool WorkingBlock::hides(const std::string &lineId) const {
  return gapOf(lineId) || m_fade.waiting.contains(lineId);
}

std::map<std::string, QString> WorkingBlock::remarkTexts() const {
  std::map<std::string, QString> texts;
  for (const TypesetLine &line : m_lines)
    if (const auto remark = remarkOf(line.source.id))
      texts[line.source.id] = remark->isOfNow ? remark->text : tr("Before the change: %1").arg(remark->text);
  return texts;
}

PlacedWorking WorkingBlock::placeIn(int width) const {
  return placeWorking(m_lines, remarkTexts(), m_sentences, font(), width,
                      m_held && width == this->width() ? *m_held : HeldLines());
}

void WorkingBlock::placeLines() {
  const double before = m_placed.size.height();
  m_placed = placeIn(width());
  if (m_held)
    hold();
  if (m_placed.size.height() != before)
    updateGeometry();
  moveFields();
  followNumberField();
  update();
}

void WorkingBlock::setHeld(bool held) {
  if (held == m_held.has_value())
    return;
  if (held) {
    m_held.emplace();
    hold();
  } else {
    m_held.reset();
    placeLines();
  }
}

void WorkingBlock::hold() {
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    (*m_held)[m_lines[i].source.id] = m_placed.lines[i];
}

std::optional<LineRemark> WorkingBlock::remarkOf(const std::string &lineId) const {
  if (m_typed && m_typed->place.line == lineId && !m_typed->refusal.isEmpty())
    return LineRemark{m_typed->refusal};
  const auto remark = m_remarks.find(lineId);
  return remark == m_remarks.end() ? std::nullopt : std::optional(remark->second);
}

QString WorkingBlock::spoken() const {
  if (const Term *chosen = m_chosenNumber ? shownNumbers().numberAt(*m_chosenNumber) : nullptr)
    return spokenWithOrigin(*chosen);
  QStringList texts;
  for (const WorkingLine &line : ownLines())
    texts << textOf(line);
  return texts.join(u'\n');
}

void WorkingBlock::tellSpoken() {
  QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
  QAccessible::updateAccessibility(&changed); // nothing is made where nobody listens
}

QString WorkingBlock::textOf(const WorkingLine &line) const {
  if (const Gap *gap = gapOf(line.id))
    return QString::fromStdString(questionText(line, *gap));
  if (hides(line.id))
    return QString::fromStdString(symbolsText(line));
  QString text = QString::fromStdString(plainText(line));
  if (!line.sentence.empty())
    text += QStringLiteral(". ") + QString::fromStdString(line.sentence);
  return text;
}

QString WorkingBlock::latexOf(const WorkingLine &line) const {
  return QString::fromStdString(hides(line.id) ? halfspace::latexOf(line, LinePiece::Symbols)
                                               : halfspace::latexOf(line));
}

QString WorkingBlock::latexOfAll() const {
  QStringList lines;
  for (const TypesetLine &line : m_lines)
    lines << latexOf(line.source);
  return lines.join(QLatin1String(" \\\\\n"));
}

int WorkingBlock::heightForWidth(int width) const {
  const double height = width == this->width() ? m_placed.size.height() : placeIn(width).size.height();
  return static_cast<int>(std::ceil(height));
}

QSize WorkingBlock::sizeHint() const { return {usualWidth, heightForWidth(usualWidth)}; }

QSize WorkingBlock::minimumSizeHint() const {
  return {static_cast<int>(std::ceil(narrowestWidth(m_lines, font()))), 0};
}

std::optional<std::size_t> WorkingBlock::lineAt(QPointF position) const {
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    if (m_placed.lines[i].box.contains(position))
      return i;
  return std::nullopt;
}

QString WorkingBlock::markAt(QPointF position) const {
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

QColor WorkingBlock::inkOf(const QString &markId) const {
  return markId.isEmpty() || !m_inkOf ? toQColor(m_theme.ink) : m_inkOf(markId);
}

} // namespace halfspace
