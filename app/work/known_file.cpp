#include "app/work/known_file.h"

#include "lessons/files/read_file.h"
#include "lessons/scene/file/session_file.h"

namespace halfspace {

bool mayReplace(const KnownFile &file, const std::string &text) {
  std::error_code error;
  if (!std::filesystem::exists(file.path.toStdString(), error) && !error)
    return true;
  const auto found = readFile(file.path.toStdString(), maxSessionBytes);
  return found && (*found == file.text || *found == text);
}

std::optional<QString> absolutePathOf(const std::filesystem::path &file) {
  std::error_code error;
  const std::string whole = std::filesystem::absolute(file, error).lexically_normal().string();
  const QString path = QString::fromStdString(whole);
  return !error && path.toStdString() == whole ? std::optional(path) : std::nullopt;
}

} // namespace halfspace
