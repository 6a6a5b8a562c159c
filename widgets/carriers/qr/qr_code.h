// A session as a QR code, so that a printed figure can be opened again from a photograph.
#pragma once

#include "lessons/result.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace halfspace {

/// A square of dark and light modules. It is read where it is dark on light, and where the quiet zone around
/// it is light as well.
struct QrCode {
  int side = 0;              ///< how many modules a row has, and how many rows there are
  std::vector<bool> modules; ///< row by row from the top left corner; true: dark

  [[nodiscard]] bool isDark(int column, int row) const {
    return modules[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
                   static_cast<std::size_t>(column)];
  }
  bool operator==(const QrCode &) const = default;
};

/// The quiet zone is so many modules wide (ISO/IEC 18004).
inline constexpr int quietModules = 4;

/// The side of a module on paper.
inline constexpr double moduleMillimetres = 0.4;

/// The side of a code on paper, with its quiet zone.
[[nodiscard]] constexpr double millimetresOf(const QrCode &code) {
  return (code.side + 2 * quietModules) * moduleMillimetres;
}

/// The smallest code with error correction M (up to 15 % of it may be unreadable) for the text of a session,
/// and with more error correction where that makes it no larger. The same text gives the same code. A
/// sentence where it is too long (`mostBytesInCode`).
[[nodiscard]] Result<QrCode> qrCodeOf(std::string_view session);

} // namespace halfspace
