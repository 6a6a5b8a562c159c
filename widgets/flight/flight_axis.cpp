#include "widgets/flight/flight_axis.h"

#include "widgets/flight/paint_axis.h"
#include "widgets/flight/short_decimal.h"
#include "widgets/flight/spoken_axis.h"
#include "widgets/speak_by.h"

#include <QPainter>

#include <cmath>

namespace halfspace {
namespace {

// In units: sixteenths of the height of a line of words.
constexpr double usualWidth = 320;
constexpr double smallestWidth = 110;

} // namespace

FlightAxis::FlightAxis(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_letter(typesetter.picture(math::row(math::letter(U'λ')))),
      m_letterQ(typesetter.picture(math::row(math::letter('Q')))), m_theme(themes().front()) {
  speakBy<FlightAxis, SpokenAxis>();
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connectHand();
  sayChosen();
}

void FlightAxis::connectHand() {
  connect(&m_hand, &AxisHand::released, this, &FlightAxis::settle);
  connect(&m_hand, &AxisHand::scrubBegun, this, &FlightAxis::scrubBegun);
  connect(&m_hand, &AxisHand::scrubbed, this, &FlightAxis::scrubbed);
  connect(&m_hand, &AxisHand::scrubEnded, this, &FlightAxis::scrubEnded);
  connect(&m_hand, &AxisHand::chosen, this, &FlightAxis::chosen);
  connect(&m_hand, &AxisHand::hovered, this, &FlightAxis::hovered);
}

void FlightAxis::setCrossings(const Crossings &crossings) {
  const std::size_t chosenBefore = m_layout.chosen();
  m_layout.setCrossings(crossings);
  if (m_layout.chosen() != chosenBefore && hasFocus())
    sayChosen();
  settle();
}

void FlightAxis::setTime(double t, double elapsed) {
  const double before = m_layout.time();
  m_layout.setTime(t, elapsed);
  if (m_layout.time() != before) {
    QAccessibleValueChangeEvent moved(this, m_layout.time());
    QAccessible::updateAccessibility(&moved);
  }
  settle();
}

void FlightAxis::setHidden(bool hidden) {
  if (hidden == m_layout.isHidden())
    return;
  m_layout.setHidden(hidden);
  if (hidden)
    m_hand.endScrub(false);
  sayChosen();
  settle();
}

void FlightAxis::setHeld(bool held) {
  m_held = held;
  settle();
}

void FlightAxis::setTheme(const Theme &theme) {
  m_theme = theme;
  update();
}

void FlightAxis::settle() {
  m_layout.settle(!m_held && !m_hand.isPressed());
  update();
}

void FlightAxis::sayChosen() {
  const std::optional<std::size_t> pin = m_layout.chosenPin();
  const QString name = tr("The ray's parameter λ");
  const auto sentence = [&] {
    const AxisPin &chosen = m_layout.pins()[*pin];
    return sentenceOf(chosen.crossing, chosen.standing);
  };
  setAccessibleName(pin ? tr("%1: %2", "the axis and a crossing").arg(name, sentence()) : name);
}

QString FlightAxis::readout() const {
  return readoutOf(m_layout.isHidden() ? std::nullopt : shortParameter(m_layout.time()));
}

QStringList FlightAxis::spokenCrossings() const {
  QStringList sentences;
  for (const AxisPin &pin : m_layout.pins())
    sentences << sentenceOf(pin.crossing, pin.standing);
  return sentences;
}

QSize FlightAxis::sizeHint() const {
  return {qRound(usualWidth * m_layout.unit()), static_cast<int>(std::ceil(m_layout.height()))};
}

QSize FlightAxis::minimumSizeHint() const {
  return {qRound(smallestWidth * m_layout.unit()), sizeHint().height()};
}

void FlightAxis::paintEvent(QPaintEvent *) {
  QPainter painter(this);
  paintAxis(painter, {m_layout, *m_letter, *m_letterQ, m_theme, m_hand.hoveredNumber(), hasFocus()});
}

void FlightAxis::resizeEvent(QResizeEvent *event) {
  QWidget::resizeEvent(event);
  m_layout.settle(false);
}

void FlightAxis::focusInEvent(QFocusEvent *event) {
  sayChosen();
  QWidget::focusInEvent(event); // it paints the axis anew
}

void FlightAxis::changeEvent(QEvent *event) {
  if (event->type() == QEvent::FontChange) {
    m_layout.settle(false);
    updateGeometry();
  }
  QWidget::changeEvent(event);
}

} // namespace halfspace
