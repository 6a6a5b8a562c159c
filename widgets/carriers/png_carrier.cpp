// PNG: a chunk of text, iTXt, deflated. It is found wherever it stands and whatever stands before it, and as
// the older kinds of text as well, which some programs make of it.
#include "widgets/carriers/carrier.h"
#include "widgets/carriers/deflate.h"
#include "widgets/carriers/packed_scene.h"

#include <zlib.h>

#include <cstdint>
#include <optional>

namespace halfspace {
namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
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

struct Chunk {
  std::string_view type;
  std::string_view data;
  bool isWhole = false; ///< its checksum is right
};

/// Takes a chunk off the front of a file; nothing where none is there to its end.
std::optional<Chunk> takeChunk(std::string_view &file) {
  constexpr std::size_t besides = bytesOfNumber + bytesOfType + bytesOfNumber;
  if (file.size() < besides)
    return {};
  const std::size_t length = numberAt(file);
  if (length > file.size() - besides)
    return {};
  const std::string_view checked = file.substr(bytesOfNumber, bytesOfType + length);
  const std::uint32_t checksum = numberAt(file.substr(bytesOfNumber + checked.size()));
  file.remove_prefix(besides + length);
  return Chunk{checked.substr(0, bytesOfType), checked.substr(bytesOfType), checksum == checksumOf(checked)};
}

/// Takes what stands before the next zero off the front, and the zero; nothing where there is none.
std::optional<std::string_view> takeWord(std::string_view &text) {
  const auto end = text.find('\0');
  if (end == std::string_view::npos)
    return {};
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(end + 1);
  return word;
}

/// What stands behind its name in a chunk of deflated text.
Result<std::string> unpackedText(std::string_view text) {
  if (!text.starts_with('\0')) // there is one way of packing
    return damagedScene();
  return unpackedScene(text.substr(1));
}

/// What stands behind its name in a chunk of international text.
Result<std::string> internationalText(std::string_view text) {
  if (text.size() < 2)
    return damagedScene();
  const bool isPacked = text[0] == '\1';
  const bool isKnownWay = text[1] == '\0'; // there is one way of packing
  text.remove_prefix(2);
  if ((isPacked && !isKnownWay) || !takeWord(text) || !takeWord(text)) // its language, and its name in that
    return damagedScene();
  return isPacked ? unpackedScene(text) : std::string(text);
}

/// The session's text in a chunk; nothing where the chunk is another one.
std::optional<Result<std::string>> sessionIn(const Chunk &chunk) {
  const bool isInternational = chunk.type == "iTXt";
  const bool isPacked = chunk.type == "zTXt";
  if (!isInternational && !isPacked && chunk.type != "tEXt")
    return {};
  std::string_view text = chunk.data;
  if (takeWord(text) != carriedName)
    return {};
  if (!chunk.isWhole)
    return damagedScene();
  return isInternational ? internationalText(text) : isPacked ? unpackedText(text) : std::string(text);
}

bool isPng(std::string_view file) { return file.starts_with(signature); }

/// Directly behind the picture's sizes, which stand first.
std::string putIntoPng(std::string picture, std::string_view session) {
  std::string_view rest = std::string_view(picture).substr(signature.size());
  if (!takeChunk(rest))
    return picture;
  using namespace std::string_literals;
  const std::string data = "iTXt" + std::string(carriedName) + "\0\1\0\0\0"s + deflated(session);
  const std::string chunk =
      bytesOf(static_cast<std::uint32_t>(data.size() - bytesOfType)) + data + bytesOf(checksumOf(data));
  return picture.insert(picture.size() - rest.size(), chunk);
}

Result<std::string> takeFromPng(std::string_view picture) {
  picture.remove_prefix(signature.size());
  while (const auto chunk = takeChunk(picture)) {
    if (auto session = sessionIn(*chunk))
      return std::move(*session);
    if (chunk->type == "IEND")
      return noScene();
  }
  return damagedPicture();
}

} // namespace

Carrier png_carrier() { return {"PNG", ".png", isPng, putIntoPng, takeFromPng}; }

} // namespace halfspace
