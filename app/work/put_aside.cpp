#include "app/work/put_aside.h"

#include "app/standard_streams.h"
#include "lessons/words.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <utility>

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

std::optional<Problem> PutAsideFiles::add(const Problem &why) {
  const auto aside = putAside(QString::fromStdString(why.file));
  if (!aside)
    return aside.problem();
  m_sentences << tr("%1 It is put aside as %2.")
                     .arg(QString::fromStdString(why.text()), QFileInfo(*aside).fileName());
  printError(m_sentences.last().toStdString());
  return {};
}

QString PutAsideFiles::takeSentences() { return std::exchange(m_sentences, {}).join("\n"); }

} // namespace halfspace
