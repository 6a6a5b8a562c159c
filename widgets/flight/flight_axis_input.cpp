// What the pointer and the keys do on the axis.
#include "widgets/flight/flight_axis.h"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

// In units: sixteenths of the height of a line of words.
constexpr double touchRadius = 8;
constexpr double handleReach = 9; ///< above and below the line
constexpr double handleLength = 21;
constexpr double trackReach = 12;
constexpr double snapReach = 4;

/// Ticks by keys are this far apart: ten to a tick that is about so many pixels wide.
constexpr double keyTickGap = 60;
constexpr double keyStep = 0.1;
constexpr double fineFactor = 0.1;
constexpr double coarseFactor = 10;

constexpr std::size_t mostInTip = 5;

/// As for everything that is stepped: Shift a tenth, Ctrl ten steps.
double factorOf(Qt::KeyboardModifiers modifiers) {
  return modifiers & Qt::ShiftModifier ? fineFactor : modifiers & Qt::ControlModifier ? coarseFactor : 1;
}

} // namespace

std::vector<const FlightAxis::Pin *> FlightAxis::pinsAt(QPointF place) const {
  const double reach = touchRadius * unit();
  const auto isNear = [&](QPointF mark) {
    return std::hypot(mark.x() - place.x(), mark.y() - place.y()) <= reach;
  };
  for (const End end : {End::Low, End::High})
    if (isNear(placeOf(end)))
      if (std::vector<const Pin *> clipped = clippedAt(end); !clipped.empty())
        return clipped;
  std::vector<const Pin *> found;
  for (const Pin &pin : m_pins)
    if (!m_hidden && m_range.contains(pin.t) && isNear(placeOf(pin)))
      found.push_back(&pin);
  const auto distance = [&](const Pin *pin) {
    const QPointF way = placeOf(*pin) - place;
    return std::hypot(way.x(), way.y());
  };
  std::stable_sort(found.begin(), found.end(), [&](const Pin *a, const Pin *b) {
    return a->isInTriangle() != b->isInTriangle() && placeOf(*a) == placeOf(*b) ? a->isInTriangle()
                                                                                : distance(a) < distance(b);
  });
  return found;
}

bool FlightAxis::isOnHandle(QPointF place) const {
  const QPointF way = place - handle();
  return std::abs(way.y()) <= handleReach * unit() && way.x() <= snapReach * unit() &&
         way.x() >= -handleLength * unit();
}

void FlightAxis::pointAt(QPoint place) {
  const std::vector<const Pin *> pins = pinsAt(place);
  const std::size_t number = pins.empty() ? 0 : pins.front()->crossing.number;
  const bool isOnTrack = std::abs(place.y() - lineY()) <= trackReach * unit();
  setCursor(number != 0              ? Qt::PointingHandCursor
            : m_hidden || !isOnTrack ? Qt::ArrowCursor
            : isOnHandle(place)      ? Qt::OpenHandCursor
                                     : Qt::SizeHorCursor);
  if (number == m_hovered)
    return;
  setHovered(number);
  emit hovered(number);
}

void FlightAxis::mousePressEvent(QMouseEvent *event) {
  if (event->button() != Qt::LeftButton || m_hidden)
    return QWidget::mousePressEvent(event);
  const QPointF place = event->pos();
  const std::vector<const Pin *> pins = pinsAt(place);
  const bool isOnTrack = std::abs(place.y() - lineY()) <= trackReach * unit();
  if (pins.empty() && !isOnTrack)
    return;
  m_grab = Grab{event->pos()};
  if (!pins.empty()) {
    m_grab->pin = pins.front()->crossing.number;
  } else if (isOnHandle(place)) {
    m_grab->offset = handle().x() - place.x();
    setCursor(Qt::ClosedHandCursor);
  } else {
    beginScrub();
    if (isScrubbing())
      scrubTo(place.x(), event->modifiers());
  }
}

void FlightAxis::mouseMoveEvent(QMouseEvent *event) {
  if (!m_grab)
    return pointAt(event->pos());
  const int moved = std::abs(event->pos().x() - m_grab->pressedAt.x());
  if (!m_grab->isScrubbing && m_grab->pin != 0 && moved < QApplication::startDragDistance())
    return;
  if (!m_grab->isScrubbing && moved == 0)
    return;
  const double tip = event->pos().x() + m_grab->offset;
  beginScrub();
  if (isScrubbing()) // who was told has not hidden it
    scrubTo(tip, event->modifiers());
}

void FlightAxis::mouseReleaseEvent(QMouseEvent *event) {
  if (event->button() != Qt::LeftButton || !m_grab)
    return;
  const std::size_t pin = m_grab->isScrubbing ? 0 : m_grab->pin;
  endScrub(true);
  if (pin != 0)
    emit chosen(pin);
  pointAt(event->pos());
}

void FlightAxis::leaveEvent(QEvent *event) {
  if (std::exchange(m_hovered, 0) != 0) {
    update();
    emit hovered(0);
  }
  QWidget::leaveEvent(event);
}

