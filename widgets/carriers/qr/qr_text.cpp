#include "widgets/carriers/qr/qr_text.h"

#include "lessons/words.h"
#include "widgets/carriers/deflate.h"
#include "widgets/carriers/packed_scene.h"
#include "widgets/carriers/qr/base45.h"

namespace halfspace {
namespace {

constexpr std::string_view sign = "HALFSPACE:";

} // namespace

Result<std::string> qrTextOf(std::string_view session) {
  const std::string packed = deflated(session);
  if (packed.size() > mostBytesInCode)
    return Problem{
        words("This scene is too long for a QR code: packed it has {count} bytes. A code that can be "
              "photographed holds {limit}: one with more would be wider than 47 mm, or its squares "
              "too small.",
              {{"count", std::to_string(packed.size())}, {"limit", std::to_string(mostBytesInCode)}}),
        "", 0, ""};
  return std::string(sign) + base45(packed);
}

bool isQrText(std::string_view text) { return text.starts_with(sign); }

Result<std::string> sessionInQrText(std::string_view text) {
  const auto packed = isQrText(text) ? fromBase45(text.substr(sign.size())) : std::nullopt;
  return packed ? unpackedScene(*packed) : damagedScene();
}

} // namespace halfspace
