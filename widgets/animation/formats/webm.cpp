#include "widgets/animation/video_encoder.h"

namespace halfspace {

AnimationFormat webm() {
  // Of constant quality, whatever rate that takes; at 24 thin lines stay sharp.
  return videoFormat("WebM", ".webm",
                     {"webm",
                      {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-deadline", "good", "-cpu-used", "3",
                       "-row-mt", "1"},
                      false});
}

} // namespace halfspace
