// A motion as a file: its pictures, one after the other.
#pragma once

#include "widgets/animation/animation_format.h"
#include "widgets/animation/motion.h"
#include "widgets/picture/theme.h"

namespace halfspace {

struct FilmRequest {
  std::string file; ///< see `EncodingRequest`
  PixelSize size;
  int framesPerSecond = 25;
  bool isTransparent = false;
  Theme theme;
};

inline constexpr int mostFramesPerSecond = 60;
inline constexpr double shortestFilm = 0.1; ///< in seconds
inline constexpr double longestFilm = 600;
/// No film has more pictures, or more pixels together.
inline constexpr int mostPictures = 10'000;
inline constexpr double mostPixelsOfFilm = 2e10;

/// Who waits for a film.
struct FilmWatch {
  std::function<bool()> isCancelled;              ///< asked between pictures, and while another program works
  std::function<void(int picture, int all)> tell; ///< so many of all are done
};

/// The moments of a motion that a film shows, in seconds. The last is the motion's end, but of a loop, which
/// begins there anew. Requires a motion of no more than `mostPictures`.
[[nodiscard]] std::vector<double> momentsOf(const Motion &motion, int framesPerSecond);

struct Filmed {
  bool leavesOutSurfaces = false; ///< one of the pictures does, as `ShapeList` has it
};

/// Draws a motion into a file, which is there when all went well and not before. Of pictures with files of
/// their own those that are done stay. Once cancelled, the problem that it returns is for nobody. For any one
/// thread.
[[nodiscard]] Result<Filmed> film(Motion &motion, const AnimationFormat &format, const FilmRequest &request,
                                  const FilmWatch &watch);

} // namespace halfspace
