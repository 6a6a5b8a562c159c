#include "app/work/known_file.h"

namespace halfspace {

std::optional<QString> absolutePathOf(const std::filesystem::path &file) {
  std::error_code error;
  const std::string whole = std::filesystem::absolute(file, error).lexically_normal().string();
  const QString path = QString::fromStdString(whole);
  return !error && path.toStdString() == whole ? std::optional(path) : std::nullopt;
}

} // namespace halfspace
