// The controls of a flight along a ray, and the axis of its parameter.
#pragma once

#include "widgets/flight/flight_axis.h"
#include "widgets/flight/flight_icons.h"
#include "widgets/flight/short_decimal.h"
#include "widgets/text/math_label.h"

#include <QKeySequence>

#include <cstdint>
#include <map>

class QAction;
class QSpinBox;
class QToolButton;

namespace halfspace {

/// What the bar shows.
struct FlightState {
  double t = 0;       ///< where the torpedo is
  double elapsed = 0; ///< where it would be had it hit nothing
  bool isPlaying = false;
  double speed = 1;
  bool canFire = true;
  bool isAutomatic = false;
  int seed = 1;               ///< of chance, when it fires by itself
  bool reducedMotion = false; ///< nothing flies: there is nothing to play, and no speed
  bool hidden = false;        ///< a question is open
  bool operator==(const FlightState &) const = default;
};

enum class FlightControl : std::uint8_t { Fire, StepBack, Play, StepForward, Automatic, Speed };

/// Holds nothing: a button only says what is wanted, and shows it once it is told.
class FlightBar : public QWidget {
  Q_OBJECT
public:
  /// The typesetter must outlive the bar.
  explicit FlightBar(const Typesetter &typesetter, QWidget *parent = nullptr);

  void setState(const FlightState &state);
  void setTheme(const Theme &theme);
  /// The key that does the same as a control, whoever hears it: its tool tip tells it.
  void setKeys(FlightControl control, const QKeySequence &keys);

  [[nodiscard]] const FlightState &state() const { return m_state; }
  /// What the ray crosses; the torpedo is dragged on it.
  [[nodiscard]] FlightAxis &axis() const { return *m_axis; }
  [[nodiscard]] QToolButton &button(FlightControl control) const;
  /// Where the seed is typed; it is there while it fires by itself.
  [[nodiscard]] QSpinBox &seed() const { return *m_seed; }
  /// The present λ, as it is read: λ ≈ 0.33.
  [[nodiscard]] QString readout() const;

signals:
  void fire();
  void playToggled(bool play);
  void stepped(int direction); ///< −1 or 1
  void automaticToggled(bool on);
  void seedChanged(int seed);
  void speedChanged(double speed);

protected:
  void changeEvent(QEvent *event) override;

private:
  void makeButtons();
  void makeSpeeds();
  void makeSeed();
  void showControls();
  /// The present λ; nothing while it is hidden.
  [[nodiscard]] std::optional<WrittenNumber> parameter() const;
  void showTime();
  void describe(FlightControl control, const QString &words);
  void setSizes();

  const Typesetter &m_typesetter;
  QList<QToolButton *> m_buttons; ///< by FlightControl
  std::map<FlightControl, QKeySequence> m_keys;
  QList<QAction *> m_speeds;
  QSpinBox *m_seed = nullptr;
  QIcon m_play;
  QIcon m_pause;
  MathLabel *m_readout;
  FlightAxis *m_axis;
  FlightState m_state;
  Theme m_theme;
};

} // namespace halfspace
