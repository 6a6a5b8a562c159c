// What a learner wants of the coordinates that formulas show.
#pragma once

#include "lessons/term/term.h"

#include <QObject>

namespace halfspace {

/// Speaks for numbers that are changed where they stand, with which number it is, as a NumberField does for
/// one.
class CoordinateChanges : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// Says whatever another one says, until it is disconnected from this.
  void repeat(const CoordinateChanges &other);

signals:
  void typing(); ///< what is typed in place of a number has changed, and is not entered yet
  void coordinateTyped(const halfspace::CoordinateSource &number, const halfspace::Rational &value);
  void coordinateStepped(const halfspace::CoordinateSource &number, int steps);
  void scrubStarted(const halfspace::CoordinateSource &number);
  void scrubbed(int steps);
  void scrubEnded(bool keep);
};

} // namespace halfspace
