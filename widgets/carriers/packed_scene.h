// What carriers have in common: how a scene is unpacked, and what is said where that cannot be.
#pragma once

#include "lessons/result.h"

#include <string>
#include <string_view>

namespace halfspace {

/// What the text of a session is called in pictures that give their texts names.
inline constexpr std::string_view carriedName = "halfspace-session";

/// Of a picture in which no session is found.
[[nodiscard]] Problem noScene();
/// Of one in which a session is found that is not as it was put in.
[[nodiscard]] Problem damagedScene();
/// Of one that ends too early, or is otherwise not as its format says, before a session is found.
[[nodiscard]] Problem damagedPicture();

/// The text of a session that was deflated: whole, and of at most `maxSessionBytes`.
[[nodiscard]] Result<std::string> unpackedScene(std::string_view packed);

/// Whether a text begins as each that `writeSession` writes.
[[nodiscard]] bool beginsAsSession(std::string_view text);

} // namespace halfspace
