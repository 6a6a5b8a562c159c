// Pictures for encoders, and what they are asked for.
#pragma once

#include "tests/program_test.h"
#include "widgets/animation/animation_format.h"

namespace halfspace::test {

/// A square that moves to the right over a plain ground, white where it is not clear.
inline RgbaImage movingSquare(PixelSize size, int at, bool isClear = false) {
  RgbaImage image{size.width, size.height, {}};
  const int side = size.height / 2;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const bool isIn = x >= at && x < at + side && y >= side / 2 && y < side / 2 + side;
      const std::uint8_t ground = isIn ? 0 : 255;
      const std::uint8_t alpha = isClear && !isIn ? 0 : 255;
      image.rgba.insert(image.rgba.end(), {ground, isIn ? std::uint8_t{114} : ground,
                                           isIn ? std::uint8_t{178} : ground, alpha});
    }
  return image;
}

inline EncodingRequest requestFor(const std::filesystem::path &file, PixelSize size) {
  EncodingRequest request;
  request.file = file.string();
  request.size = size;
  request.isCancelled = [] { return false; };
  return request;
}

/// Begins, shows and writes so many pictures of a square that moves; the problem that it meets.
inline std::optional<Problem> encode(const EncodingRequest &request, int pictures) {
  const auto encoder = animationFormatOf(request.file)->begin(request);
  if (!encoder)
    return encoder.problem();
  const auto picture = [&](int i) { return movingSquare(request.size, i, request.isTransparent); };
  for (int i = 0; i < pictures; ++i)
    (*encoder)->preview(picture(i));
  for (int i = 0; i < pictures; ++i)
    if (auto problem = (*encoder)->add(picture(i)))
      return problem;
  return (*encoder)->finish();
}

/// How many files a folder has.
inline std::ptrdiff_t filesIn(const std::filesystem::path &folder) {
  return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
}

} // namespace halfspace::test
