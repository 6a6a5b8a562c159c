// PNG: a chunk of text, iTXt, deflated. It is found wherever it stands and whatever stands before it, and as
// the older kinds of text as well, which some programs make of it.
#include "lessons/words.h"
#include "widgets/carriers/carrier.h"
#include "widgets/carriers/deflate.h"
#include "widgets/carriers/packed_scene.h"
#include "widgets/carriers/png_chunks.h"

#include <optional>

namespace halfspace {
namespace {

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
std::optional<Result<std::string>> sessionIn(const PngChunk &chunk) {
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

std::string putIntoPng(std::string picture, std::string_view session) {
  using namespace std::string_literals;
  return withPngChunk(std::move(picture), "iTXt",
                      std::string(carriedName) + "\0\1\0\0\0"s + deflated(session));
}

Result<std::string> takeFromPng(std::string_view picture) {
  picture.remove_prefix(pngSignature.size());
  while (const auto chunk = takePngChunk(picture)) {
    if (auto session = sessionIn(*chunk))
      return std::move(*session);
    if (chunk->type == "IEND")
      return noScene();
  }
  return damagedPicture();
}

} // namespace

Carrier png_carrier() {
  return {"PNG", ".png", isPng, putIntoPng, takeFromPng, [] {
            return words(
                "Screenshots lose the scene, and so do programs that make a new picture of the pixels.");
          }};
}

} // namespace halfspace
