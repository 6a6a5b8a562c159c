#include "widgets/carriers/qr/qr_code.h"

#include "widgets/carriers/qr/qr_text.h"

#include <memory>
#include <new>
#include <qrencode.h>

namespace halfspace {
namespace {

struct FreeInput {
  void operator()(QRinput *input) const { QRinput_free(input); }
};
struct FreeSymbol {
  void operator()(QRcode *symbol) const { QRcode_free(symbol); }
};
using Symbol = std::unique_ptr<QRcode, FreeSymbol>;

/// The smallest symbol for a text of characters of the alphanumeric mode. Null where there is none that is
/// large enough.
Symbol symbolOf(std::string_view text, QRecLevel level) {
  constexpr int smallest = 0;
  const std::unique_ptr<QRinput, FreeInput> input(QRinput_new2(smallest, level));
  if (!input)
    throw std::bad_alloc();
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the library's bytes are unsigned.
  const auto *bytes = reinterpret_cast<const unsigned char *>(text.data());
  if (QRinput_append(input.get(), QR_MODE_AN, static_cast<int>(text.size()), bytes) != 0)
    return {};
  return Symbol(QRcode_encodeInput(input.get()));
}

QrCode codeOf(const QRcode &symbol) {
  QrCode code{symbol.width, {}};
  constexpr unsigned char dark = 1; // the other bits tell what a module is for
  const auto count = static_cast<std::size_t>(symbol.width) * static_cast<std::size_t>(symbol.width);
  for (std::size_t i = 0; i < count; ++i)
    code.modules.push_back((symbol.data[i] & dark) != 0);
  return code;
}

} // namespace

Result<QrCode> qrCodeOf(std::string_view session) {
  const auto text = qrTextOf(session);
  if (!text)
    return text.problem();
  Symbol symbol = symbolOf(*text, QR_ECLEVEL_M);
  if (!symbol) // there is one for a text of this length
    throw std::bad_alloc();
  for (const QRecLevel level : {QR_ECLEVEL_Q, QR_ECLEVEL_H})
    if (Symbol safer = symbolOf(*text, level); safer && safer->width == symbol->width)
      symbol = std::move(safer);
  return codeOf(*symbol);
}

} // namespace halfspace
