// Bytes as letters, digits, + and / (RFC 4648).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

/// In one line, filled up with = to a multiple of four.
[[nodiscard]] std::string base64(std::string_view bytes);

/// The bytes again, with white space anywhere; nothing for what is no base64.
[[nodiscard]] std::optional<std::string> fromBase64(std::string_view text);

} // namespace halfspace
