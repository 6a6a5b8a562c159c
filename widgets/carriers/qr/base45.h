// Bytes as the digits, capitals and signs that QR codes have a mode of their own for (RFC 9285).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

/// Three characters for two bytes, and two for a last one.
[[nodiscard]] std::string base45(std::string_view bytes);

/// The bytes again; nothing for what is no base45.
[[nodiscard]] std::optional<std::string> fromBase45(std::string_view text);

} // namespace halfspace
