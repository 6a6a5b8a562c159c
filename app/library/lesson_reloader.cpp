#include "app/library/lesson_reloader.h"

#include "app/check.h"
#include "widgets/session_model.h"

#include <utility>

namespace halfspace {

LessonReloader::LessonReloader(SessionModel &model, Messages messages, QObject *parent)
    : QObject(parent), m_model(model), m_messages(messages) {
  connect(&model, &SessionModel::lessonChanged, this, &LessonReloader::watch);
  connect(&m_watch, &LessonWatch::changed, this, &LessonReloader::reload);
  watch();
}

void LessonReloader::watch() { m_watch.watch(m_model.lesson().file, m_model.lesson().text); }

void LessonReloader::reload(const Result<std::string> &text) {
  auto lesson = text ? parseLesson(*text, m_model.lesson().file) : Result<Lesson>(text.problem());
  if (!lesson)
    return m_messages.say(QString::fromStdString(lesson.problem().text()));
  if (lesson->id != m_model.lesson().id)
    return m_messages.say(tr("The lesson has another id now: it is read at the next start."));
  const std::vector<Problem> problems = problemsIn(*lesson);
  LessonLibrary library = m_model.library();
  library.put(std::move(*lesson));
  m_model.setLibrary(std::move(library));
  m_messages.say(problems.empty() ? tr("The lesson's file has changed: it is read anew.")
                                  : QString::fromStdString(problems.front().text()));
}

} // namespace halfspace
