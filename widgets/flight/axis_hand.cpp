#include "widgets/flight/axis_hand.h"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfspace {
namespace {

// In units, as the lengths of the axis.
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

bool isOnHandle(const AxisLayout &layout, QPointF place) {
  const QPointF way = place - layout.handle();
  return std::abs(way.y()) <= handleReach * layout.unit() && way.x() <= snapReach * layout.unit() &&
         way.x() >= -handleLength * layout.unit();
}

bool isOnTrack(const AxisLayout &layout, QPointF place) {
  return std::abs(place.y() - layout.lineY()) <= trackReach * layout.unit();
}

/// The start, or a hit, that x is near; else t, which is there.
double snapped(const AxisLayout &layout, double t, double x) {
  const AxisScale at = layout.scale();
  double best = snapReach * layout.unit();
  double nearest = t;
  const auto consider = [&](double target) {
    const double distance = std::abs(at.xOf(target) - x);
    if (at.range.contains(target) && distance < best) {
      best = distance;
      nearest = target;
    }
  };
  consider(0);
  for (const AxisPin &pin : layout.pins())
    if (pin.isInTriangle())
      consider(pin.t);
  return nearest;
}

} // namespace

AxisHand::AxisHand(QWidget &axis, const AxisLayout &layout) : m_axis(axis), m_layout(layout) {
  axis.setMouseTracking(true);
  axis.installEventFilter(this);
}

bool AxisHand::eventFilter(QObject *watched, QEvent *event) {
  switch (event->type()) {
  case QEvent::MouseButtonPress:
  case QEvent::MouseButtonDblClick:
    return press(static_cast<const QMouseEvent &>(*event));
  case QEvent::MouseMove:
    move(static_cast<const QMouseEvent &>(*event));
    return true;
  case QEvent::MouseButtonRelease:
    release(static_cast<const QMouseEvent &>(*event));
    return true;
  case QEvent::ToolTip:
    showTip(static_cast<const QHelpEvent &>(*event));
    return true;
  case QEvent::KeyPress:
    return useKey(static_cast<const QKeyEvent &>(*event));
  case QEvent::ShortcutOverride:
    if (m_grab && static_cast<const QKeyEvent &>(*event).key() == Qt::Key_Escape)
      event->accept(); // it ends the drag, and nothing else
    break;
  case QEvent::Leave:
    hover(0);
    break;
  default:
    break;
  }
  return QObject::eventFilter(watched, event);
}

bool AxisHand::press(const QMouseEvent &event) {
  if (event.button() != Qt::LeftButton || m_layout.isHidden())
    return false;
  const QPointF place = event.pos();
  const std::vector<const AxisPin *> pins = m_layout.pinsAt(place);
  if (pins.empty() && !isOnTrack(m_layout, place))
    return true;
  m_grab = Grab{event.pos()};
  if (!pins.empty()) {
    m_grab->pin = pins.front()->crossing.number;
  } else if (isOnHandle(m_layout, place)) {
    m_grab->offset = m_layout.handle().x() - place.x();
    m_axis.setCursor(Qt::ClosedHandCursor);
  } else {
    beginScrub();
    if (isScrubbing())
      scrubTo(place.x(), event.modifiers());
  }
  return true;
}

void AxisHand::move(const QMouseEvent &event) {
  if (!m_grab)
    return pointAt(event.pos());
  const int moved = std::abs(event.pos().x() - m_grab->pressedAt.x());
  if (!m_grab->isScrubbing && m_grab->pin != 0 && moved < QApplication::startDragDistance())
    return;
  if (!m_grab->isScrubbing && moved == 0)
    return;
  const double tip = event.pos().x() + m_grab->offset;
  beginScrub();
  if (isScrubbing()) // who was told has not hidden it
    scrubTo(tip, event.modifiers());
}

void AxisHand::release(const QMouseEvent &event) {
  if (event.button() != Qt::LeftButton || !m_grab)
    return;
  const std::size_t pin = m_grab->isScrubbing ? 0 : m_grab->pin;
  endScrub(true);
  if (pin != 0)
    emit chosen(pin);
  pointAt(event.pos());
}

