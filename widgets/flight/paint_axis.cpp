#include "widgets/flight/paint_axis.h"

#include "lessons/term/plain_text.h"
#include "lessons/term/written.h"
#include "widgets/colors.h"
#include "widgets/flight/flight_icons.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace halfspace {
namespace {

// In units, as the lengths of the layout.
constexpr double torpedoLength = 19;
constexpr double tickLength = 4;
constexpr double arrowLength = 7;
constexpr double tickGap = 28; ///< between the numbers of two ticks
constexpr double lineWidth = 1.4;
constexpr double flownWidth = 3.2;

constexpr double numberSize = 0.86; ///< of the ticks' numbers, in that of words
/// Formulas' type in the height of a line.
constexpr double typeSize = 0.82;
/// How much of the axis' ink is left before the start.
constexpr double behindStrength = 0.55;
constexpr double stemStrength = 0.45;

QFont smaller(QFont font) {
  if (font.pointSizeF() > 0)
    font.setPointSizeF(font.pointSizeF() * numberSize);
  else
    font.setPixelSize(qRound(font.pixelSize() * numberSize));
  return font;
}

QString textOf(const Rational &tick) { return QString::fromStdString(plainText(decimalOf(Surd(tick)).term)); }

double widestOf(const AxisTicks &ticks, const QFontMetricsF &metrics) {
  double widest = 0;
  for (const Rational &tick : ticks.at)
    widest = std::max(widest, metrics.horizontalAdvance(textOf(tick)));
  return widest;
}

/// As many ticks as their numbers have room.
AxisTicks readableTicks(const AxisScale &scale, const QFontMetricsF &metrics, double gap) {
  AxisTicks ticks = ticksOf(scale, gap + metrics.horizontalAdvance('0'));
  for (;;) {
    AxisTicks fewer = ticksOf(scale, gap + widestOf(ticks, metrics));
    if (fewer.step <= ticks.step)
      return ticks;
    ticks = std::move(fewer);
  }
}

class AxisPainter {
public:
  AxisPainter(QPainter &painter, const PaintedAxis &axis)
      : m_painter(painter), m_axis(axis), m_layout(axis.layout), m_theme(axis.theme), m_font(painter.font()),
        m_scale(axis.layout.scale()), m_unit(axis.layout.unit()) {}

  void paintLine() const;
  void paintTicks() const;
  void paintPins() const;
  void paintEnd(AxisLayout::End end) const;
  void paintTorpedo() const;

private:
  void paintPin(const AxisPin &pin) const;
  void paintLetter(const MathPicture &picture, QPointF topMiddle, Color ink) const;

