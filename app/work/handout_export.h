// The lesson as a handout in a file.
#pragma once

#include "app/handout_file.h"
#include "app/panels/messages.h"

#include <QObject>

namespace halfspace {

class SessionModel;

/// Writes the lesson that is shown, with its scene as it is now. What was chosen is kept for the next time.
class HandoutExport : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  HandoutExport(const SessionModel &model, const Typesetter &typesetter, Messages messages,
                QObject *parent = nullptr);

  /// Asks what is to be in it and for a file, and writes it.
  void askAndSave();
  /// On failure says why and returns false.
  bool saveTo(const QString &file, const HandoutChoices &choices);

private:
  const SessionModel &m_model;
  const Typesetter &m_typesetter;
  Messages m_messages;
  HandoutChoices m_choices; ///< the last ones
};

} // namespace halfspace
