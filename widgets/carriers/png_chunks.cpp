#include "widgets/carriers/png_chunks.h"

#include <zlib.h>

#include <cmath>
#include <cstdint>

namespace halfspace {
namespace {

constexpr std::size_t bytesOfNumber = 4;
constexpr std::size_t bytesOfType = 4;

std::uint32_t numberAt(std::string_view bytes) {
  std::uint32_t number = 0;
  for (const char byte : bytes.substr(0, bytesOfNumber))
    number = number << 8U | static_cast<unsigned char>(byte);
  return number;
}

std::string bytesOf(std::uint32_t number) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    bytes += static_cast<char>(number >> shift & 0xFFU);
  return bytes;
}

std::uint32_t checksumOf(std::string_view bytes) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): zlib's bytes are unsigned.
  const auto *begin = reinterpret_cast<const Bytef *>(bytes.data());
  return static_cast<std::uint32_t>(crc32_z(0, begin, bytes.size()));
}

constexpr double inchesPerMetre = 1 / 0.0254;

} // namespace

std::optional<PngChunk> takePngChunk(std::string_view &file) {
  constexpr std::size_t besides = bytesOfNumber + bytesOfType + bytesOfNumber;
  if (file.size() < besides)
    return {};
  const std::size_t length = numberAt(file);
  if (length > file.size() - besides)
    return {};
  const std::string_view checked = file.substr(bytesOfNumber, bytesOfType + length);
  const std::uint32_t checksum = numberAt(file.substr(bytesOfNumber + checked.size()));
  file.remove_prefix(besides + length);
  return PngChunk{checked.substr(0, bytesOfType), checked.substr(bytesOfType),
                  checksum == checksumOf(checked)};
}

std::string withPngChunk(std::string picture, std::string_view type, std::string_view data) {
  if (!isPng(picture))
    return picture;
  std::string_view rest = std::string_view(picture).substr(pngSignature.size());
  if (!takePngChunk(rest))
    return picture;
  const std::string checked = std::string(type) + std::string(data);
  const std::string chunk =
      bytesOf(static_cast<std::uint32_t>(data.size())) + checked + bytesOf(checksumOf(checked));
  return picture.insert(picture.size() - rest.size(), chunk);
}

std::string withPixelDensity(std::string picture, double pixelsPerInch) {
  const std::string perMetre =
      bytesOf(static_cast<std::uint32_t>(std::lround(pixelsPerInch * inchesPerMetre)));
  std::string data = perMetre;
  data += perMetre;
  data += '\1'; // both are so many a metre
  return withPngChunk(std::move(picture), "pHYs", data);
}

} // namespace halfspace
