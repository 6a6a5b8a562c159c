#include "widgets/session_model.h"

#include "lessons/lesson/new_numbers/new_numbers.h"
#include "lessons/lesson/task_targets.h"

#include <QUndoCommand>

#include <algorithm>
#include <utility>

namespace halfspace {

/// Two sessions of a lesson, before and after. Going from one to the other keeps the step that is shown.
class SessionCommand : public QUndoCommand {
public:
  /// `replaces`: what was in view may be somewhere else altogether.
  SessionCommand(SessionModel &model, Session before, Session after, const QString &description,
                 bool replaces)
      : QUndoCommand(description), m_model(model), m_before(std::move(before)), m_after(std::move(after)),
        m_replaces(replaces) {}

  void undo() override { go(m_before); }
  void redo() override { go(m_after); }

private:
  void go(Session session) {
    session.step = m_model.session().step;
    session.view = m_model.session().view;
    m_model.show(session);
    if (m_replaces)
      emit m_model.sceneReplaced();
  }

  SessionModel &m_model;
  Session m_before;
  Session m_after;
  bool m_replaces;
};

namespace {

Session startOf(const Lesson &lesson) { return {lesson.id, 0, lesson.scene}; }

/// Whether the scenes differ in the numbers of their objects alone.
bool haveSameEntries(const Scene &a, const Scene &b) {
  const auto areAlike = [](const Entry &x, const Entry &y) {
    const auto *first = std::get_if<Object>(&x.content);
    const auto *second = std::get_if<Object>(&y.content);
    const bool sameContent = first && second
                                 ? &first->kind() == &second->kind() && first->size() == second->size()
                                 : x.content == y.content;
    return x.name == y.name && x.on == y.on && sameContent;
  };
  return std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(), b.entries.end(), areAlike);
}

} // namespace

SessionModel::SessionModel(LessonLibrary library, QObject *parent)
    : QObject(parent), m_library(std::move(library)) {
  startWith(startOf(m_library.lessons.front()));
}

void SessionModel::undo() {
  settleGesture();
  m_history.undo();
}

void SessionModel::redo() {
  settleGesture();
  m_history.redo();
}

void SessionModel::startWith(Session session) {
  dropGesture();
  m_history.clear();
  m_history.setClean(); // clear alone leaves a history without a clean state as it was
  m_unknownLesson = Lesson{};
  m_unknownLesson.id = m_unknownLesson.title = session.lesson;
  m_unknownLesson.scene = session.scene;
  m_lesson = nullptr; // the same unknown lesson may begin with another scene
  show(session);
}

void SessionModel::setLibrary(LessonLibrary library) {
  settleGesture();
  const Lesson before = *m_lesson;
  // Whoever hears of the history below sees the lesson as it was: the library's own is gone by then.
  m_unknownLesson = before;
  m_lesson = &m_unknownLesson;
  m_library = std::move(library);
  const Lesson *now = m_library.find(before.id);
  Session session = m_session;
  if (now && (session.scene == before.scene || !haveSameEntries(now->scene, session.scene)))
    session.scene = now->scene;
  if (!(session.scene == m_session.scene)) {
    m_history.clear();
    m_history.setClean();
  }
  m_lesson = nullptr; // the same id may be another lesson now
  show(session);
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
  if (!lesson || id == m_session.lesson)
    return;
  settleGesture();
  if (isChanged())
    m_left[m_session.lesson] = m_session;
  else
    m_left.erase(m_session.lesson);
  const auto left = m_left.find(id);
  show(left == m_left.end() ? startOf(*lesson) : left->second);
  m_history.clear();
  m_history.resetClean();
}

void SessionModel::resetScene() {
  if (isChanged())
    replaceScene(m_lesson->scene, tr("Start over"));
}

void SessionModel::renewNumbers(std::uint64_t seed) {
  const glm::dvec3 from = m_session.view ? m_session.view->view.from : m_lesson->camera.from;
  // From the numbers of the lesson: special cases that were brought about would come again.
  const Scene scene = withNumbersOf(m_lesson->scene, m_session.scene);
  replaceScene(withNewNumbers(scene, step(), from, seed), tr("New numbers"));
}

void SessionModel::replaceScene(Scene scene, const QString &description) {
  settleGesture();
  const Session before = m_session;
  Session after = m_session;
  after.scene = std::move(scene);
  show(after);
  if (!(m_session == before))
    record(before, description, true);
}

