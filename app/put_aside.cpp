#include "app/put_aside.h"

#include "lessons/words.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace halfspace {

Result<QString> putAside(const QString &file) {
  const QFileInfo info(file);
  const auto named = [&info](const QString &count) {
    return info.dir().filePath(info.completeBaseName() + "-damaged" + count + "." + info.suffix());
  };
  QString aside = named({});
  for (int count = 2; QFileInfo(aside).exists() || QFileInfo(aside).isSymLink(); ++count)
    aside = named("-" + QString::number(count));
  QFile moved(file);
  if (moved.rename(aside))
    return aside;
  return Problem{words("This cannot be read, and cannot be put aside: {reason}.",
                       {{"reason", moved.errorString().toStdString()}}),
                 file.toStdString(), 0, ""};
}

} // namespace halfspace
