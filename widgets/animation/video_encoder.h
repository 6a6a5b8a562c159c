// Videos, by ffmpeg where that is installed.
#pragma once

#include "widgets/animation/animation_format.h"

#include <QStringList>

namespace halfspace {

/// What ffmpeg is told of a format.
struct VideoCoding {
  QString container;
  QStringList arguments; ///< of the codec
  bool needsEvenSides = false;
};

/// A format that ffmpeg writes, as it is found in PATH when it is needed. It gets the pictures through a pipe
/// and writes to a file of another name, which takes its own when all went well; cancelled, it is killed.
[[nodiscard]] AnimationFormat videoFormat(const std::string &name, const std::string &ending,
                                          const VideoCoding &coding);

} // namespace halfspace
