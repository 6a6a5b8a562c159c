#include "lessons/lesson/lesson_picture.h"

#include "lessons/files/read_file.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Whether a path is in a folder, both without links and dots.
bool isWithin(const std::filesystem::path &folder, const std::filesystem::path &path) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

} // namespace

Result<std::string> readLessonPicture(const std::filesystem::path &folder, std::string_view name) {
  std::error_code error;
  const auto home = std::filesystem::canonical(folder.empty() ? "." : folder, error);
  const auto picture = error ? home : std::filesystem::canonical(home / name, error);
  const std::string shown = shortened(name);
  if (error)
    return Problem{words("There is no picture “{name}” in the lesson's folder.", {{"name", shown}}), "", 0,
                   ""};
  if (!isWithin(home, picture))
    return Problem{words("The picture “{name}” is not in the lesson's folder.", {{"name", shown}}), "", 0,
                   ""};
  auto bytes = readFile(picture, maxPictureBytes);
  if (!bytes)
    return Problem{words("The picture “{name}” cannot be read. {reason}",
                         {{"name", shown}, {"reason", bytes.problem().sentence}}),
                   "", 0, ""};
  return bytes;
}

} // namespace halfspace
