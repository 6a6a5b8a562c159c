#include "widgets/flight/flight_axis.h"

#include "lessons/term/plain_text.h"
#include "widgets/colors.h"
#include "widgets/flight/flight_icons.h"
#include "widgets/flight/short_decimal.h"
#include "widgets/flight/spoken_axis.h"
#include "widgets/speak_by.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

// In units: sixteenths of the height of a line of words.
constexpr double edgeTop = 2;
constexpr double markRadius = 4.2;
constexpr double levelGap = 13; ///< between the marks of usual stacks
constexpr int usualLevels = 3;
constexpr int mostLevels = 8;
constexpr double closest = 10; ///< marks nearer to each other than this are stacked
constexpr double torpedoLength = 19;
constexpr double markHeight = 17; ///< of the lowest mark above the line: the torpedo passes below
constexpr double torpedoReach = 8;
constexpr double tickLength = 4;
constexpr double numbersBelow = 8;
constexpr double numberSize = 0.86; ///< of the ticks' numbers, in that of words
constexpr double leftRoom = 22;     ///< for a torpedo at the low end
constexpr double rightRoom = 22;    ///< for the arrow and its letter
constexpr double arrowLength = 7;
constexpr double tickGap = 28; ///< between the numbers of two ticks
constexpr double lineWidth = 1.4;
constexpr double flownWidth = 3.2;
constexpr double usualWidth = 320;
constexpr double smallestWidth = 110;
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

} // namespace

bool FlightAxis::Pin::isInTriangle() const {
  return standing != Standing::Outside && standing != Standing::NotAsked;
}

