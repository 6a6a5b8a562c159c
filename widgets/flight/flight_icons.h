// The icons of a flight's controls.
#pragma once

#include <QIcon>
#include <QPainterPath>

#include <cstdint>

namespace halfspace {

enum class FlightIcon : std::uint8_t { Fire, Play, Pause, StepBack, StepForward, Automatic };

[[nodiscard]] QIcon iconOf(FlightIcon icon, const QColor &ink);

/// A torpedo that flies to the right. Its tip is the origin, its length 1.
[[nodiscard]] QPainterPath torpedo();

} // namespace halfspace
