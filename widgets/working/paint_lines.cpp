#include "widgets/working/paint_lines.h"

#include "widgets/colors.h"
#include "widgets/text/indices.h"
#include "widgets/verdict.h"

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

class LinesPainter {
public:
  LinesPainter(QPainter &painter, const BlockLayout &layout, const WorkingLook &look, const ShownTrace &trace,
               const TouchedLines &touched)
      : m_painter(painter), m_layout(layout), m_look(look), m_trace(trace), m_touched(touched),
        m_accent(toQColor(look.theme.accent)) {}

  void paintLine(std::size_t index) const;

private:
  void paintBackground(std::size_t index) const;
  void paintNumbers(std::size_t index) const;
  void paintHighlights(const PlacedFormula &formula) const;
  void paintRemark(const std::vector<PlacedText> &texts, const LineRemark &remark) const;
  /// Paints something in the room of each box of a number that stands in the line.
  template <class PaintRoom>
  void inRoomsOf(const std::optional<NumberPlace> &number, std::size_t index,
                 const PaintRoom &paintRoom) const;
  void fillWith(const QColor &color, double opacity) const;
  [[nodiscard]] QColor inkOf(const QString &markId) const;
  [[nodiscard]] const std::string &idOf(std::size_t index) const { return m_layout.lines()[index].source.id; }

  QPainter &m_painter;
  const BlockLayout &m_layout;
  const WorkingLook &m_look;
  const ShownTrace &m_trace;
  const TouchedLines &m_touched;
  QColor m_accent;
};

void LinesPainter::paintLine(std::size_t index) const {
  const PlacedLine &line = m_layout.placed().lines[index];
  paintBackground(index);
  paintNumbers(index);
  for (const PlacedFormula &formula : line.formulas) {
    paintHighlights(formula);
    const bool failed = !formula.picture->error().isEmpty();
    formula.picture->paint(m_painter, formula.baseline, formula.emPixels, [&](const QString &mark) {
      return failed ? toQColor(m_look.theme.warning) : inkOf(mark);
    });
  }
  if (const LineRemark *remark = m_layout.remarkOf(index))
    paintRemark(line.remark, *remark);
  m_painter.setPen(toQColor(m_look.theme.mutedInk));
  for (const auto *texts : {&line.heading, &line.sentence})
    for (const PlacedText &text : *texts)
      paintText(m_painter, text);
}

void LinesPainter::paintBackground(std::size_t index) const {
  const QRectF &box = m_layout.placed().lines[index].box;
  // The line of the traced number itself shows the number.
  const bool isSource =
      m_trace.lines.contains(idOf(index)) && m_trace.number && m_trace.number->line != idOf(index);
  if (isSource)
    m_painter.fillRect(box, translucent(m_accent, tracedLineOpacity));
  if (isSource || (m_touched.line == index && m_touched.hasFocus))
    m_painter.fillRect(QRectF(box.left(), box.top() + touchMargin, barWidth, box.height() - 2 * touchMargin),
                       m_accent);
}

template <class PaintRoom>
void LinesPainter::inRoomsOf(const std::optional<NumberPlace> &number, std::size_t index,
                             const PaintRoom &paintRoom) const {
  if (number && number->line == idOf(index))
    for (const QRectF &box : m_layout.numbers().boxesOf(*number))
      paintRoom(numberRoom(box));
}

void LinesPainter::fillWith(const QColor &color, double opacity) const {
  m_painter.setPen(Qt::NoPen);
  m_painter.setBrush(translucent(color, opacity));
}

void LinesPainter::paintNumbers(std::size_t index) const {
  inRoomsOf(m_trace.number, index, [&](const QRectF &room) {
    fillWith(m_accent, highlightOpacity);
    m_painter.drawRoundedRect(room, highlightRadius, highlightRadius);
  });
  inRoomsOf(m_touched.hovered, index, [&](const QRectF &room) {
    fillWith(m_accent, hoverOpacity);
    m_painter.drawRoundedRect(room, highlightRadius, highlightRadius);
    m_painter.fillRect(QRectF(room.left(), room.bottom() - underlineWidth, room.width(), underlineWidth),
                       m_accent);
  });
  const auto paintRing = [&](const QRectF &room) {
    m_painter.setPen(QPen(m_accent, ringWidth));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.drawRoundedRect(room, highlightRadius, highlightRadius);
  };
  inRoomsOf(m_trace.number, index, paintRing);
  if (m_touched.hasFocus)
    inRoomsOf(m_touched.chosen, index, paintRing);
}

void LinesPainter::paintHighlights(const PlacedFormula &formula) const {
  for (const auto &[mark, box] : formula.picture->markBoxes()) {
    if (!m_look.highlighted.contains(mark.toStdString()))
      continue;
    fillWith(inkOf(mark), highlightOpacity);
    m_painter.drawRoundedRect(touchedRoom(formula.toWorking(box)), highlightRadius, highlightRadius);
  }
}

void LinesPainter::paintRemark(const std::vector<PlacedText> &texts, const LineRemark &remark) const {
  if (texts.empty())
    return;
  const Theme &theme = m_look.theme;
  const double middle = m_painter.fontMetrics().capHeight() / 2.0;
  const QPointF first = texts.front().baseline;
  if (remark.isOfNow)
    paintVerdict(m_painter, first - QPointF(1.5 * remarkMarkRadius, middle), remarkMarkRadius,
                 remark.right ? Verdict::Right : Verdict::Wrong, theme);
  m_painter.setPen(toQColor(!remark.isOfNow ? theme.mutedInk
                            : remark.right  ? theme.inkOf(Subject::Triangle)
                                            : theme.warning));
  for (const PlacedText &text : texts)
    paintText(m_painter, text);
}

QColor LinesPainter::inkOf(const QString &markId) const {
  return markId.isEmpty() || !m_look.inkOf ? toQColor(m_look.theme.ink) : m_look.inkOf(markId);
}

} // namespace

void paintBlock(QPainter &painter, const QRect &part, int height, const Theme &theme) {
  painter.fillRect(part, toQColor(mix(theme.panel, theme.accent, blockTint)));
  painter.fillRect(QRectF(0, 0, barWidth, height), toQColor(mix(theme.panel, theme.accent, barTint)));
}

void paintLines(QPainter &painter, const QRect &part, const BlockLayout &layout, const WorkingLook &look,
                const ShownTrace &trace, const TouchedLines &touched) {
  painter.setRenderHint(QPainter::Antialiasing);
  const LinesPainter lines(painter, layout, look, trace, touched);
  for (std::size_t i = 0; i < layout.placed().lines.size(); ++i)
    if (layout.placed().lines[i].box.intersects(part))
      lines.paintLine(i);
}

} // namespace halfspace
