// Unsaved work, kept while it is made.
#pragma once

#include "app/panels/messages.h"
#include "app/work/recovery.h"
#include "widgets/session_model.h"

#include <QTimer>

namespace halfspace {

class LearnerProgress;
class SessionFiles;
class UnfinishedInput;

/// Keeps what is unsaved, and what the learner has done, a moment after each change, so that the next start
/// finds it whatever ends this one.
class Autosave : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  Autosave(SessionModel &model, SessionFiles &files, const UnfinishedInput &input, LearnerProgress &progress,
           Messages messages);

  /// A moment after a change, and never during a drag: the disk is waited for.
  void keepSoon();
  /// Keeps what is unsaved, or drops what was kept when nothing is. Why it cannot be kept, which the case
  /// line says as long as it holds.
  std::optional<Problem> keepNow();
  /// What the next start should find is kept for it, saved to a file, or given up on purpose. False where the
  /// user wants to stay.
  [[nodiscard]] bool keepForNextStart();
  /// Keeps the scene as it is shown, not what is typed and not entered; from any thread.
  [[nodiscard]] std::optional<Problem> keepWhileBusy() { return m_recovery.keepPrepared(); }

  [[nodiscard]] Recovery &recovery() { return m_recovery; }

private:
  /// For the end of the program at any moment from now on: what is unsaved, and what is being typed.
  void prepare();
  /// Whether changed sessions of other lessons, or lessons that are being written, wait to be gone on with.
  [[nodiscard]] bool hasElsewhere() const;
  [[nodiscard]] UnsavedWork work() const;

  SessionModel &m_model;
  SessionFiles &m_files;
  const UnfinishedInput &m_input;
  LearnerProgress &m_progress;
  Messages m_messages;
  Recovery m_recovery;
  QTimer m_timer; ///< runs from a change until it is kept
};

} // namespace halfspace
