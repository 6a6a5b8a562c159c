#include "app/step/page_presenter.h"

#include "app/step/step_at_start.h"
#include "app/step/step_question.h"
#include "app/work/learner_progress.h"
#include "lessons/lesson/live_values.h"
#include "widgets/lesson/lesson_page.h"
#include "widgets/working/working_practice.h"

#include <algorithm>

namespace halfspace {

PagePresenter::PagePresenter(SessionModel &model, LessonPage &page, WorkingPractice &practice,
                             StepQuestion &question, LearnerProgress &progress, StepAtStart &atStart)
    : m_model(model), m_page(page), m_practice(practice), m_question(question), m_progress(progress),
      m_atStart(atStart) {
  practice.working().setWholeWorking([&model] { return workingOf(model.evaluation()); });
  connect(&page, &LessonPage::nextLessonRequested, this, &PagePresenter::openNextLesson);
  connect(&page, &LessonPage::predictionChosen, &question, &StepQuestion::answer);
  connect(&page, &LessonPage::predictionReopened, &question, &StepQuestion::reopen);
  connect(&model, &SessionModel::lessonChanged, this, &PagePresenter::showLesson);
  connect(&model.history(), &SessionHistory::gestureChanged, this, &PagePresenter::followGesture);
}

void PagePresenter::showLesson() {
  m_glossary = Glossary(m_model.library());
  m_page.setLesson(m_model.lesson());
  m_practice.offerNewNumbers(!isExplore(m_model)); // a scene of one's own keeps its numbers
  const Lesson *next = nextLesson();
  m_page.setNextLesson(next ? QString::fromStdString(next->title) : QString());
}

void PagePresenter::showStep() { m_page.showStep(m_model.step(), m_model.session().step, m_glossary); }

void PagePresenter::showLines() {
  m_practice.setStep(m_model.session().lesson, m_model.session().step, m_model.step().blank);
  // Which lines there are would tell what is asked: the open question has those of the lesson's own numbers.
  const bool isOpen = m_question.isOpen();
  const LinesOfStep &lines = isOpen && isChanged(m_model) ? m_atStart.lines() : m_model.shown();
  m_practice.setWorking(lines.working, lines.linesIn, isOpen);
}

void PagePresenter::showWords(bool numbersHidden) {
  const LiveValues shown = numbersHidden ? LiveValues::Hidden : LiveValues::Shown;
  m_page.showWords([this, shown](const std::string &name) {
    return liveValue(name, m_model.session().scene, m_model.evaluation(), shown);
  });
  if (!m_model.history().inGesture()) // what is only passed in a drag does not count
    judge();
}

void PagePresenter::judge() {
  if (m_question.isOpen()) { // whether a task holds would give the answer away
    m_page.setAnswer({});
    m_page.setTaskStates({});
    return;
  }
  const LessonStep &step = m_model.step();
  StepProgress &done = m_progress.ofStep();
  done.tasks.observe(tasksOf(step), m_model.evaluation());
  if (const Prediction *question = predictionOf(step)) // first: it may grow, and push the tasks down
    m_page.setAnswer(
        GivenAnswer{*done.chosen, done.right, rightChoice(*question, m_model.evaluation()) == done.right});
  m_page.setTaskStates(done.tasks.states());
}

void PagePresenter::followGesture() {
  m_page.setHeld(m_model.history().inGesture());
  if (!m_model.history().inGesture())
    judge();
}

const Lesson *PagePresenter::nextLesson() const {
  const std::vector<Lesson> &lessons = m_model.library().lessons;
  const auto shown = std::find_if(lessons.begin(), lessons.end(), [this](const Lesson &lesson) {
    return lesson.id == m_model.session().lesson;
  });
  return shown == lessons.end() || shown + 1 == lessons.end() ? nullptr : &*(shown + 1);
}

void PagePresenter::openNextLesson() {
  if (const Lesson *next = nextLesson())
    m_model.openLesson(next->id);
}

} // namespace halfspace
