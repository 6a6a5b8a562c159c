#include "app/folders.h"

#include "lessons/files/descriptor.h"
#include "lessons/words.h"

#include <QDir>

#include <cerrno>
#include <sys/stat.h>

namespace halfspace {

std::optional<Problem> makeFolder(const QString &folder) {
  constexpr mode_t ownerOnly = 0700;
  const QString path = QDir::cleanPath(folder);
  if (QDir(path).exists())
    return {};
  if (const QString above = QFileInfo(path).path(); above != path)
    if (auto problem = makeFolder(above))
      return problem;
  if (::mkdir(path.toStdString().c_str(), ownerOnly) == 0 || errno == EEXIST)
    return {};
  return Problem{words("This folder cannot be made: {reason}.", {{"reason", reasonOf(errno)}}),
                 path.toStdString(), 0, ""};
}

} // namespace halfspace
