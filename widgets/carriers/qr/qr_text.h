// What a QR code says that holds a session.
#pragma once

#include "lessons/result.h"

#include <string>
#include <string_view>

namespace halfspace {

/// More bytes than this, deflated, are put into no code: it would have more than 117 modules (version 25)
/// with error correction M. On paper a module takes 0.4 mm, as less is not told apart by a camera that sees a
/// whole page, so such a code is 47 mm wide; a larger one is seldom flat and sharp all over in a photograph.
inline constexpr std::size_t mostBytesInCode = 960;

/// The text of a session, deflated and written in characters of QR's alphanumeric mode, behind a word that
/// tells whose it is: HALFSPACE:… A sentence where it is too long for a code that can be photographed.
[[nodiscard]] Result<std::string> qrTextOf(std::string_view session);

/// Whether a code says that it holds a session.
[[nodiscard]] bool isQrText(std::string_view text);

/// The text of the session again, out of what a stranger's code says: at most `maxSessionBytes`, or a
/// sentence.
[[nodiscard]] Result<std::string> sessionInQrText(std::string_view text);

} // namespace halfspace
