// Changing one number of a coordinate, as fields and formulas do.
#pragma once

#include "widgets/session_model.h"

namespace halfspace {

/// A number of the scene that is given: axis 0, 1, 2 of a coordinate.
struct CoordinateNumber {
  CoordinateId id;
  int axis = 0;
};

/// Turns numbers that are typed, stepped and scrubbed into edits of the session. What the session does not
/// take, or has no object for any more, changes nothing.
class CoordinateEditor {
public:
  /// The model must outlive it.
  explicit CoordinateEditor(SessionModel &model) : m_model(model) {}

  /// What `change` would do; nothing where it would do nothing.
  [[nodiscard]] std::optional<ChangeObject> editOf(const CoordinateNumber &number,
                                                   const Rational &value) const;
  /// One undo step.
  void change(const CoordinateNumber &number, const Rational &value);
  /// So many snapping steps up or down; one undo step.
  void step(const CoordinateNumber &number, int steps);

  /// From beginScrub to endScrub is one undo step.
  void beginScrub(const CoordinateNumber &number);
  /// So many snapping steps from where it began.
  void scrub(int steps);
  void endScrub(bool keep);

private:
  [[nodiscard]] Rational valueOf(const CoordinateNumber &number) const;
  /// The step that suits a coordinate: of a position the stage's, of a direction its own size's.
  [[nodiscard]] Rational stepOf(const CoordinateId &id) const;
  /// For the history.
  [[nodiscard]] QString nameOfChange(const CoordinateNumber &number) const;

  SessionModel &m_model;
  CoordinateNumber m_scrubbed;
  GestureToken m_gesture = GestureToken::Nobodys;
  Rational m_scrubStart;
  Rational m_scrubStep;
};

} // namespace halfspace
