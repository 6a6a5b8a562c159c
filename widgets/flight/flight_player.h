// The clock of a torpedo's flight.
#pragma once

#include "widgets/flight/flight_bar.h"
#include "widgets/flight/scene_flight.h"
#include "widgets/session_model.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace halfspace {

/// Moves the number of the frame in the scene as the clock goes, or as the hand wants it: where the torpedo
/// is follows from the scene alone. A flight that is played is one undo step, as a drag is; whatever else
/// changes the scene ends it.
class FlightPlayer : public QObject {
  Q_OBJECT
public:
  explicit FlightPlayer(SessionModel &model, QObject *parent = nullptr);

  /// Goes by what a bar wants; the bar is told by whoever hears stateChanged.
  void serve(FlightBar &bar);
  /// Without motion a flight is a few steps, each of which stands still for a moment.
  void setReducedMotion(bool reduced);

  /// Of the step that is shown.
  [[nodiscard]] FlightState state() const;

  void fire();
  void play(bool on);
  /// On by a frame, or back; without motion by more.
  void step(int direction);
  void setAutomatic(bool on);
  /// What chance begins with when it fires by itself; if it does, it begins anew.
  void setSeed(int seed);
  void setSpeed(double speed);

signals:
  void stateChanged();

private:
  /// What the bar controls that was served last.
  struct Controlled {
    std::string lesson;
    StepFlight names;
  };
  /// Of the step that is shown; nothing in a step without one.
  [[nodiscard]] std::optional<SceneFlight> flight() const;
  void fireBySeed(int seed);
  void begin(const SceneFlight &flight, int seed, const QString &description);
  void followStep();
  void beginScrub();
  void scrub(double t);
  void endScrub(bool keep);
  void playFrom(const SceneFlight &flight, const Rational &frame);
  void goOnFrom(const SceneFlight &flight, const Rational &frame);
  void tick();
  void stop();

  SessionModel &m_model;
  QTimer m_timer;
  GestureToken m_gesture = GestureToken::Nobodys;
  QElapsedTimer m_clock; ///< since the flight went on
  Rational m_from;       ///< the frame from which it went on
  double m_speed = 1;
  std::optional<int> m_seed; ///< of the next time that it fires by itself; nothing: as the lesson says
  std::optional<Controlled> m_controlled;
  bool m_reducedMotion = false;
  bool m_isPlaying = false;
  bool m_isScrubbing = false; ///< its gesture is that of the hand on the axis
};

} // namespace halfspace