  QPainter &m_painter;
  const PaintedAxis &m_axis;
  const AxisLayout &m_layout;
  const Theme &m_theme;
  QFont m_font; ///< of words
  AxisScale m_scale;
  double m_unit;
};

void AxisPainter::paintLine() const {
  const double y = m_layout.lineY() + 0.5;
  const double start = m_scale.xOf(std::clamp(0.0, m_scale.range.low, m_scale.range.high));
  const QColor ink = toQColor(m_theme.axis);
  QPen behind(toQColor(mix(m_theme.panel, m_theme.axis, behindStrength)), lineWidth * m_unit);
  behind.setDashPattern({3, 3});
  behind.setCapStyle(Qt::FlatCap);
  m_painter.setPen(behind);
  m_painter.drawLine(QPointF(start, y), QPointF(m_scale.left - axisLeftRoom * m_unit / 2, y));
  m_painter.setPen(QPen(ink, lineWidth * m_unit));
  const double tip = m_scale.right + axisRightRoom * m_unit * 0.45;
  m_painter.drawLine(QPointF(start, y), QPointF(tip - arrowLength * m_unit / 2, y));
  QPainterPath arrow(QPointF(tip, y));
  arrow.lineTo(tip - arrowLength * m_unit, y - arrowLength * m_unit * 0.42);
  arrow.lineTo(tip - arrowLength * m_unit, y + arrowLength * m_unit * 0.42);
  m_painter.fillPath(arrow, ink);
  if (m_layout.handle().x() > start) {
    m_painter.setPen(
        QPen(toQColor(m_theme.colorOf(Subject::Ray)), flownWidth * m_unit, Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(QPointF(start, y), QPointF(m_layout.handle().x(), y));
  }
}

void AxisPainter::paintLetter(const MathPicture &picture, QPointF topMiddle, Color ink) const {
  const double em = QFontMetricsF(m_font).height() * typeSize;
  const QFontMetricsF numbers(smaller(m_font));
  const QPointF baseline(topMiddle.x() - picture.width() * em / 2, topMiddle.y() + numbers.ascent());
  picture.paint(m_painter, baseline, em, [color = toQColor(ink)](const QString &) { return color; });
}

void AxisPainter::paintTicks() const {
  const QFont numbers = smaller(m_font);
  const QFontMetricsF metrics(numbers);
  const double y = m_layout.lineY() + 0.5;
  const double below = y + axisNumbersBelow * m_unit;
  m_painter.setFont(numbers);
  for (const Rational &tick : readableTicks(m_scale, metrics, tickGap * m_unit).at) {
    const double x = m_scale.xOf(toDouble(tick));
    const bool isBehind = tick.sign() < 0;
    m_painter.setPen(
        QPen(toQColor(isBehind ? mix(m_theme.panel, m_theme.axis, behindStrength) : m_theme.axis), m_unit));
    m_painter.drawLine(QPointF(x, y), QPointF(x, y + tickLength * m_unit));
    if (tick == 0)
      continue;
    m_painter.setPen(toQColor(m_theme.mutedInk));
    const double width = metrics.horizontalAdvance(textOf(tick));
    m_painter.drawText(QPointF(x - width / 2, below + metrics.ascent()), textOf(tick));
  }
  if (m_scale.range.contains(0))
    paintLetter(m_axis.start, {m_scale.xOf(0), below}, m_theme.inkOf(Subject::Point));
  paintLetter(m_axis.parameter, {m_scale.right + axisRightRoom * m_unit * 0.6, below}, m_theme.ink);
}

void AxisPainter::paintPins() const {
  const std::vector<AxisPin> &pins = m_layout.pins();
  // What matters most comes last: it is never covered.
  for (const bool hits : {false, true})
    for (auto pin = pins.rbegin(); pin != pins.rend(); ++pin)
      if (m_scale.range.contains(pin->t) && pin->isInTriangle() == hits)
        paintPin(*pin);
}

void AxisPainter::paintPin(const AxisPin &pin) const {
  const double radius = axisMarkRadius * m_unit;
  const QPointF place = m_layout.placeOf(pin);
  const Color ink = inkOf(pin.standing, pin.t < 0, m_theme);
  m_painter.setPen(QPen(toQColor(mix(m_theme.panel, ink, pin.isInTriangle() ? 1 : stemStrength)), m_unit));
  m_painter.drawLine(place + QPointF(0, radius), QPointF(place.x(), m_layout.lineY()));
  const bool isChosen = pin.crossing.number == m_layout.chosen();
  if (isChosen || pin.crossing.number == m_axis.hovered) {
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(toQColor(mix(m_theme.panel, m_theme.accent, isChosen ? 0.4 : 0.22)));
    const double halo = (ringRadius + 0.35) * axisMarkRadius * m_unit;
    m_painter.drawEllipse(place, halo, halo);
  }
  m_painter.setPen(Qt::NoPen);
  m_painter.setBrush(toQColor(m_theme.panel)); // no stem is seen through what is hollow
  m_painter.drawEllipse(place, 0.8 * axisMarkRadius * m_unit, 0.8 * axisMarkRadius * m_unit);
  paintMark(m_painter, place, radius, pin.standing, toQColor(ink));
}

void AxisPainter::paintEnd(AxisLayout::End end) const {
  const std::vector<const AxisPin *> clipped = m_layout.clippedAt(end);
  if (clipped.empty())
    return;
  const auto hit =
      std::find_if(clipped.begin(), clipped.end(), [](const AxisPin *pin) { return pin->isInTriangle(); });
  const AxisPin &shown = hit == clipped.end() ? *clipped.front() : **hit;
  const double reach = axisMarkRadius * m_unit;
  const double forward = end == AxisLayout::End::Low ? -reach : reach;
  const QPointF place = m_layout.placeOf(end);
  m_painter.setPen(QPen(toQColor(inkOf(shown.standing, shown.t < 0, m_theme)), 1.8 * m_unit, Qt::SolidLine,
                        Qt::RoundCap, Qt::RoundJoin));
  m_painter.setBrush(Qt::NoBrush);
  m_painter.drawPolyline(QPolygonF({place + QPointF(-forward / 2, -reach), place + QPointF(forward / 2, 0),
                                    place + QPointF(-forward / 2, reach)}));
}

void AxisPainter::paintTorpedo() const {
  m_painter.save();
  m_painter.translate(m_layout.handle() + QPointF(0, 0.5));
  const double length = torpedoLength * m_unit;
  const QPainterPath body = QTransform::fromScale(length, length).map(torpedo());
  m_painter.setPen(QPen(toQColor(m_axis.hasFocus ? m_theme.accent : m_theme.panel),
                        (m_axis.hasFocus ? 4 : 2.4) * m_unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  m_painter.drawPath(body);
  if (m_axis.hasFocus) {
    m_painter.setPen(QPen(toQColor(m_theme.panel), 1.6 * m_unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPath(body);
  }
  m_painter.fillPath(body,
                     toQColor(m_layout.isHidden() ? m_theme.mutedInk : m_theme.colorOf(Subject::Point)));
  m_painter.restore();
}

} // namespace

void paintAxis(QPainter &painter, const PaintedAxis &axis) {
  painter.setRenderHint(QPainter::Antialiasing);
  const AxisPainter painted(painter, axis);
  painted.paintLine();
  painted.paintTicks();
  painted.paintPins();
  for (const AxisLayout::End end : {AxisLayout::End::Low, AxisLayout::End::High})
    painted.paintEnd(end);
  painted.paintTorpedo();
}

} // namespace halfspace
