#include "widgets/explore/number_slider.h"

#include "lessons/object/kinds/number.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <algorithm>

namespace halfspace {
namespace {

constexpr int millisecondsPerStep = 80;
/// No slider has more places: where a number has more steps, several lie in one.
constexpr int mostPlaces = 1000;

/// From one place of the slider to the next: as few steps as there are places for.
Rational placeWidth(const NumberObject &number) {
  const Rational range = number.to - number.from;
  if (number.step <= 0)
    return range / mostPlaces;
  const Rational stepsInPlace = roundUpToMultiple(Rational(range / (number.step * mostPlaces)), 1);
  return number.step * std::max(stepsInPlace, Rational(1));
}

/// The last one is at the upper bound, and may be nearer to the one before.
int placesOf(const NumberObject &number) {
  const Rational width = placeWidth(number);
  return width > 0
             ? static_cast<int>(toDouble(roundUpToMultiple(Rational((number.to - number.from) / width), 1)))
             : 0;
}

} // namespace

NumberSlider::NumberSlider(SessionModel &model, QWidget *parent)
    : QWidget(parent), m_model(model), m_slider(new QSlider(Qt::Horizontal)), m_play(new QToolButton) {
  m_slider->setObjectName("numberSlider");
  m_play->setObjectName("playNumber");
  m_play->setCheckable(true);
  m_play->setText(tr("Play"));
  auto *row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_slider, 1);
  row->addWidget(m_play);
  m_clock.setInterval(millisecondsPerStep);
  connect(m_slider, &QSlider::sliderPressed, this, &NumberSlider::begin);
  connect(m_slider, &QSlider::sliderReleased, this, &NumberSlider::end);
  connect(m_slider, &QSlider::valueChanged, this, &NumberSlider::moveTo);
  connect(m_play, &QToolButton::toggled, this, &NumberSlider::play);
  connect(&m_clock, &QTimer::timeout, this, &NumberSlider::step);
  connect(&model, &SessionModel::outcomeChanged, this, &NumberSlider::showNumber);
  connect(&model.history(), &SessionHistory::gestureSettled, m_play, [this] { m_play->setChecked(false); });
  hide();
}

void NumberSlider::setNumber(const std::string &name) {
  if (name != m_name)
    m_play->setChecked(false);
  m_name = name;
  showNumber();
}

std::optional<NumberObject> NumberSlider::number() const {
  const Object *object = findObject(m_model.session().scene, m_name);
  return object ? objectAs<NumberObject>(*object) : std::nullopt;
}

void NumberSlider::showNumber() {
  const auto shown = number();
  setVisible(shown && shown->from < shown->to);
  if (!shown)
    return;
  const QSignalBlocker still(m_slider);
  m_slider->setRange(0, placesOf(*shown));
  if (placesOf(*shown) > 0)
    m_slider->setValue(
        static_cast<int>(toDouble(Rational((shown->value - shown->from) / placeWidth(*shown))) + 0.5));
  m_slider->setAccessibleName(tr("The number %1").arg(QString::fromStdString(m_name)));
}

void NumberSlider::begin() {
  m_gesture = m_model.history().beginGesture(tr("Change %1").arg(QString::fromStdString(m_name)));
}

void NumberSlider::end() {
  m_model.history().endGesture(m_gesture);
  m_gesture = GestureToken::Nobodys;
}

void NumberSlider::moveTo(int step) {
  auto moved = number();
  if (!moved)
    return;
  moved->value = std::min(Rational(moved->from + placeWidth(*moved) * step), moved->to);
  const ChangeObject change{m_name, *moved};
  if (m_model.history().isHeldBy(m_gesture))
    m_model.history().moveGesture(m_gesture, change);
  else // a key
    m_model.history().edit(change, tr("Change %1").arg(QString::fromStdString(m_name)));
}

void NumberSlider::play(bool on) {
  m_play->setText(on ? tr("Stop") : tr("Play"));
  if (on) {
    begin();
    m_clock.start();
  } else {
    m_clock.stop();
    end();
  }
}

void NumberSlider::step() {
  const int next = m_slider->value() + m_direction;
  if (next < m_slider->minimum() || next > m_slider->maximum())
    m_direction = -m_direction;
  m_slider->setValue(m_slider->value() + m_direction);
}

} // namespace halfspace