int SessionModel::lastStep() const { return std::max(0, static_cast<int>(m_lesson->steps.size()) - 1); }

void SessionModel::setStep(int step) {
  settleGesture();
  Session session = m_session;
  session.step = std::clamp(step, 0, lastStep());
  if (session.step != m_session.step)
    show(session);
}

std::vector<SnapTarget> SessionModel::askedOf(const Handle &handle) const {
  return m_stage == Stage() ? taskTargets(tasksOf(step()), m_session.scene, handle)
                            : std::vector<SnapTarget>();
}

QString SessionModel::editTogether(const std::vector<Edit> &edits, const QString &description) {
  settleGesture();
  const Session before = m_session;
  Session after = m_session;
  for (const Edit &edit : edits) {
    auto edited = apply(std::move(after), edit);
    if (!edited)
      return QString::fromStdString(edited.problem().sentence);
    after = std::move(*edited);
  }
  show(after);
  if (!(m_session == before))
    record(before, description);
  return {};
}

GestureToken SessionModel::beginGesture(const QString &description) {
  settleGesture();
  const auto token = static_cast<GestureToken>(static_cast<std::uint64_t>(m_holder) + 1);
  m_holder = token;
  m_gesture = {m_session, description};
  emit gestureChanged(); // whoever hears it may begin another
  return token;
}

void SessionModel::moveGesture(GestureToken token, const Edit &edit) {
  if (!isHeldBy(token))
    return;
  if (const auto moved = apply(m_session, edit); moved && !(*moved == m_session))
    show(*moved);
}

void SessionModel::endGesture(GestureToken token) {
  if (!isHeldBy(token))
    return;
  const Gesture ended = *m_gesture;
  finishGesture();
  if (!(m_session == ended.before))
    record(ended.before, ended.description);
}

void SessionModel::cancelGesture(GestureToken token) {
  if (!isHeldBy(token))
    return;
  Session before = m_gesture->before;
  before.view = m_session.view;
  show(before); // first: whoever hears that the gesture has ended sees what is left of it
  finishGesture();
}

bool SessionModel::isMovedByGesture(const std::string &object) const {
  if (!m_gesture)
    return false;
  const Object *before = findObject(m_gesture->before.scene, object);
  const Object *now = findObject(m_session.scene, object);
  return before && now && !(*before == *now);
}

void SessionModel::settleGesture() {
  if (!inGesture())
    return;
  endGesture(m_holder);
  emit gestureSettled();
}

void SessionModel::dropGesture() {
  if (!inGesture())
    return;
  m_gesture.reset();
  emit gestureChanged();
  emit gestureSettled();
}

void SessionModel::finishGesture() {
  m_gesture.reset();
  if (takeStage())
    emit outcomeChanged();
  emit gestureChanged();
}

bool SessionModel::takeStage() {
  if (inGesture())
    return false;
  const Stage before =
      std::exchange(m_stage, stageOf(m_session.scene, boundObjectsOf(m_session.scene, m_evaluation)));
  return !(m_stage == before);
}

void SessionModel::record(const Session &before, const QString &description, bool replaces) {
  // Pushing runs redo, which shows the session that is shown already.
  m_history.push(new SessionCommand(*this, before, m_session, description, replaces));
}

void SessionModel::show(const Session &session) {
  const bool otherLesson = !m_lesson || session.lesson != m_session.lesson;
  const bool otherStep = otherLesson || session.step != m_session.step;
  const bool otherScene = !m_lesson || !(session.scene == m_session.scene);
  if (!otherLesson && !otherStep && !otherScene)
    return;
  m_session = session;
  if (otherLesson) {
    const Lesson *known = m_library.find(session.lesson);
    m_lesson = known ? known : &m_unknownLesson;
    m_session.step = std::clamp(m_session.step, 0, lastStep());
  }
  if (otherScene || otherLesson) {
    m_evaluation = evaluate(m_session.scene, m_evaluation);
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

const LessonStep &SessionModel::step() const { return stepOf(*m_lesson, m_session.step); }

void SessionModel::takeShown() { m_shown = shownIn(step(), m_evaluation, m_figure, m_question); }

void SessionModel::setQuestion(Question question) {
  if (question == m_question)
    return;
  m_question = question;
  takeShown();
  emit outcomeChanged();
}

} // namespace halfspace
