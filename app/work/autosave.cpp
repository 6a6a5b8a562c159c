#include "app/work/autosave.h"

#include "app/panels/unfinished_input.h"
#include "app/work/learner_progress.h"
#include "app/work/session_files.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace halfspace {
namespace {

/// Unsaved work is kept so long after a change.
constexpr std::chrono::milliseconds keepDelay{800};

} // namespace

Autosave::Autosave(SessionModel &model, SessionFiles &files, const UnfinishedInput &input,
                   LearnerProgress &progress, Messages messages)
    : m_model(model), m_files(files), m_input(input), m_progress(progress), m_messages(messages) {
  m_timer.setSingleShot(true);
  m_timer.setInterval(keepDelay);
  connect(&m_timer, &QTimer::timeout, this, [this] {
    if (m_model.history().inGesture())
      keepSoon();
    else
      keepNow();
  });
  connect(&model.history(), &SessionHistory::cleanChanged, this, &Autosave::keepSoon);
  connect(&model.history(), &SessionHistory::stepsChanged, this, &Autosave::keepSoon);
  connect(&model, &SessionModel::outcomeChanged, this, &Autosave::keepSoon); // under the hand, too
  connect(&files, &SessionFiles::changed, this, &Autosave::keepSoon);
  connect(&input, &UnfinishedInput::typing, this, &Autosave::prepare);
  keepSoon(); // that nothing can be kept is to be said before much is done
}

bool Autosave::hasElsewhere() const {
  if (hasUnsaved(m_files.lessonWorks()))
    return true;
  const auto &left = m_model.leftSessions();
  return std::any_of(left.begin(), left.end(),
                     [this](const auto &each) { return each.first != m_model.session().lesson; });
}

UnsavedWork Autosave::work() const {
  return {m_model.session(), m_model.leftSessions(), m_files.belongsToFile() ? m_files.file() : nullptr,
          m_files.sharedLessonWorks()};
}

void Autosave::prepare() {
  const auto typed = m_input.typedChange();
  if (!typed && !m_files.hasChanges() && !hasElsewhere() &&
      !(m_model.history().inGesture() && isChanged(m_model)))
    return m_recovery.prepare({});
  UnsavedWork unsaved = work();
  if (typed)
    if (auto changed = apply(unsaved.session, *typed))
      unsaved.session = std::move(*changed);
  m_recovery.prepare(std::move(unsaved));
}

void Autosave::keepSoon() {
  prepare();
  if (!m_timer.isActive())
    m_timer.start();
}

std::optional<Problem> Autosave::keepNow() {
  m_timer.stop();
  std::optional<Problem> problem;
  if (m_files.hasChanges() || hasElsewhere())
    problem = m_recovery.keep(work());
  else
    m_recovery.forget();
  prepare(); // what is being typed is not kept before it is entered
  const std::optional<Problem> lesser = m_progress.keep();
  if (problem)
    m_messages.warn(tr("Unsaved work cannot be kept for the next start: save it to a file."),
                    QString::fromStdString(problem->text()));
  else if (lesser)
    m_messages.warn(tr("What you have done cannot be kept for the next start."),
                    QString::fromStdString(lesser->text()));
  else
    m_messages.warn({});
  return problem;
}

bool Autosave::keepForNextStart() {
  while (const auto problem = keepNow()) {
    // Only what is on the screen can be saved to a file.
    const bool canSave = m_files.hasChanges();
    const QString question =
        canSave ? tr("Unsaved work cannot be kept for the next start. Save it to a file?")
        : hasUnsaved(m_files.lessonWorks())
            ? tr("The lesson that you are writing cannot be kept for the next start. To keep it, cancel and "
                 "save it to a file.")
            : tr("Your changes in other lessons cannot be kept for the next start. To keep "
                 "them, cancel, open these lessons and save each to a file.");
    const QMessageBox::StandardButtons others = QMessageBox::Discard | QMessageBox::Cancel;
    const auto answer = m_messages.ask(
        QMessageBox::Warning, question + "\n" + QString::fromStdString(problem->text()),
        canSave ? others | QMessageBox::Save : others, canSave ? QMessageBox::Save : QMessageBox::Cancel);
    if (answer == QMessageBox::Discard) {
      m_recovery.forget(); // an older state of it must not come back
      return true;
    }
    if (answer != QMessageBox::Save || !m_files.saveAs())
      return false;
  }
  return true;
}

} // namespace halfspace
