#include "widgets/flight/flight_player.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// In milliseconds: as often as a display shows a new picture.
constexpr int tickInterval = 16;
/// Without motion each of the few steps is looked at for so long.
constexpr int stillInterval = 700;
/// Without motion so many frames are one step.
constexpr int framesPerStill = 10;

} // namespace

FlightPlayer::FlightPlayer(SessionModel &model, QObject *parent)
    : QObject(parent), m_model(model), m_timer(this) {
  m_timer.setTimerType(Qt::PreciseTimer);
  connect(&m_timer, &QTimer::timeout, this, &FlightPlayer::tick);
  connect(&model.history(), &SessionHistory::gestureChanged, this, [this] {
    if (!m_model.history().inGesture())
      stop();
  });
  connect(&model, &SessionModel::lessonChanged, this, [this] { m_seed.reset(); });
  connect(&model, &SessionModel::stepChanged, this, &FlightPlayer::stop);
  connect(&model, &SessionModel::stepChanged, this, &FlightPlayer::followStep, Qt::QueuedConnection);
}

void FlightPlayer::serve(FlightBar &bar) {
  if (const StepFlight *names = flightOf(m_model.step()))
    m_controlled = {m_model.session().lesson, *names};
  connect(&bar, &FlightBar::fire, this, &FlightPlayer::fire);
  connect(&bar, &FlightBar::playToggled, this, &FlightPlayer::play);
  connect(&bar, &FlightBar::stepped, this, &FlightPlayer::step);
  connect(&bar, &FlightBar::automaticToggled, this, &FlightPlayer::setAutomatic);
  connect(&bar, &FlightBar::seedChanged, this, &FlightPlayer::setSeed);
  connect(&bar, &FlightBar::speedChanged, this, &FlightPlayer::setSpeed);
  connect(&bar.axis(), &FlightAxis::scrubBegun, this, &FlightPlayer::beginScrub);
  connect(&bar.axis(), &FlightAxis::scrubbed, this, &FlightPlayer::scrub);
  connect(&bar.axis(), &FlightAxis::scrubEnded, this, &FlightPlayer::endScrub);
}

void FlightPlayer::setReducedMotion(bool reduced) {
  play(false);
  m_reducedMotion = reduced;
  emit stateChanged();
}

std::optional<SceneFlight> FlightPlayer::flight() const {
  const StepFlight *names = flightOf(m_model.step());
  return names ? flightIn(m_model.session().scene, *names) : std::nullopt;
}

FlightState FlightPlayer::state() const {
  FlightState state;
  const auto now = flight();
  state.canFire = now.has_value();
  state.isPlaying = m_isPlaying;
  state.speed = m_speed;
  state.reducedMotion = m_reducedMotion;
  if (now) {
    state.isAutomatic = now->firesByItself();
    state.seed = state.isAutomatic ? static_cast<int>(toDouble(now->seed.value))
                                   : m_seed.value_or(now->names.firstSeed);
    const Rational elapsed = now->elapsed();
    const Crossing *hit = now->hitIn(m_model.evaluation());
    state.elapsed = toDouble(elapsed);
    state.t = toDouble(hit ? std::min(elapsed, hit->at->t) : elapsed); // behind its hit it flies no more
  }
  return state;
}

void FlightPlayer::fire() {
  play(false);
  const auto now = flight();
  if (!now)
    return;
  // By itself it goes on with the next shot, by hand the same one is fired once more.
  const Rational next = now->shot().frame + framesPerShot;
  playFrom(*now, !now->firesByItself() || next >= now->frame.to ? Rational(0) : next);
}

void FlightPlayer::play(bool on) {
  if (on == m_isPlaying)
    return;
  if (!on)
    return m_model.history().endGesture(m_gesture); // which stops it
  auto now = flight();
  if (!now)
    return;
  playFrom(*now, now->frame.value >= now->lastFrame(m_model.evaluation()) ? Rational(0) : now->frame.value);
}

void FlightPlayer::playFrom(const SceneFlight &flight, const Rational &frame) {
  m_gesture = m_model.history().beginGesture(tr("Fly"));
  goOnFrom(flight, frame);
}

