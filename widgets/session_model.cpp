#include "widgets/session_model.h"

#include "lessons/lesson/lesson_start.h"
#include "lessons/lesson/nearest_step.h"
#include "lessons/lesson/task_targets.h"

#include <algorithm>
#include <utility>

namespace halfspace {

SessionModel::SessionModel(LessonLibrary library, Session first)
    : m_library(std::move(library)), m_exploreStep(stepShowing({})) {
  connect(&m_history, &SessionHistory::sceneChanged, this, [this](const Session &before, bool replaced) {
    showSince(before);
    if (replaced)
      emit sceneReplaced();
  });
  connect(&m_history, &SessionHistory::gestureEnded, this, [this] {
    if (m_scene.takeStage(session().scene))
      emit outcomeChanged();
  });
  startWith(std::move(first));
}

SessionModel::SessionModel(const LessonLibrary &library)
    : SessionModel(library, startOf(library.lessons.front())) {}

void SessionModel::startWith(Session session, std::optional<LessonLibrary> library) {
  m_history.dropGesture();
  if (library) {
    keepLesson();
    m_library = std::move(*library);
  }
  m_history.beginAnew(true);
  m_unknownLesson = Lesson{};
  m_unknownLesson.id = m_unknownLesson.title = session.lesson;
  m_unknownLesson.scene = session.scene;
  m_lesson = nullptr; // the same unknown lesson may begin with another scene
  show(std::move(session));
}

void SessionModel::keepLesson() {
  if (m_lesson != &m_unknownLesson)
    m_unknownLesson = *m_lesson;
  m_lesson = &m_unknownLesson;
}

void SessionModel::setLibrary(LessonLibrary library) {
  m_history.settleGesture();
  keepLesson();
  const Lesson &before = *m_lesson;
  m_library = std::move(library);
  const Lesson *now = m_library.find(before.id);
  Session renewed = session();
  if (now && !isExplore(*this) &&
      (renewed.scene == before.scene || !areBuiltAlike(now->scene, renewed.scene)))
    renewed.scene = now->scene;
  if (!(renewed.scene == session().scene))
    m_history.beginAnew(true);
  m_lesson = nullptr; // the same id may be another lesson now
  show(std::move(renewed));
}

void SessionModel::openLesson(const std::string &id) {
  const Lesson *lesson = m_library.find(id);
  if (!lesson || id == session().lesson)
    return;
  m_history.settleGesture();
  if (isChanged(*this))
    m_left[session().lesson] = session();
  else
    m_left.erase(session().lesson);
  const auto left = m_left.find(id);
  show(left == m_left.end() ? startOf(*lesson) : left->second);
  m_history.beginAnew(false);
}

void SessionModel::setStep(int step) {
  m_history.settleGesture();
  Session there = session();
  there.step = nearestStep(*m_lesson, step);
  show(std::move(there));
}

void SessionModel::show(Session session) {
  const Session before = m_history.session();
  m_history.goTo(std::move(session));
  showSince(before);
}

void SessionModel::showSince(const Session &before) {
  const bool otherLesson = !m_lesson || session().lesson != before.lesson;
  const bool otherStep = otherLesson || session().step != before.step;
  const bool otherScene = !m_lesson || !(session().scene == before.scene);
  if (!otherLesson && !otherStep && !otherScene)
    return;
  if (otherLesson) {
    const Lesson *known = m_library.find(session().lesson);
    m_lesson = known ? known : &m_unknownLesson;
    Session within = session();
    within.step = nearestStep(*m_lesson, within.step);
    m_history.goTo(std::move(within));
  }
  if (otherScene || otherLesson) {
    m_scene.evaluate(session().scene);
    if (!m_history.inGesture())
      m_scene.takeStage(session().scene);
  }
  m_scene.takeStep(step(), m_questionOf());
  if (otherLesson)
    emit lessonChanged();
  if (otherStep)
    emit stepChanged();
  emit outcomeChanged();
}

const LessonStep &SessionModel::step() const {
  return isExplore(*this) ? m_exploreStep : stepOf(*m_lesson, session().step);
}

bool SessionModel::showWorkings(const std::vector<std::string> &constructions) {
  LessonStep step = stepShowing(constructions);
  const auto idsOf = [](const LessonStep &each) { return std::get<StepLines>(each.blocks.front()).ids; };
  if (idsOf(step) == idsOf(m_exploreStep))
    return false;
  m_exploreStep = std::move(step);
  if (isExplore(*this)) {
    m_scene.takeStep(m_exploreStep, m_questionOf());
    emit outcomeChanged();
  }
  return true;
}

void SessionModel::setQuestionOf(std::function<Question()> questionOf) {
  m_questionOf = std::move(questionOf);
  takeQuestion();
}

void SessionModel::takeQuestion() {
  const Question question = m_questionOf();
  if (question == m_scene.question())
    return;
  m_scene.takeStep(step(), question);
  emit outcomeChanged();
}

std::vector<SnapTarget> askedOf(const SessionModel &model, const Handle &handle) {
  return model.stage() == Stage() ? taskTargets(tasksOf(model.step()), model.session().scene, handle)
                                  : std::vector<SnapTarget>();
}

} // namespace halfspace
