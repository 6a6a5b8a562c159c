// The pictures that a lesson's words name.
#pragma once

#include "lessons/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace halfspace {

inline constexpr std::size_t maxPictureBytes = 4U << 20U;

/// The bytes of a picture in a lesson's folder or a folder in it, of at most `maxPictureBytes`. A name that
/// leads out of the folder, be it by a link, is refused with a sentence, and nothing is read.
[[nodiscard]] Result<std::string> readLessonPicture(const std::filesystem::path &folder,
                                                    std::string_view name);

} // namespace halfspace