/// In a gesture that has begun.
void FlightPlayer::goOnFrom(const SceneFlight &flight, const Rational &frame) {
  m_from = frame;
  m_model.history().moveGesture(m_gesture, flight.toFrame(frame));
  m_isPlaying = true;
  m_clock.start();
  m_timer.start(m_reducedMotion ? stillInterval : tickInterval);
  emit stateChanged();
}

void FlightPlayer::stop() {
  m_isScrubbing = false;
  m_timer.stop();
  if (std::exchange(m_isPlaying, false))
    emit stateChanged();
}

void FlightPlayer::tick() {
  const auto now = flight();
  if (!now)
    return play(false);
  const double seconds = static_cast<double>(m_clock.nsecsElapsed()) * 1e-9;
  const Rational flown = m_reducedMotion ? now->frame.value - m_from + framesPerStill
                                         : roundToMultiple(seconds * m_speed * framesPerSecond, frameStep);
  const Rational frame = m_from + flown;
  const Rational last = now->lastFrame(m_model.evaluation());
  m_model.history().moveGesture(m_gesture, now->toFrame(std::min(frame, last)));
  if (frame < last)
    return;
  if (!now->firesByItself())
    return play(false);
  goOnFrom(*now, 0); // by itself it fires again and again
}

void FlightPlayer::step(int direction) {
  play(false);
  if (const auto now = flight())
    m_model.history().edit(
        now->toFrame(now->frame.value + direction * (m_reducedMotion ? framesPerStill : 1)), tr("Step"));
}

void FlightPlayer::setAutomatic(bool on) {
  m_seed = state().seed;
  fireBySeed(on ? *m_seed : 0);
}

/// From the first shot on; 0: by hand.
void FlightPlayer::fireBySeed(int seed) {
  play(false);
  const auto now = flight();
  if (!now)
    return;
  begin(*now, seed, seed != 0 ? tr("Fire by itself") : tr("Fire by hand"));
  if (seed != 0)
    return goOnFrom(*now, 0);
  m_model.history().endGesture(m_gesture);
}

/// A gesture that begins at the start, with this seed.
void FlightPlayer::begin(const SceneFlight &flight, int seed, const QString &description) {
  m_gesture = m_model.history().beginGesture(description);
  m_model.history().moveGesture(m_gesture, flight.toSeed(seed));
  m_model.history().moveGesture(m_gesture, flight.toFrame(0));
}

/// A step without the controls has none to bring the saucer back to where it starts, or to end what fires by
/// itself, while its barrel would aim at nothing.
void FlightPlayer::followStep() {
  if (flight())
    return;
  const auto controlled = std::exchange(m_controlled, {});
  if (!controlled || controlled->lesson != m_model.session().lesson)
    return;
  const auto left = flightIn(m_model.session().scene, controlled->names);
  if (!left || (!left->firesByItself() && left->frame.value == 0))
    return;
  begin(*left, 0, tr("Back to the start"));
  m_model.history().endGesture(m_gesture);
}

void FlightPlayer::setSeed(int seed) {
  m_seed = seed;
  if (state().isAutomatic)
    fireBySeed(seed);
}

void FlightPlayer::setSpeed(double speed) {
  if (const auto now = flight(); now && m_isPlaying) { // goes on from where it is
    m_from = now->frame.value;
    m_clock.restart();
  }
  m_speed = speed;
  emit stateChanged();
}

void FlightPlayer::beginScrub() {
  play(false);
  if (!flight())
    return;
  m_gesture = m_model.history().beginGesture(tr("Fly"));
  m_isScrubbing = true;
}

void FlightPlayer::endScrub(bool keep) {
  if (!std::exchange(m_isScrubbing, false))
    return;
  if (keep)
    m_model.history().endGesture(m_gesture);
  else
    m_model.history().cancelGesture(m_gesture);
}

void FlightPlayer::scrub(double t) {
  const auto now = flight();
  if (!now || !m_isScrubbing)
    return;
  m_model.history().moveGesture(m_gesture, now->toFrame(now->frameAt(t, m_model.evaluation())));
}

} // namespace halfspace
