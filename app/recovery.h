// Keeps unsaved work where a killed program cannot lose it.
#pragma once

#include "lessons/session.h"

#include <QString>
#include <QTimer>

namespace halfspace {

/// Writes the session to a file of its own a moment after each change. A program that ends in order removes
/// the file; one that finds it was preceded by one that did not.
class Recovery {
public:
  /// `file` may be empty: then nothing is kept.
  explicit Recovery(QString file = standardFile());

  /// The file in the user's data folder.
  [[nodiscard]] static QString standardFile();

  /// The session that an earlier run left behind, if it can be read.
  [[nodiscard]] std::optional<Session> leftBehind() const;
  /// Keeps this session soon.
  void keep(const Session &session);
  /// Keeps this session before the program ends.
  void keepNow(const Session &session);
  /// There is nothing unsaved any more.
  void forget();

private:
  void write();

  QString m_file;
  Session m_session;
  QTimer m_timer;
};

} // namespace halfspace
