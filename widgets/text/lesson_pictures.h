// Where the pictures of a page come from, and how many it may show.
#pragma once

#include <filesystem>
#include <memory>

namespace halfspace {

/// A larger picture would take more memory, once it is unpacked, than a page of words is worth.
inline constexpr int mostPicturePixels = 1 << 24;

/// The pictures of a page have no more pixels together: four of the largest.
inline constexpr int mostPixelsOfPage = 4 * mostPicturePixels;

/// A picture takes the room of so many pixels, however few it has: it takes time to read its file.
inline constexpr int leastPixelsTaken = 1 << 18;

/// All pieces of words on a page share the room that is left. A piece that is made anew gives back what it
/// had.
struct LessonPictures {
  std::filesystem::path folder{}; ///< that they are taken from; empty: they are described
  std::shared_ptr<int> pixelsLeft = std::make_shared<int>(mostPixelsOfPage);

  bool operator==(const LessonPictures &) const = default;
};

} // namespace halfspace
