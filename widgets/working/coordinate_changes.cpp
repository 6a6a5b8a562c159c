#include "widgets/working/coordinate_changes.h"

namespace halfspace {

void CoordinateChanges::repeat(const CoordinateChanges &other) {
  connect(&other, &CoordinateChanges::typing, this, &CoordinateChanges::typing);
  connect(&other, &CoordinateChanges::coordinateTyped, this, &CoordinateChanges::coordinateTyped);
  connect(&other, &CoordinateChanges::coordinateStepped, this, &CoordinateChanges::coordinateStepped);
  connect(&other, &CoordinateChanges::scrubStarted, this, &CoordinateChanges::scrubStarted);
  connect(&other, &CoordinateChanges::scrubbed, this, &CoordinateChanges::scrubbed);
  connect(&other, &CoordinateChanges::scrubEnded, this, &CoordinateChanges::scrubEnded);
}

} // namespace halfspace
