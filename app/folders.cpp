#include "app/folders.h"

#include "lessons/files/descriptor.h"
#include "lessons/words.h"

#include <QDir>

#include <cerrno>
#include <filesystem>
#include <sys/stat.h>

namespace halfspace {

std::optional<Problem> makeFolder(const QString &folder) {
  constexpr mode_t ownerOnly = 0700;
  const QString path = QDir::cleanPath(folder);
  std::error_code error;
  if (std::filesystem::is_directory(path.toStdString(), error))
    return {};
  if (const QString above = QFileInfo(path).path(); above != path)
    if (auto problem = makeFolder(above))
      return problem;
  if (::mkdir(path.toStdString().c_str(), ownerOnly) == 0)
    return {};
  const int reason = errno;
  if (std::filesystem::is_directory(path.toStdString(), error)) // another program was quicker
    return {};
  return Problem{words("This folder cannot be made: {reason}.", {{"reason", reasonOf(reason)}}),
                 path.toStdString(), 0, ""};
}

} // namespace halfspace
