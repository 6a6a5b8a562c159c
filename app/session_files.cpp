#include "app/session_files.h"

#include "lessons/session_file.h"
#include "lessons/words.h"

#include <QSaveFile>

namespace halfspace {

std::optional<Problem> writeSessionFile(const Session &session, const QString &file) {
  QSaveFile out(file);
  const std::string text = writeSession(session);
  const bool written =
      out.open(QIODevice::WriteOnly) &&
      out.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size()) &&
      out.commit();
  if (written)
    return {};
  return Problem{
      words("The session could not be saved: {reason}.", {{"reason", out.errorString().toStdString()}}),
      file.toStdString(), 0, ""};
}

} // namespace halfspace