void FlightAxis::beginScrub() {
  if (m_grab->isScrubbing)
    return;
  m_grab->isScrubbing = true;
  emit scrubBegun();
}

void FlightAxis::scrubTo(double x, Qt::KeyboardModifiers modifiers) {
  const double t = std::clamp(scale().tAt(x), m_range.low, m_range.high);
  emit scrubbed(modifiers & Qt::AltModifier ? t : snapped(t, x));
}

void FlightAxis::endScrub(bool keep) {
  const bool wasScrubbing = isScrubbing();
  m_grab.reset();
  settleRange();
  update();
  if (wasScrubbing)
    emit scrubEnded(keep);
}

double FlightAxis::snapped(double t, double x) const {
  const AxisScale at = scale();
  double best = snapReach * unit();
  double nearest = t;
  const auto consider = [&](double target) {
    const double distance = std::abs(at.xOf(target) - x);
    if (m_range.contains(target) && distance < best) {
      best = distance;
      nearest = target;
    }
  };
  consider(0);
  for (const Pin &pin : m_pins)
    if (pin.isInTriangle())
      consider(pin.t);
  return nearest;
}

void FlightAxis::stepBy(double ticks) {
  const double step = std::abs(ticks) * toDouble(ticksOf(scale(), keyTickGap * unit()).step);
  const double steps = m_elapsed / step;
  const double slack = 1e-6; // a t that is a whole number of steps but for rounding counts as one
  moveTo((ticks > 0 ? std::floor(steps + slack) + 1 : std::ceil(steps - slack) - 1) * step);
}

void FlightAxis::chooseNext(int direction) {
  const std::optional<std::size_t> pin = chosenPin();
  const auto last = static_cast<std::ptrdiff_t>(m_pins.size()) - 1;
  const std::ptrdiff_t fromEnd = direction > 0 ? 0 : last;
  const std::ptrdiff_t next = pin ? static_cast<std::ptrdiff_t>(*pin) + direction : fromEnd;
  const std::ptrdiff_t there = std::clamp(next, std::ptrdiff_t(0), last);
  emit chosen(m_pins[static_cast<std::size_t>(there)].crossing.number);
}

void FlightAxis::moveTo(double t) {
  if (m_hidden || m_grab || !std::isfinite(t))
    return;
  emit scrubBegun();
  emit scrubbed(t);
  emit scrubEnded(true);
}

void FlightAxis::keyPressEvent(QKeyEvent *event) {
  if (event->key() == Qt::Key_Escape && m_grab)
    return endScrub(false);
  if (m_hidden || m_grab)
    return QWidget::keyPressEvent(event);
  switch (event->key()) {
  case Qt::Key_Left:
    return stepBy(-keyStep * factorOf(event->modifiers()));
  case Qt::Key_Right:
    return stepBy(keyStep * factorOf(event->modifiers()));
  case Qt::Key_Home:
    return moveTo(0);
  case Qt::Key_Up:
  case Qt::Key_Down:
    if (!m_pins.empty())
      return chooseNext(event->key() == Qt::Key_Up ? 1 : -1);
    [[fallthrough]];
  default:
    QWidget::keyPressEvent(event);
  }
}

void FlightAxis::focusInEvent(QFocusEvent *event) {
  sayChosen();
  update();
  QWidget::focusInEvent(event);
}

void FlightAxis::focusOutEvent(QFocusEvent *event) {
  update();
  QWidget::focusOutEvent(event);
}

void FlightAxis::resizeEvent(QResizeEvent *event) {
  QWidget::resizeEvent(event);
  stackPins();
}

void FlightAxis::changeEvent(QEvent *event) {
  if (event->type() == QEvent::FontChange) {
    stackPins();
    updateGeometry();
  }
  QWidget::changeEvent(event);
}

bool FlightAxis::event(QEvent *event) {
  if (event->type() == QEvent::ShortcutOverride && m_grab &&
      static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape)
    event->accept(); // it ends the drag, and nothing else
  if (event->type() != QEvent::ToolTip)
    return QWidget::event(event);
  showTip(*static_cast<QHelpEvent *>(event));
  return true;
}

void FlightAxis::showTip(const QHelpEvent &help) {
  const std::vector<const Pin *> pins = pinsAt(help.pos());
  QStringList lines;
  for (const Pin *pin : pins)
    if (static_cast<std::size_t>(lines.size()) < mostInTip)
      lines << sentenceOf(pin->crossing, pin->standing);
  if (pins.size() > mostInTip)
    lines << tr("and %1 more").arg(pins.size() - mostInTip);
  const bool isOnTrack = std::abs(help.pos().y() - lineY()) <= trackReach * unit();
  if (pins.empty() && isOnTrack && scale().tAt(help.pos().x()) < 0)
    lines << tr("λ < 0: behind the start");
  const QString text = lines.join('\n').toHtmlEscaped(); // lessons, and their names, come from strangers
  QToolTip::showText(help.globalPos(), text.isEmpty() ? text : "<p style='white-space:pre'>" + text + "</p>",
                     this);
}

} // namespace halfspace
