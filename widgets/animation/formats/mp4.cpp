#include "widgets/animation/video_encoder.h"

namespace halfspace {

AnimationFormat mp4() {
  // What nearly every player and slide program shows: colours at half the resolution, and its index in front.
  // 18 is next to what the eye takes for lossless.
  return videoFormat(
      "MP4", ".mp4",
      {"mp4", {"-c:v", "libx264", "-preset", "medium", "-crf", "18", "-movflags", "+faststart"}, true});
}

} // namespace halfspace