FlightAxis::FlightAxis(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_letter(typesetter.picture(math::row(math::letter(U'λ')))),
      m_letterQ(typesetter.picture(math::row(math::letter('Q')))), m_theme(themes().front()) {
  speakBy<FlightAxis, SpokenAxis>();
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  sayChosen();
}

void FlightAxis::setCrossings(const Crossings &crossings) {
  const bool isOtherChosen = std::exchange(m_chosen, crossings.chosen) != m_chosen;
  m_pins.clear();
  for (const Crossing &crossing : crossings.all)
    if (const Standing standing = standingOf(crossing, crossings);
        crossing.at && standing != Standing::NotAsked)
      m_pins.push_back({crossing, standing, toDouble(crossing.at->t)});
  // Of those at the same place a hit stands lowest.
  std::stable_sort(m_pins.begin(), m_pins.end(), [](const Pin &a, const Pin &b) {
    return a.t != b.t ? a.t < b.t : a.isInTriangle() && !b.isInTriangle();
  });
  if (isOtherChosen && hasFocus())
    sayChosen();
  settleRange();
  update();
}

std::optional<std::size_t> FlightAxis::chosenPin() const {
  for (std::size_t i = 0; i < m_pins.size(); ++i)
    if (m_pins[i].crossing.number == m_chosen)
      return i;
  return {};
}

void FlightAxis::sayChosen() {
  const std::optional<std::size_t> pin = m_hidden ? std::nullopt : chosenPin();
  const QString name = tr("The ray's parameter λ");
  setAccessibleName(pin ? tr("%1: %2", "the axis and a crossing")
                              .arg(name, sentenceOf(m_pins[*pin].crossing, m_pins[*pin].standing))
                        : name);
}

QString FlightAxis::readout() const { return readoutOf(m_hidden ? std::nullopt : shortParameter(m_t)); }

QStringList FlightAxis::spokenCrossings() const {
  QStringList sentences;
  for (const Pin &pin : m_pins)
    if (!m_hidden)
      sentences << sentenceOf(pin.crossing, pin.standing);
  return sentences;
}

void FlightAxis::setTime(double t, double elapsed) {
  const double before = std::exchange(m_t, std::isfinite(t) ? t : 0);
  m_elapsed = std::isfinite(elapsed) ? elapsed : 0;
  if (m_t != before) {
    QAccessibleValueChangeEvent moved(this, time());
    QAccessible::updateAccessibility(&moved);
  }
  settleRange();
  update();
}

void FlightAxis::setHidden(bool hidden) {
  if (std::exchange(m_hidden, hidden) == hidden)
    return;
  if (hidden)
    endScrub(false);
  sayChosen();
  settleRange();
  update();
}

void FlightAxis::setHovered(std::size_t number) {
  if (std::exchange(m_hovered, number) != number)
    update();
}

void FlightAxis::setHeld(bool held) {
  m_held = held;
  settleRange();
  update();
}

void FlightAxis::setTheme(const Theme &theme) {
  m_theme = theme;
  update();
}

void FlightAxis::settleRange() {
  if (!m_held && !m_grab) {
    std::vector<double> hits;
    for (const Pin &pin : m_pins)
      if (!m_hidden && pin.isInTriangle() && std::isfinite(pin.t))
        hits.push_back(pin.t);
    m_range = rangeFor(hits, m_hidden ? 0 : m_t);
  }
  stackPins();
}

void FlightAxis::stackPins() {
  const AxisScale at = scale();
  std::vector<double> ends; // of each level, the last mark's place
  for (Pin &pin : m_pins) {
    if (!m_range.contains(pin.t))
      continue;
    const double x = at.xOf(pin.t);
    const auto isFree = [&](double end) { return x - end >= closest * unit(); };
    auto level = std::find_if(ends.begin(), ends.end(), isFree);
    if (level == ends.end() && ends.size() < mostLevels)
      level = ends.insert(level, x);
    else if (level == ends.end())
      --level;
    *level = x;
    pin.level = static_cast<int>(level - ends.begin());
  }
  m_levels = static_cast<int>(ends.size());
}

double FlightAxis::unit() const { return QFontMetricsF(font()).height() / 16; }

AxisScale FlightAxis::scale() const {
  return {m_range, leftRoom * unit(), std::max(width() - rightRoom * unit(), (leftRoom + 1) * unit())};
}

double FlightAxis::lineY() const {
  const double top = edgeTop + ringRadius * markRadius + (usualLevels - 1) * levelGap + markHeight;
  return std::floor(top * unit());
}

QPointF FlightAxis::placeOf(const Pin &pin) const {
  const double gap = m_levels <= usualLevels ? levelGap : (usualLevels - 1) * levelGap / (m_levels - 1);
  return {scale().xOf(pin.t), lineY() - (markHeight + pin.level * gap) * unit()};
}

QPointF FlightAxis::placeOf(End end) const {
  const AxisScale at = scale();
  const double x = end == End::Low ? at.left - leftRoom * unit() / 2 : at.right + rightRoom * unit() / 2;
  return {x, lineY() - markHeight * unit()};
}

std::optional<QPointF> FlightAxis::placeOf(std::size_t number) const {
  for (const Pin &pin : m_pins)
    if (!m_hidden && pin.crossing.number == number)
      return m_range.contains(pin.t) ? placeOf(pin) : placeOf(pin.t < m_range.low ? End::Low : End::High);
  return {};
}

QPointF FlightAxis::handle() const {
  return {scale().xOf(std::clamp(time(), m_range.low, m_range.high)), lineY()};
}

QSize FlightAxis::sizeHint() const {
  const double height =
      lineY() + numbersBelow * unit() + std::max(QFontMetricsF(font()).height(), torpedoReach * unit());
  return {qRound(usualWidth * unit()), static_cast<int>(std::ceil(height))};
}

QSize FlightAxis::minimumSizeHint() const { return {qRound(smallestWidth * unit()), sizeHint().height()}; }

void FlightAxis::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintLine(painter);
  paintTicks(painter);
  if (!m_hidden) {
    // What matters most comes last: it is never covered.
    for (const bool hits : {false, true})
      for (auto pin = m_pins.rbegin(); pin != m_pins.rend(); ++pin)
        if (m_range.contains(pin->t) && pin->isInTriangle() == hits)
          paintPin(painter, *pin);
    for (const End end : {End::Low, End::High})
      paintEnd(painter, end);
  }
  paintHandle(painter);
}

