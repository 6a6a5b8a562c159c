// The file that a session or a lesson stands in.
#pragma once

#include <QString>

#include <filesystem>
#include <optional>
#include <string>

namespace halfspace {

/// The file that is written when somebody saves, as it was when this program last read or wrote it.
struct KnownFile {
  QString path;       ///< absolute
  std::string text;   ///< what stood in it
  std::string lesson; ///< the lesson of its session, or the lesson itself
  bool operator==(const KnownFile &) const = default;
};

/// Whether nothing is lost by writing a text to the file: it is gone, as it was when it was last read or
/// written here, or holds that text already.
[[nodiscard]] bool mayReplace(const KnownFile &file, const std::string &text);

/// The path from the root to a file; nothing where none can be told: the working folder is gone, or the path
/// is not UTF-8. As a QString that would be another file's.
[[nodiscard]] std::optional<QString> absolutePathOf(const std::filesystem::path &file);

} // namespace halfspace
