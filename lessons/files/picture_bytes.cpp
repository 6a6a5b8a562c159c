#include "lessons/files/picture_bytes.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

// A PNG file: a signature, then pieces, each of them its length, its name, its content and a checksum.
constexpr std::size_t pngSignature = 8;
constexpr std::size_t pngNumber = 4;
constexpr std::size_t aroundPiece = 3 * pngNumber;
constexpr std::array<std::string_view, 7> seenPieces{"IHDR", "PLTE", "tRNS", "gAMA", "sRGB", "IDAT", "IEND"};

// A JPEG file: segments, each of them a marker of two bytes and mostly its length and its content. Behind the
// one that begins a scan follows what is coded, up to the next marker.
constexpr unsigned char markerByte = 0xFF;
constexpr unsigned char noMarker = 0x00; ///< behind a marker's byte: it is one of what is coded
constexpr unsigned char firstRestart = 0xD0;
constexpr unsigned char lastRestart = 0xD7; ///< restarts stand among what is coded
constexpr unsigned char beginOfImage = 0xD8;
constexpr unsigned char endOfImage = 0xD9;
constexpr unsigned char beginOfScan = 0xDA;
constexpr std::size_t markerSize = 2;

constexpr unsigned bitsOfByte = 8;

std::size_t numberAt(std::string_view bytes, std::size_t at, std::size_t size) {
  std::size_t number = 0;
  for (const char byte : bytes.substr(at, size))
    number = number << bitsOfByte | static_cast<unsigned char>(byte);
  return number;
}

unsigned char byteAt(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes[at]); }

bool isMarker(unsigned char kind) {
  return kind != noMarker && kind != markerByte && !(kind >= firstRestart && kind <= lastRestart);
}

/// Where the next marker stands that is no part of what is coded; at the end where there is none.
std::size_t nextMarker(std::string_view jpeg, std::size_t at) {
  for (; at + 1 < jpeg.size(); ++at)
    if (byteAt(jpeg, at) == markerByte && isMarker(byteAt(jpeg, at + 1)))
      return at;
  return jpeg.size();
}

} // namespace

std::string seenPartOfPng(std::string_view png) {
  std::string seen(png.substr(0, pngSignature));
  png.remove_prefix(seen.size());
  while (png.size() >= aroundPiece) {
    const std::size_t length = numberAt(png, 0, pngNumber);
    if (length > png.size() - aroundPiece)
      break;
    const std::string_view piece = png.substr(0, length + aroundPiece);
    if (std::find(seenPieces.begin(), seenPieces.end(), piece.substr(pngNumber, pngNumber)) !=
        seenPieces.end())
      seen += piece;
    png.remove_prefix(piece.size());
  }
  return seen;
}

std::size_t scansOfJpeg(std::string_view jpeg) {
  std::size_t scans = 0;
  for (std::size_t at = nextMarker(jpeg, 0); at < jpeg.size();) {
    const unsigned char kind = byteAt(jpeg, at + 1);
    if (kind == endOfImage)
      break;
    scans += kind == beginOfScan ? 1U : 0U;
    const std::size_t length = kind == beginOfImage ? 0 : numberAt(jpeg, at + markerSize, markerSize);
    at = nextMarker(jpeg, at + markerSize + length);
  }
  return scans;
}

} // namespace halfspace
