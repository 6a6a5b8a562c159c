// Photographs and scans of printed figures, with the QR code that holds their session.
#pragma once

#include "lessons/result.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

/// How files end that are read for their code alone, in small letters.
inline constexpr std::array photographEndings{".jpg", ".jpeg"};

/// The time of the processor that a picture is searched for. The largest take two or three seconds.
inline constexpr unsigned mostSearchSeconds = 10;

/// The text of the session in the QR code of a picture from a stranger's hands, PNG or JPEG: at most
/// `maxSessionBytes`, or a sentence where the code is foreign or unreadable, where there are several, or
/// where the picture is damaged, too large, or takes more seconds. Nothing where no code is in sight. The
/// picture is unpacked and searched in a process of its own.
[[nodiscard]] std::optional<Result<std::string>>
sessionInPhotograph(std::string_view picture, unsigned mostSeconds = mostSearchSeconds);

/// Of a photograph without a code.
[[nodiscard]] Problem noCode();

} // namespace halfspace
