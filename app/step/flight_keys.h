// The keys of a flight's controls.
#pragma once

#include "widgets/flight/flight_bar.h"

#include <QKeySequence>

namespace halfspace {

/// Empty for a control without a key.
[[nodiscard]] QKeySequence keysOf(FlightControl control);

} // namespace halfspace
