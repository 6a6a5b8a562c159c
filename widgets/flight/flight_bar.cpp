#include "widgets/flight/flight_bar.h"

#include "lessons/lesson/lesson.h"
#include "widgets/colors.h"
#include "widgets/flow_layout.h"
#include "widgets/formula/term_formula.h"

#include <QActionGroup>
#include <QEvent>
#include <QMenu>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <array>

namespace halfspace {
namespace {

constexpr std::array<double, 4> speeds{0.25, 0.5, 1, 2};
constexpr int usualGap = 4;

QString nameOfSpeed(double speed) {
  const QString number = speed == 0.25  ? QStringLiteral("¼")
                         : speed == 0.5 ? QStringLiteral("½")
                                        : QString::number(speed);
  return number + QStringLiteral("×");
}

/// The wheel above it turns the page.
class SeedField : public QSpinBox {
public:
  using QSpinBox::QSpinBox;

protected:
  void wheelEvent(QWheelEvent *event) override { event->ignore(); }
};

math::Row formulaOfTime(const math::Row &value, char32_t relation) {
  return math::row(math::letter(U'λ'), math::symbol(relation, math::AtomClass::Rel), value);
}

} // namespace

FlightBar::FlightBar(const Typesetter &typesetter, QWidget *parent)
    : QWidget(parent), m_typesetter(typesetter), m_readout(new MathLabel(typesetter)),
      m_axis(new FlightAxis(typesetter)), m_theme(themes().front()) {
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(usualGap);
  auto *controls = new FlowLayout;
  controls->setSpacing(usualGap);
  layout->addLayout(controls);
  makeButtons();
  makeSeed();
  for (QToolButton *button : m_buttons)
    controls->addWidget(button);
  controls->addWidget(m_seed);
  controls->addWidget(m_readout);
  layout->addWidget(m_axis);
  setSizes();
  setTheme(m_theme);
}

void FlightBar::makeButtons() {
  for (const char *name : {"fire", "stepBack", "play", "stepForward", "automatic", "speed"}) {
    auto *made = new QToolButton;
    made->setObjectName(name);
    made->setFocusPolicy(Qt::StrongFocus);
    made->setAutoRaise(!m_buttons.isEmpty()); // the first is the one to begin with
    m_buttons << made;
  }
  button(FlightControl::Fire).setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button(FlightControl::Fire).setText(tr("Fire"));
  button(FlightControl::Automatic).setCheckable(true);
  makeSpeeds();
  const auto when = [this](FlightControl control, auto slot) {
    connect(&button(control), &QToolButton::clicked, this, slot);
  };
  when(FlightControl::Fire, [this] { emit fire(); });
  when(FlightControl::StepBack, [this] { emit stepped(-1); });
  when(FlightControl::StepForward, [this] { emit stepped(1); });
  when(FlightControl::Play, [this] { emit playToggled(!m_state.isPlaying); });
  when(FlightControl::Automatic, [this](bool on) {
    button(FlightControl::Automatic).setChecked(m_state.isAutomatic); // until it is told
    emit automaticToggled(on);
  });
}

void FlightBar::makeSpeeds() {
  QToolButton &speed = button(FlightControl::Speed);
  auto *menu = new QMenu(&speed);
  auto *group = new QActionGroup(menu);
  for (const double each : speeds) {
    QAction *action = menu->addAction(nameOfSpeed(each));
    action->setCheckable(true);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, each] {
      showControls(); // until it is told
      emit speedChanged(each);
    });
    m_speeds << action;
  }
  speed.setMenu(menu);
  speed.setPopupMode(QToolButton::InstantPopup);
  speed.setToolButtonStyle(Qt::ToolButtonTextOnly);
  speed.setStyleSheet("QToolButton { padding-right: 1em; }"); // for the menu's arrow
}

void FlightBar::makeSeed() {
  m_seed = new SeedField;
  m_seed->setObjectName("seed");
  m_seed->setRange(1, largestSeed);
  m_seed->setPrefix(tr("seed "));
  m_seed->setKeyboardTracking(false);
  m_seed->setButtonSymbols(QAbstractSpinBox::NoButtons);
  m_seed->setAccessibleName(tr("Seed"));
  m_seed->setToolTip(tr("The same seed fires the same shots"));
  m_seed->setFocusPolicy(Qt::StrongFocus);
  connect(m_seed, qOverload<int>(&QSpinBox::valueChanged), this, &FlightBar::seedChanged);
  connect(m_seed, &QSpinBox::editingFinished, m_seed, &QWidget::clearFocus); // keys fire again
}

QToolButton &FlightBar::button(FlightControl control) const {
  return *m_buttons.at(static_cast<int>(control));
}

void FlightBar::setState(const FlightState &state) {
  FlightState before = std::exchange(m_state, state);
  before.t = state.t;
  before.elapsed = state.elapsed;
  if (before != state) // in flight nothing but these is new
    showControls();
  showTime();
}