void FlightAxis::paintLine(QPainter &painter) const {
  const AxisScale at = scale();
  const double y = lineY() + 0.5;
  const double start = at.xOf(std::clamp(0.0, m_range.low, m_range.high));
  const QColor ink = toQColor(m_theme.axis);
  QPen behind(toQColor(mix(m_theme.panel, m_theme.axis, behindStrength)), lineWidth * unit());
  behind.setDashPattern({3, 3});
  behind.setCapStyle(Qt::FlatCap);
  painter.setPen(behind);
  painter.drawLine(QPointF(start, y), QPointF(at.left - leftRoom * unit() / 2, y));
  painter.setPen(QPen(ink, lineWidth * unit()));
  const double tip = at.right + rightRoom * unit() * 0.45;
  painter.drawLine(QPointF(start, y), QPointF(tip - arrowLength * unit() / 2, y));
  QPainterPath arrow(QPointF(tip, y));
  arrow.lineTo(tip - arrowLength * unit(), y - arrowLength * unit() * 0.42);
  arrow.lineTo(tip - arrowLength * unit(), y + arrowLength * unit() * 0.42);
  painter.fillPath(arrow, ink);
  if (handle().x() > start) {
    painter.setPen(
        QPen(toQColor(m_theme.colorOf(Subject::Ray)), flownWidth * unit(), Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(start, y), QPointF(handle().x(), y));
  }
}

void FlightAxis::paintLetter(QPainter &painter, const MathPicture &picture, QPointF topMiddle,
                             Color ink) const {
  const double em = QFontMetricsF(font()).height() * typeSize;
  const QFontMetricsF numbers(smaller(font()));
  const QPointF baseline(topMiddle.x() - picture.width() * em / 2, topMiddle.y() + numbers.ascent());
  picture.paint(painter, baseline, em, [color = toQColor(ink)](const QString &) { return color; });
}

void FlightAxis::paintTicks(QPainter &painter) const {
  const AxisScale at = scale();
  const QFont numbers = smaller(font());
  const QFontMetricsF metrics(numbers);
  const double y = lineY() + 0.5;
  const double below = y + numbersBelow * unit();
  painter.setFont(numbers);
  for (const Rational &tick : readableTicks(at, metrics, tickGap * unit()).at) {
    const double x = at.xOf(toDouble(tick));
    const bool isBehind = tick.sign() < 0;
    painter.setPen(
        QPen(toQColor(isBehind ? mix(m_theme.panel, m_theme.axis, behindStrength) : m_theme.axis), unit()));
    painter.drawLine(QPointF(x, y), QPointF(x, y + tickLength * unit()));
    if (tick == 0)
      continue;
    painter.setPen(toQColor(m_theme.mutedInk));
    const double width = metrics.horizontalAdvance(textOf(tick));
    painter.drawText(QPointF(x - width / 2, below + metrics.ascent()), textOf(tick));
  }
  if (m_range.contains(0))
    paintLetter(painter, *m_letterQ, {at.xOf(0), below}, m_theme.inkOf(Subject::Point));
  paintLetter(painter, *m_letter, {at.right + rightRoom * unit() * 0.6, below}, m_theme.ink);
}

void FlightAxis::paintPin(QPainter &painter, const Pin &pin) const {
  const QPointF place = placeOf(pin);
  const Color ink = inkOf(pin.standing, pin.t < 0, m_theme);
  painter.setPen(QPen(toQColor(mix(m_theme.panel, ink, pin.isInTriangle() ? 1 : stemStrength)), unit()));
  painter.drawLine(place + QPointF(0, markRadius * unit()), QPointF(place.x(), lineY()));
  const bool isChosen = pin.crossing.number == m_chosen;
  if (isChosen || pin.crossing.number == m_hovered) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(toQColor(mix(m_theme.panel, m_theme.accent, isChosen ? 0.4 : 0.22)));
    const double halo = (ringRadius + 0.35) * markRadius * unit();
    painter.drawEllipse(place, halo, halo);
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(toQColor(m_theme.panel)); // no stem is seen through what is hollow
  painter.drawEllipse(place, 0.8 * markRadius * unit(), 0.8 * markRadius * unit());
  paintMark(painter, place, markRadius * unit(), pin.standing, toQColor(ink));
}

std::vector<const FlightAxis::Pin *> FlightAxis::clippedAt(End end) const {
  std::vector<const Pin *> clipped;
  for (const Pin &pin : m_pins)
    if (!m_hidden && (end == End::Low ? pin.t < m_range.low : pin.t > m_range.high))
      clipped.push_back(&pin);
  if (end == End::Low)
    std::reverse(clipped.begin(), clipped.end()); // the nearest to the axis first
  return clipped;
}

void FlightAxis::paintEnd(QPainter &painter, End end) const {
  const std::vector<const Pin *> clipped = clippedAt(end);
  if (clipped.empty())
    return;
  const auto hit =
      std::find_if(clipped.begin(), clipped.end(), [](const Pin *pin) { return pin->isInTriangle(); });
  const Pin &shown = hit == clipped.end() ? *clipped.front() : **hit;
  const double reach = markRadius * unit();
  const double forward = end == End::Low ? -reach : reach;
  const QPointF place = placeOf(end);
  painter.setPen(QPen(toQColor(inkOf(shown.standing, shown.t < 0, m_theme)), 1.8 * unit(), Qt::SolidLine,
                      Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(QPolygonF({place + QPointF(-forward / 2, -reach), place + QPointF(forward / 2, 0),
                                  place + QPointF(-forward / 2, reach)}));
}

void FlightAxis::paintHandle(QPainter &painter) const {
  painter.save();
  painter.translate(handle() + QPointF(0, 0.5));
  const double length = torpedoLength * unit();
  const QPainterPath body = QTransform::fromScale(length, length).map(torpedo());
  painter.setPen(QPen(toQColor(hasFocus() ? m_theme.accent : m_theme.panel), (hasFocus() ? 4 : 2.4) * unit(),
                      Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(body);
  if (hasFocus()) {
    painter.setPen(QPen(toQColor(m_theme.panel), 1.6 * unit(), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(body);
  }
  painter.fillPath(body, toQColor(m_hidden ? m_theme.mutedInk : m_theme.colorOf(Subject::Point)));
  painter.restore();
}

} // namespace halfspace
