// How the lines are painted.
#include "widgets/colors.h"
#include "widgets/text/indices.h"
#include "widgets/verdict.h"
#include "widgets/working/blank_field.h"
#include "widgets/working/working_block.h"

#include <QPaintEvent>
#include <QPainter>

namespace halfspace {
namespace {

// In pixels.
constexpr double highlightRadius = 4;
constexpr double barWidth = 3;
constexpr double remarkMarkRadius = 6.5;
constexpr double numberMargin = 2;
constexpr double ringWidth = 1.5;
constexpr double underlineWidth = 1;

/// How much of the accent the block's background has, and the bar before it.
constexpr double blockTint = 0.04;
constexpr double barTint = 0.3;
constexpr double highlightOpacity = 0.20;
/// Of lines that a traced number came from: a whole line needs less than a term.
constexpr double tracedLineOpacity = 0.09;
constexpr double hoverOpacity = 0.10;

QColor translucent(QColor color, double opacity) {
  color.setAlphaF(opacity);
  return color;
}

void paintText(QPainter &painter, const PlacedText &text) {
  const QFont font = painter.font();
  for (const SentenceBreaker::Run &run : text.runs) {
    painter.setFont(run.isIndex ? indexFont(font) : font);
    painter.drawText(text.baseline + QPointF(run.x, run.isIndex ? indexDrop(font) : 0), run.text);
  }
  painter.setFont(font);
}

/// Numbers stand closer to each other than terms do.
QRectF numberRoom(const QRectF &box) {
  return box.adjusted(-numberMargin, -numberMargin, numberMargin, numberMargin);
}

QRectF touchedRoom(const QRectF &box) {
  return box.adjusted(-touchMargin, -touchMargin, touchMargin, touchMargin);
}

} // namespace

void WorkingBlock::paintEvent(QPaintEvent *event) {
  QPainter painter(this);
  painter.fillRect(event->rect(), toQColor(mix(m_theme.panel, m_theme.accent, blockTint)));
  painter.fillRect(QRectF(0, 0, barWidth, height()), toQColor(mix(m_theme.panel, m_theme.accent, barTint)));
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 0; i < m_placed.lines.size(); ++i)
    if (m_placed.lines[i].box.intersects(event->rect()))
      paintLine(painter, i);
}

void WorkingBlock::paintBackground(QPainter &painter, std::size_t index) const {
  const PlacedLine &line = m_placed.lines[index];
  const QColor accent = toQColor(m_theme.accent);
  const std::string &id = m_lines[index].source.id;
  // The line of the traced number itself shows the number.
  const bool isSource = m_tracedLines.contains(id) && m_tracedNumber && m_tracedNumber->line != id;
  if (isSource)
    painter.fillRect(line.box, translucent(accent, tracedLineOpacity));
  if (isSource || (m_current == index && hasFocus()))
    painter.fillRect(
        QRectF(line.box.left(), line.box.top() + touchMargin, barWidth, line.box.height() - 2 * touchMargin),
        accent);
}

void WorkingBlock::paintLine(QPainter &painter, std::size_t index) const {
  const PlacedLine &line = m_placed.lines[index];
  paintBackground(painter, index);
  paintNumbers(painter, index);
  for (const PlacedFormula &formula : line.formulas) {
    paintHighlights(painter, formula);
    const bool failed = !formula.picture->error().isEmpty();
    formula.picture->paint(painter, formula.baseline, formula.emPixels, [&](const QString &mark) {
      return failed ? toQColor(m_theme.warning) : inkOf(mark);
    });
  }
  if (const auto remark = remarkOf(m_lines[index].source.id))
    paintRemark(painter, line, *remark);
  painter.setPen(toQColor(m_theme.mutedInk));
  for (const auto *texts : {&line.heading, &line.sentence})
    for (const PlacedText &text : *texts)
      paintText(painter, text);
}

void WorkingBlock::paintNumbers(QPainter &painter, std::size_t index) const {
  const QColor accent = toQColor(m_theme.accent);
  const auto forEachBox = [&](const std::optional<NumberPlace> &number, const auto &paintBox) {
    if (number && number->line == m_lines[index].source.id)
      for (const QRectF &box : shownNumbers().boxesOf(*number))
        paintBox(numberRoom(box));
  };
  const auto fillWith = [&](double opacity) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(translucent(accent, opacity));
  };
  forEachBox(m_tracedNumber, [&](const QRectF &room) {
    fillWith(highlightOpacity);
    painter.drawRoundedRect(room, highlightRadius, highlightRadius);
  });
  forEachBox(m_hoveredNumber, [&](const QRectF &room) {
    fillWith(hoverOpacity);
    painter.drawRoundedRect(room, highlightRadius, highlightRadius);
    painter.fillRect(QRectF(room.left(), room.bottom() - underlineWidth, room.width(), underlineWidth),
                     accent);
  });
  for (const auto *ringed : {&m_tracedNumber, &m_chosenNumber})
    forEachBox(*ringed, [&](const QRectF &room) {
      const bool hasRing = ringed == &m_tracedNumber || hasFocus();
      painter.setPen(hasRing ? QPen(accent, ringWidth) : QPen(Qt::NoPen));
      painter.setBrush(Qt::NoBrush);
      painter.drawRoundedRect(room, highlightRadius, highlightRadius);
    });
}

void WorkingBlock::paintHighlights(QPainter &painter, const PlacedFormula &formula) const {
  painter.setPen(Qt::NoPen);
  for (const auto &[mark, box] : formula.picture->markBoxes()) {
    if (!m_highlighted.count(mark.toStdString()))
      continue;
    painter.setBrush(translucent(inkOf(mark), highlightOpacity));
    painter.drawRoundedRect(touchedRoom(formula.toWorking(box)), highlightRadius, highlightRadius);
  }
}

void WorkingBlock::paintRemark(QPainter &painter, const PlacedLine &line, const LineRemark &remark) const {
  if (line.remark.empty())
    return;
  const double middle = fontMetrics().capHeight() / 2.0;
  const QPointF first = line.remark.front().baseline;
  if (remark.isOfNow)
    paintVerdict(painter, first - QPointF(1.5 * remarkMarkRadius, middle), remarkMarkRadius,
                 remark.right ? Verdict::Right : Verdict::Wrong, m_theme);
  painter.setPen(toQColor(!remark.isOfNow ? m_theme.mutedInk
                          : remark.right  ? m_theme.inkOf(Subject::Triangle)
                                          : m_theme.warning));
  for (const PlacedText &text : line.remark)
    paintText(painter, text);
}

} // namespace halfspace
