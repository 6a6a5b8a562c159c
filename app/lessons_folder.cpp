#include "app/lessons_folder.h"

namespace halfspace {

std::filesystem::path lessonsFolder() {
  std::error_code error;
  const auto executable = std::filesystem::read_symlink("/proc/self/exe", error);
  return executable.parent_path().parent_path() / "share" / "halfspace" / "lessons";
}

LessonLibrary allLessons(const std::vector<std::string> &ownFolders) {
  LessonLibrary library = readLessons(lessonsFolder());
  for (const std::string &folder : ownFolders)
    addOwnLessons(library, folder);
  return library;
}

} // namespace halfspace
