#include "app/step/fresh_start.h"

#include "app/panels/unfinished_input.h"
#include "app/step/step_question.h"
#include "app/work/learner_progress.h"
#include "widgets/session_model.h"

#include <QRandomGenerator>

namespace halfspace {

void FreshStart::startOver() {
  m_input.drop();      // what was refused is gone too
  m_question.reopen(); // the next group in class begins anew
  m_model.resetScene();
}

void FreshStart::renewNumbers() {
  m_input.drop();                     // it was about the numbers that go
  m_question.reopen();                // so was the answer
  m_progress.ofStep().tasks.arrive(); // other numbers are no deed of the learner
  m_model.renewNumbers(QRandomGenerator::global()->generate64());
}

} // namespace halfspace
