// Files of the program's own that cannot be read any more.
#pragma once

#include "lessons/result.h"

#include <QCoreApplication>
#include <QStringList>

#include <optional>

namespace halfspace {

/// Gives a file another name beside it, so that nothing is written over what may still be in it:
/// progress.json becomes progress-damaged.json, or progress-damaged-2.json where something has that name. The
/// new path.
[[nodiscard]] Result<QString> putAside(const QString &file);

/// The files that were put aside and that the user has not been told of.
class PutAsideFiles {
  Q_DECLARE_TR_FUNCTIONS(halfspace::PutAsideFiles)
public:
  /// Puts aside the file that could not be read, and says so on standard error; why it cannot be put aside.
  std::optional<Problem> add(const Problem &why);
  /// What is to be told, a line for each file, and only once; empty for nothing.
  [[nodiscard]] QString takeSentences();

private:
  QStringList m_sentences;
};

} // namespace halfspace