void FlightBar::setKeys(FlightControl control, const QKeySequence &keys) {
  m_keys[control] = keys;
  showControls();
}

void FlightBar::setTheme(const Theme &theme) {
  m_theme = theme;
  m_axis->setTheme(theme);
  m_readout->setInkOf([ink = toQColor(theme.ink)](const QString &) { return ink; });
  button(FlightControl::Fire).setIcon(iconOf(FlightIcon::Fire, toQColor(theme.inkOf(Subject::Point))));
  for (const auto &[control, icon] : {std::pair{FlightControl::StepBack, FlightIcon::StepBack},
                                      {FlightControl::StepForward, FlightIcon::StepForward},
                                      {FlightControl::Automatic, FlightIcon::Automatic}})
    button(control).setIcon(iconOf(icon, toQColor(theme.ink)));
  m_play = iconOf(FlightIcon::Play, toQColor(theme.ink));
  m_pause = iconOf(FlightIcon::Pause, toQColor(theme.ink));
  showControls();
  showTime();
}

void FlightBar::describe(FlightControl control, const QString &words) {
  QToolButton &described = button(control);
  described.setAccessibleName(words);
  const QString keys = m_keys[control].toString(QKeySequence::NativeText);
  described.setToolTip(keys.isEmpty() ? words : tr("%1 (%2)", "a control and its key").arg(words, keys));
}

void FlightBar::showControls() {
  const bool canMove = !m_state.hidden;
  button(FlightControl::Fire).setEnabled(canMove && m_state.canFire);
  button(FlightControl::Automatic).setEnabled(canMove && m_state.canFire);
  button(FlightControl::StepBack).setEnabled(canMove);
  button(FlightControl::StepForward).setEnabled(canMove);
  button(FlightControl::Play).setEnabled(canMove && !m_state.reducedMotion);
  button(FlightControl::Automatic).setChecked(m_state.isAutomatic);
  {
    const QSignalBlocker told(m_seed); // it asks for nothing
    m_seed->setValue(m_state.seed);
  }
  m_seed->setVisible(m_state.isAutomatic);
  m_seed->setEnabled(canMove);
  button(FlightControl::Speed).setEnabled(!m_state.reducedMotion);
  button(FlightControl::Speed).setText(nameOfSpeed(m_state.speed));
  for (int i = 0; i < m_speeds.size(); ++i)
    m_speeds[i]->setChecked(speeds.at(static_cast<std::size_t>(i)) == m_state.speed);
  describe(FlightControl::Fire, tr("Fire the torpedo"));
  describe(FlightControl::StepBack, tr("One frame back"));
  describe(FlightControl::StepForward, tr("One frame on"));
  describe(FlightControl::Play, m_state.reducedMotion ? tr("Motion is switched off")
                                : m_state.isPlaying   ? tr("Pause")
                                                      : tr("Play"));
  describe(FlightControl::Automatic, tr("Fire by itself, again and again, in random directions"));
  describe(FlightControl::Speed, tr("Speed: %1").arg(nameOfSpeed(m_state.speed)));
  button(FlightControl::Play).setIcon(m_state.isPlaying ? m_pause : m_play);
  m_axis->setHidden(m_state.hidden);
}

std::optional<WrittenNumber> FlightBar::parameter() const {
  return m_state.hidden ? std::nullopt : shortParameter(m_state.t);
}

QString FlightBar::readout() const { return readoutOf(parameter()); }

void FlightBar::showTime() {
  m_axis->setTime(m_state.t, m_state.elapsed);
  const std::optional<WrittenNumber> value = parameter();
  if (!value)
    return m_readout->setFormula(formulaOfTime(math::row(math::symbol('?')), '='), readoutOf(value));
  m_readout->setFormula(formulaOfTime(formulaOf(value->term), value->exact ? U'=' : U'≈'), readoutOf(value));
  if (const int needed = m_readout->sizeHint().width(); needed > m_readout->width())
    m_readout->setFixedWidth(needed);
}

void FlightBar::setSizes() {
  const int side = fontMetrics().height();
  for (QToolButton *each : m_buttons)
    each->setIconSize({side, side});
  m_seed->setMaximumWidth(fontMetrics().horizontalAdvance(m_seed->prefix() + "888") + side / 2);
  // As wide as it usually becomes: it does not move while the torpedo flies.
  MathLabel usual(m_typesetter);
  usual.setFont(font());
  usual.setFormula(formulaOfTime(math::row(math::number("8.888")), U'≈'), {});
  m_readout->setFixedSize(usual.sizeHint().width(), button(FlightControl::StepBack).sizeHint().height());
}

void FlightBar::changeEvent(QEvent *event) {
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
    setSizes();
  QWidget::changeEvent(event);
}

} // namespace halfspace
