// The keys that suspend snapping in a drag.
#pragma once

#include <Qt>
#include <QtGlobal>

namespace halfspace {

/// Whether one of them is held. Alt too, where the window manager leaves it to us.
inline bool suspendsSnapping(Qt::KeyboardModifiers held) {
  return held & (Qt::ControlModifier | Qt::AltModifier);
}

} // namespace halfspace
