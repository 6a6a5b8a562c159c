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
/// Frames of the clock are rounded to this, so that the numbers stay short.
const Rational frameStep(1, 100);
/// A flight goes on for so many frames behind the hit, and for so many where nothing is hit.
constexpr int framesBehindHit = 50;
constexpr int framesWithoutHit = 100;

/// After so many frames a torpedo has come to t, or a little farther.
Rational framesUntil(const Rational &t) { return roundUpToMultiple(t * framesPerLambda, frameStep); }

} // namespace

FlightPlayer::FlightPlayer(SessionModel &model, QObject *parent)
    : QObject(parent), m_model(model), m_timer(this) {
  m_timer.setTimerType(Qt::PreciseTimer);
  connect(&m_timer, &QTimer::timeout, this, &FlightPlayer::tick);
  connect(&model, &SessionModel::gestureChanged, this, [this] {
    if (!m_model.inGesture())
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
  connect(&bar, &FlightBar::scrubBegun, this, &FlightPlayer::beginScrub);
  connect(&bar, &FlightBar::scrubbed, this, &FlightPlayer::scrub);
  connect(&bar, &FlightBar::scrubEnded, this, &FlightPlayer::endScrub);
}

void FlightPlayer::setReducedMotion(bool reduced) {
  play(false);
  m_reducedMotion = reduced;
  emit stateChanged();
}

std::optional<FlightPlayer::Flight> FlightPlayer::flight() const {
  const StepFlight *names = flightOf(m_model.step());
  return names ? flightBy(*names) : std::nullopt;
}

std::optional<FlightPlayer::Flight> FlightPlayer::flightBy(const StepFlight &names) const {
  const Scene &scene = m_model.session().scene;
  const Object *frame = findObject(scene, names.frame);
  const Object *seed = findObject(scene, names.seed);
  const auto frameNumber = frame ? objectAs<NumberObject>(*frame) : std::nullopt;
  const auto seedNumber = seed ? objectAs<NumberObject>(*seed) : std::nullopt;
  if (!frameNumber || !seedNumber)
    return {};
  return Flight{names, *frameNumber, *seedNumber};
}

FlightState FlightPlayer::state() const {
  FlightState state;
  const auto now = flight();
  state.canFire = now.has_value();
  state.isPlaying = m_isPlaying;
  state.speed = m_speed;
  state.reducedMotion = m_reducedMotion;
  if (now) {
    const Rational &seed = now->seed.value;
    state.isAutomatic = seed != 0;
    state.seed = seed != 0 ? static_cast<int>(toDouble(seed)) : m_seed.value_or(now->names.firstSeed);
    const Rational elapsed = elapsedOf(*now);
    const Crossing *hit = hitOf(*now);
    state.elapsed = toDouble(elapsed);
    state.t = toDouble(hit ? std::min(elapsed, hit->at->t) : elapsed); // behind its hit it flies no more
  }
  return state;
}

/// The shot that is on its way.
Shot FlightPlayer::shotOf(const Flight &flight) { return shotAt(flight.frame.value, flight.seed.value); }

/// The parameter to which the torpedo has come if it has hit nothing.
Rational FlightPlayer::elapsedOf(const Flight &flight) {
  return parameterAt(flight.frame.value, shotOf(flight));
}

/// What the torpedo hits first; nothing: nullptr.
const Crossing *FlightPlayer::hitOf(const Flight &flight) const {
  return nearestOf(crossingsOf(m_model.evaluation(), flight.names.hits));
}

/// Fired by itself it goes on; by hand until the explosion is over.
Rational FlightPlayer::lastFrame(const Flight &flight) const {
  if (flight.seed.value != 0)
    return flight.frame.to;
  const Crossing *hit = hitOf(flight);
  const Rational last =
      hit ? Rational(framesUntil(hit->at->t) + framesBehindHit) : Rational(framesWithoutHit);
  return std::min(last, flight.frame.to);
}

ChangeObject FlightPlayer::toFrame(const Flight &flight, const Rational &frame) {
  NumberObject changed = flight.frame;
  changed.value = std::clamp(frame, changed.from, changed.to);
  return {flight.names.frame, changed};
}

void FlightPlayer::fire() {
  play(false);
  const auto now = flight();
  if (!now)
    return;
  // By itself it goes on with the next shot, by hand the same one is fired once more.
  const Rational next = shotOf(*now).frame + framesPerShot;
  playFrom(*now, now->seed.value == 0 || next >= now->frame.to ? Rational(0) : next);
}

void FlightPlayer::play(bool on) {
  if (on == m_isPlaying)
    return;
  if (!on)
    return m_model.endGesture(m_gesture); // which stops it
  auto now = flight();
  if (!now)
    return;
  playFrom(*now, now->frame.value >= lastFrame(*now) ? Rational(0) : now->frame.value);
}

void FlightPlayer::playFrom(const Flight &flight, const Rational &frame) {
  m_gesture = m_model.beginGesture(tr("Fly"));
  goOnFrom(flight, frame);
}

/// In a gesture that has begun.
void FlightPlayer::goOnFrom(const Flight &flight, const Rational &frame) {
  m_from = frame;
  m_model.moveGesture(m_gesture, toFrame(flight, frame));
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
  const Rational last = lastFrame(*now);
  m_model.moveGesture(m_gesture, toFrame(*now, std::min(frame, last)));
  if (frame < last)
    return;
  if (now->seed.value == 0)
    return play(false);
  goOnFrom(*now, 0); // by itself it fires again and again
}

void FlightPlayer::step(int direction) {
  play(false);
  if (const auto now = flight())
    m_model.edit(toFrame(*now, now->frame.value + direction * (m_reducedMotion ? framesPerStill : 1)),
                 tr("Step"));
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
  m_model.endGesture(m_gesture);
}

/// A gesture that begins at the start, with this seed.
void FlightPlayer::begin(const Flight &flight, int seed, const QString &description) {
  NumberObject changed = flight.seed;
  changed.value = std::clamp(Rational(seed), changed.from, changed.to);
  m_gesture = m_model.beginGesture(description);
  m_model.moveGesture(m_gesture, ChangeObject{flight.names.seed, changed});
  m_model.moveGesture(m_gesture, toFrame(flight, 0));
}

/// A step without the controls has none to bring the saucer back to where it starts, or to end what fires by
/// itself, while its barrel would aim at nothing.
void FlightPlayer::followStep() {
  if (flight())
    return;
  const auto controlled = std::exchange(m_controlled, {});
  if (!controlled || controlled->lesson != m_model.session().lesson)
    return;
  const auto left = flightBy(controlled->names);
  if (!left || (left->seed.value == 0 && left->frame.value == 0))
    return;
  begin(*left, 0, tr("Back to the start"));
  m_model.endGesture(m_gesture);
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
  m_gesture = m_model.beginGesture(tr("Fly"));
  m_isScrubbing = true;
}

void FlightPlayer::endScrub(bool keep) {
  if (!std::exchange(m_isScrubbing, false))
    return;
  if (keep)
    m_model.endGesture(m_gesture);
  else
    m_model.cancelGesture(m_gesture);
}

/// The frame in which the torpedo of a shot has come to t; where that is a crossing's, all of the way.
Rational FlightPlayer::frameAt(double t, const Shot &shot, const StepFlight &names) const {
  for (const Crossing &crossing : crossingsOf(m_model.evaluation(), names.hits).all)
    if (crossing.at && toDouble(crossing.at->t) == t)
      return shot.frame + framesUntil(crossing.at->t);
  return shot.frame + roundToMultiple(t * framesPerLambda, frameStep);
}

void FlightPlayer::scrub(double t) {
  const auto now = flight();
  if (!now || !m_isScrubbing)
    return;
  const Shot shot = shotOf(*now);
  Rational frame = frameAt(t, shot, now->names);
  if (now->seed.value != 0) // it stays with its shot
    frame = std::clamp(frame, shot.frame, Rational(shot.frame + framesPerShot - frameStep));
  m_model.moveGesture(m_gesture, toFrame(*now, frame));
}

} // namespace halfspace
