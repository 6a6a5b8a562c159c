// The session in a file, which is one itself, a picture that carries one, or a photograph of its QR code.
#pragma once

#include "lessons/result.h"
#include "lessons/scene/session.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace halfspace {

/// Larger files are not read as pictures.
inline constexpr std::size_t mostPictureBytes = 64U << 20U;

struct FoundSession {
  Session session;
  std::string text; ///< as a .halfspace file has it
  bool isInPicture = false;
};

/// Reads a .halfspace file or a picture, which is told by how it begins. From a stranger's hands: the session
/// in a picture is read as that in a file of its own, within the same limits. In pictures of pixels that
/// carry none a QR code is looked for.
[[nodiscard]] Result<FoundSession> findSession(const std::filesystem::path &file);

/// The same of what a file holds, or a clipboard; problems name the file, which may be empty.
[[nodiscard]] Result<FoundSession> findSessionIn(std::string content, const std::string &file);

} // namespace halfspace
