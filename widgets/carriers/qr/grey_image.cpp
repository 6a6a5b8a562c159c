#include "widgets/carriers/qr/grey_image.h"

#include "lessons/files/picture_bytes.h"
#include "lessons/words.h"
#include "widgets/carriers/packed_scene.h"
#include "widgets/carriers/png_chunks.h"

#include <algorithm>
#include <memory>
#include <png.h>
#include <turbojpeg.h>

namespace halfspace {
namespace {

constexpr std::string_view beginOfJpeg = "\xFF\xD8\xFF";

Problem tooManyPixels() {
  return {words("This picture has too many pixels to be searched for a QR code: at most {limit} million are. "
                "Cut the code out of it, or make it smaller.",
                {{"limit", std::to_string(mostGreyPixels >> 20)}}),
          "", 0, ""};
}

Problem tooManyScans() {
  return {words("This picture goes over its pixels too often to be searched for a QR code: at most {limit} "
                "times. Save it as another file.",
                {{"limit", std::to_string(mostGreyScans)}}),
          "", 0, ""};
}

bool hasTooManyPixels(std::int64_t width, std::int64_t height) { return width * height > mostGreyPixels; }

/// An image in white of so many pixels.
GreyImage whiteImage(int width, int height) {
  constexpr std::uint8_t white = 0xFF;
  return {
      width, height,
      std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), white)};
}

/// libpng's own reader of whole pictures, which tells of errors instead of jumping out of them.
struct FreePng {
  void operator()(png_image *image) const { png_image_free(image); }
};

Result<GreyImage> greyPng(std::string_view file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, FreePng> freed(&png);
  if (png_image_begin_read_from_memory(&png, file.data(), file.size()) == 0)
    return damagedPicture();
  if (hasTooManyPixels(png.width, png.height))
    return tooManyPixels();
  png.format = PNG_FORMAT_GRAY;
  GreyImage image = whiteImage(static_cast<int>(png.width), static_cast<int>(png.height));
  constexpr png_byte white = 0xFF;
  const png_color background{white, white, white};
  constexpr png_int_32 asLongAsItIs = 0; // the step from row to row
  if (png_image_finish_read(&png, &background, image.pixels.data(), asLongAsItIs, nullptr) == 0)
    return damagedPicture();
  return image;
}

struct FreeJpeg {
  void operator()(void *decoder) const { tjDestroy(decoder); }
};

Result<GreyImage> greyJpeg(std::string_view file) {
  if (scansOfJpeg(file) > mostGreyScans)
    return tooManyScans();
  const std::unique_ptr<void, FreeJpeg> decoder(tjInitDecompress());
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the library's bytes are unsigned.
  const auto *bytes = reinterpret_cast<const unsigned char *>(file.data());
  int width = 0;
  int height = 0;
  int sampling = 0;
  int space = 0;
  if (!decoder ||
      tjDecompressHeader3(decoder.get(), bytes, file.size(), &width, &height, &sampling, &space) != 0)
    return damagedPicture();
  if (hasTooManyPixels(width, height))
    return tooManyPixels();
  GreyImage image = whiteImage(width, height);
  const int result = tjDecompress2(decoder.get(), bytes, file.size(), image.pixels.data(), width, width,
                                   height, TJPF_GRAY, TJFLAG_ACCURATEDCT);
  if (result != 0 && tjGetErrorCode(decoder.get()) != TJERR_WARNING)
    return damagedPicture();
  return image;
}

} // namespace

bool isPixelPicture(std::string_view file) { return isPng(file) || file.starts_with(beginOfJpeg); }

Result<GreyImage> greyImageOf(std::string_view file) { return isPng(file) ? greyPng(file) : greyJpeg(file); }

GreyImage doubled(const GreyImage &image) {
  GreyImage larger = whiteImage(2 * image.width, 2 * image.height);
  // A pixel of the larger image lies in one of the smaller, nearer to one neighbour than to the other.
  const auto other = [](int place, int end) {
    return std::clamp(place % 2 == 0 ? place / 2 - 1 : place / 2 + 1, 0, end - 1);
  };
  const auto at = [](const GreyImage &in, int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(in.width) +
           static_cast<std::size_t>(column);
  };
  for (int row = 0; row < larger.height; ++row)
    for (int column = 0; column < larger.width; ++column) {
      const int otherColumn = other(column, image.width);
      const int otherRow = other(row, image.height);
      // Each of both directions has three parts of the pixel that it lies in, and one of the other.
      larger.pixels[at(larger, column, row)] =
          static_cast<std::uint8_t>((9 * image.pixels[at(image, column / 2, row / 2)] +
                                     3 * image.pixels[at(image, otherColumn, row / 2)] +
                                     3 * image.pixels[at(image, column / 2, otherRow)] +
                                     image.pixels[at(image, otherColumn, otherRow)]) /
                                    16);
    }
  return larger;
}

} // namespace halfspace