void AxisHand::pointAt(QPoint place) {
  const std::vector<const AxisPin *> pins = m_layout.pinsAt(place);
  const std::size_t number = pins.empty() ? 0 : pins.front()->crossing.number;
  m_axis.setCursor(number != 0                                          ? Qt::PointingHandCursor
                   : m_layout.isHidden() || !isOnTrack(m_layout, place) ? Qt::ArrowCursor
                   : isOnHandle(m_layout, place)                        ? Qt::OpenHandCursor
                                                                        : Qt::SizeHorCursor);
  hover(number);
}

void AxisHand::hover(std::size_t number) {
  if (number == m_hovered)
    return;
  setHovered(number);
  emit hovered(number);
}

void AxisHand::setHovered(std::size_t number) {
  if (std::exchange(m_hovered, number) != number)
    m_axis.update();
}

void AxisHand::beginScrub() {
  if (m_grab->isScrubbing)
    return;
  m_grab->isScrubbing = true;
  emit scrubBegun();
}

void AxisHand::scrubTo(double x, Qt::KeyboardModifiers modifiers) {
  const AxisScale at = m_layout.scale();
  const double t = std::clamp(at.tAt(x), at.range.low, at.range.high);
  emit scrubbed(modifiers & Qt::AltModifier ? t : snapped(m_layout, t, x));
}

void AxisHand::endScrub(bool keep) {
  const bool wasScrubbing = isScrubbing();
  m_grab.reset();
  emit released();
  if (wasScrubbing)
    emit scrubEnded(keep);
}

void AxisHand::moveTo(double t) {
  if (m_layout.isHidden() || m_grab || !std::isfinite(t))
    return;
  emit scrubBegun();
  emit scrubbed(t);
  emit scrubEnded(true);
}

void AxisHand::stepBy(double ticks) {
  const double step =
      std::abs(ticks) * toDouble(ticksOf(m_layout.scale(), keyTickGap * m_layout.unit()).step);
  const double steps = m_layout.elapsed() / step;
  const double slack = 1e-6; // a t that is a whole number of steps but for rounding counts as one
  moveTo((ticks > 0 ? std::floor(steps + slack) + 1 : std::ceil(steps - slack) - 1) * step);
}

void AxisHand::chooseNext(int direction) {
  const std::optional<std::size_t> pin = m_layout.chosenPin();
  const auto last = static_cast<std::ptrdiff_t>(m_layout.pins().size()) - 1;
  const std::ptrdiff_t fromEnd = direction > 0 ? 0 : last;
  const std::ptrdiff_t next = pin ? static_cast<std::ptrdiff_t>(*pin) + direction : fromEnd;
  const std::ptrdiff_t there = std::clamp(next, std::ptrdiff_t(0), last);
  emit chosen(m_layout.pins()[static_cast<std::size_t>(there)].crossing.number);
}

bool AxisHand::useKey(const QKeyEvent &event) {
  if (event.key() == Qt::Key_Escape && m_grab) {
    endScrub(false);
    return true;
  }
  if (m_layout.isHidden() || m_grab)
    return false;
  switch (event.key()) {
  case Qt::Key_Left:
    stepBy(-keyStep * factorOf(event.modifiers()));
    return true;
  case Qt::Key_Right:
    stepBy(keyStep * factorOf(event.modifiers()));
    return true;
  case Qt::Key_Home:
    moveTo(0);
    return true;
  case Qt::Key_Up:
  case Qt::Key_Down:
    if (m_layout.pins().empty())
      return false;
    chooseNext(event.key() == Qt::Key_Up ? 1 : -1);
    return true;
  default:
    return false;
  }
}

void AxisHand::showTip(const QHelpEvent &help) {
  const std::vector<const AxisPin *> pins = m_layout.pinsAt(help.pos());
  QStringList lines;
  for (const AxisPin *pin : pins)
    if (static_cast<std::size_t>(lines.size()) < mostInTip)
      lines << sentenceOf(pin->crossing, pin->standing);
  if (pins.size() > mostInTip)
    lines << tr("and %1 more").arg(pins.size() - mostInTip);
  if (pins.empty() && isOnTrack(m_layout, help.pos()) && m_layout.scale().tAt(help.pos().x()) < 0)
    lines << tr("λ < 0: behind the start");
  const QString text = lines.join('\n').toHtmlEscaped(); // lessons, and their names, come from strangers
  QToolTip::showText(help.globalPos(), text.isEmpty() ? text : "<p style='white-space:pre'>" + text + "</p>",
                     &m_axis);
}

} // namespace halfspace
