#include "widgets/session_model.h"

#include "lessons/lesson/new_numbers/new_numbers.h"
#include "lessons/lesson/task_targets.h"

#include <algorithm>
#include <utility>

namespace halfspace {

namespace {

Session startOf(const Lesson &lesson) { return {lesson.id, 0, lesson.scene}; }

/// Whether the scenes differ in the numbers of their objects alone.
bool haveSameEntries(const Scene &a, const Scene &b) {
  return std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(), b.entries.end(), areBuiltAlike);
}

} // namespace

SessionModel::SessionModel(LessonLibrary library, QObject *parent)
    : QObject(parent), m_library(std::move(library)) {
  startWith(startOf(m_library.lessons.front()));
}

void SessionModel::undo() {
  settleGesture();
  const Session before = session();
  showUndone(before, m_history.undo());
}

void SessionModel::redo() {
  settleGesture();
  const Session before = session();
  showUndone(before, m_history.redo());
}

void SessionModel::showUndone(const Session &before, const HistoryStep *step) {
  const bool replaces = step && step->replaces;
  showSince(before);
  if (replaces)
    emit sceneReplaced();
  tellHistory();
}

void SessionModel::setClean() {
  m_history.setClean();
  tellHistory();
}

void SessionModel::resetClean() {
  m_history.resetClean();
  tellHistory();
}

void SessionModel::clearHistory() {
  m_history.clear();
  tellHistory();
}

void SessionModel::tellHistory() {
  const std::pair steps(m_history.index(), m_history.count());
  const bool isOther = std::exchange(m_toldSteps, steps) != steps;
  if (std::exchange(m_toldClean, m_history.isClean()) != m_history.isClean())
    emit cleanChanged();
  if (isOther)
    emit historyChanged();
}

void SessionModel::startWith(Session session) {
  dropGesture();
  clearHistory();
  m_unknownLesson = Lesson{};
  m_unknownLesson.id = m_unknownLesson.title = session.lesson;
  m_unknownLesson.scene = session.scene;
  m_lesson = nullptr; // the same unknown lesson may begin with another scene
  show(std::move(session));
}

void SessionModel::setLibrary(LessonLibrary library) {
  settleGesture();
  const Lesson before = *m_lesson;
  // Whoever hears of the history below sees the lesson as it was: the library's own is gone by then.
  m_unknownLesson = before;
  m_lesson = &m_unknownLesson;
  m_library = std::move(library);
  const Lesson *now = m_library.find(before.id);
  Session renewed = session();
  if (now && (renewed.scene == before.scene || !haveSameEntries(now->scene, renewed.scene)))
    renewed.scene = now->scene;
  if (!(renewed.scene == session().scene))
    clearHistory();
  m_lesson = nullptr; // the same id may be another lesson now
  show(std::move(renewed));
}

void SessionModel::renewLesson(Lesson lesson) {
  LessonLibrary library = m_library;
  const auto same = std::find_if(library.lessons.begin(), library.lessons.end(),
                                 [&](const Lesson &each) { return each.id == lesson.id; });
  if (same != library.lessons.end())
    *same = std::move(lesson);
  setLibrary(std::move(library));
}

void SessionModel::openLesson(const std::string &id) {
  const Lesson *lesson = m_library.find(id);
  if (!lesson || id == session().lesson)
    return;
  settleGesture();
  if (isChanged())
    m_left[session().lesson] = session();
  else
    m_left.erase(session().lesson);
  const auto left = m_left.find(id);
  show(left == m_left.end() ? startOf(*lesson) : left->second);
  m_history.clear();
  resetClean();
}

void SessionModel::resetScene() {
  if (isChanged())
    replaceScene(m_lesson->scene, tr("Start over"));
}

void SessionModel::renewNumbers(std::uint64_t seed) {
  const glm::dvec3 from = session().view ? session().view->view.from : m_lesson->camera.from;
  // From the numbers of the lesson: special cases that were brought about would come again.
  const Scene scene = withNumbersOf(m_lesson->scene, session().scene);
  replaceScene(withNewNumbers(scene, step(), from, seed), tr("New numbers"));
}

void SessionModel::replaceScene(Scene scene, const QString &description) {
  settleGesture();
  const Session before = session();
  m_history.replaceScene(std::move(scene), description.toStdString());
  showSince(before);
  if (!(session() == before))
    emit sceneReplaced();
  tellHistory();
}

int SessionModel::lastStep() const { return std::max(0, static_cast<int>(m_lesson->steps.size()) - 1); }

void SessionModel::setStep(int step) {
  settleGesture();
  Session there = session();
  there.step = std::clamp(step, 0, lastStep());
  show(std::move(there));
}

void SessionModel::setView(const std::optional<ChosenView> &view) {
  Session seen = session();
  seen.view = view;
  m_history.goTo(std::move(seen));
}

std::vector<SnapTarget> SessionModel::askedOf(const Handle &handle) const {
  return m_stage == Stage() ? taskTargets(tasksOf(step()), session().scene, handle)
                            : std::vector<SnapTarget>();
}

QString SessionModel::editTogether(const std::vector<Edit> &edits, const QString &description) {
  settleGesture();
  const Session before = session();
  if (const auto refused = m_history.edit(edits, description.toStdString()))
    return QString::fromStdString(refused->sentence);
  showSince(before);
  tellHistory();
  return {};
}

GestureToken SessionModel::beginGesture(const QString &description) {
  settleGesture();
  const GestureToken token = m_history.beginGesture(description.toStdString());
  emit gestureChanged(); // whoever hears it may begin another
  return token;
}

void SessionModel::moveGesture(GestureToken token, const Edit &edit) {
  const Session before = session();
  if (m_history.moveGesture(token, edit))
    showSince(before);
}

void SessionModel::endGesture(GestureToken token) {
  if (isHeldBy(token))
    finishGesture(token);
}

void SessionModel::cancelGesture(GestureToken token) {
  if (!isHeldBy(token))
    return;
  const Session before = session();
  m_history.rewindGesture(token);
  showSince(before); // first: whoever hears that the gesture has ended sees what is left of it
  finishGesture(token);
}

void SessionModel::settleGesture() {
  if (!inGesture())
    return;
  finishGesture(m_history.holder());
  emit gestureSettled();
}

void SessionModel::dropGesture() {
  if (!inGesture())
    return;
  m_history.dropGesture();
  emit gestureChanged();
  emit gestureSettled();
}

void SessionModel::finishGesture(GestureToken token) {
  m_history.endGesture(token);
  if (takeStage())
    emit outcomeChanged();
  emit gestureChanged();
  tellHistory();
}

bool SessionModel::takeStage() {
  if (inGesture())
    return false;
  const Stage before =
      std::exchange(m_stage, stageOf(session().scene, boundObjectsOf(session().scene, m_evaluation)));
  return !(m_stage == before);
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
    within.step = std::clamp(within.step, 0, lastStep());
    m_history.goTo(std::move(within));
  }
  if (otherScene || otherLesson) {
    m_evaluation = evaluate(session().scene, m_evaluation);
    m_figure = figureOf(m_evaluation);
    takeStage();
  }
  takeShown();
  if (otherLesson)
    emit lessonChanged();
  if (otherStep)
    emit stepChanged();
  emit outcomeChanged();
}

const LessonStep &SessionModel::step() const { return stepOf(*m_lesson, session().step); }

void SessionModel::takeShown() { m_shown = shownIn(step(), m_evaluation, m_figure, m_question); }

void SessionModel::setQuestion(Question question) {
  if (question == m_question)
    return;
  m_question = question;
  takeShown();
  emit outcomeChanged();
}

} // namespace halfspace
