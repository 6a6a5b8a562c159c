#include "app/step/fresh_start.h"

#include "app/panels/unfinished_input.h"
#include "app/step/step_question.h"
#include "app/work/learner_progress.h"
#include "lessons/lesson/new_numbers/new_numbers.h"
#include "widgets/session_model.h"

#include <QRandomGenerator>

#include <utility>

namespace halfspace {

void FreshStart::startOver() {
  m_input.drop();            // what was refused is gone too
  m_question.forgetAnswer(); // the next group in class begins anew
  m_progress.ofStep().tasks.beginAnew();
  replaceScene(m_model.lesson().scene, tr("Start over"));
}

void FreshStart::renewNumbers() {
  m_input.drop();                        // it was about the numbers that go
  m_question.forgetAnswer();             // so was the answer
  m_progress.ofStep().tasks.beginAnew(); // so were the tasks
  const auto &view = m_model.session().view;
  const glm::dvec3 from = view ? view->view.from : m_model.lesson().camera.from;
  // From the numbers of the lesson: special cases that were brought about would come again.
  const Scene scene = withNumbersOf(m_model.lesson().scene, m_model.session().scene);
  replaceScene(withNewNumbers(scene, m_model.step(), from, QRandomGenerator::global()->generate64()),
               tr("New numbers"));
}

void FreshStart::replaceScene(Scene scene, const QString &description) {
  m_model.history().replaceScene(std::move(scene), description);
  m_model.takeQuestion(); // if the scene was that one already
}

} // namespace halfspace
