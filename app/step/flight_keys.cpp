#include "app/step/flight_keys.h"

namespace halfspace {

QKeySequence keysOf(FlightControl control) {
  switch (control) {
  case FlightControl::Fire:
    return QKeySequence("T");
  case FlightControl::Play:
    return QKeySequence("P");
  case FlightControl::StepBack:
    return QKeySequence(",");
  case FlightControl::StepForward:
    return QKeySequence(".");
  case FlightControl::Automatic:
  case FlightControl::Speed:
    break;
  }
  return {};
}

} // namespace halfspace
