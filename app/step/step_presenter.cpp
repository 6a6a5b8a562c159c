#include "app/step/step_presenter.h"

#include "app/panels/scene_column.h"
#include "app/panels/window_panels.h"
#include "widgets/lesson/lesson_page.h"
#include "widgets/numbers/inspector.h"
#include "widgets/view/case_line.h"
#include "widgets/view/flat_view.h"
#include "widgets/view/scene_view.h"
#include "widgets/working/working_practice.h"

namespace halfspace {

StepPresenter::StepPresenter(SessionModel &model, WindowPanels &panels, LearnerProgress &progress)
    : m_progress(progress), m_scene(panels.scene().view()), m_inspector(panels.inspector()),
      m_practice(panels.practice()), m_question(model, progress), m_atStart(model),
      m_turner(model, m_atStart), m_freshStart(model, panels.input(), m_question, progress),
      m_flight(model, panels.page().flight(), panels.messages()),
      m_page(model, panels.page(), panels.practice(), m_question, progress, m_atStart),
      m_case(model, panels.scene().caseLine(), m_scene, m_question, m_atStart),
      m_highlights(m_scene, panels.scene().flat(), panels.practice().working()) {
  connect(&panels.page(), &LessonPage::stepRequested, &m_turner, &StepTurner::turnTo);
  connect(&model, &SessionModel::stepChanged, this, &StepPresenter::showStep);
  connect(&model, &SessionModel::outcomeChanged, this, &StepPresenter::showOutcome);
  const WorkingPractice &practice = panels.practice();
  connect(&practice, &WorkingPractice::blanksChanged, this, &StepPresenter::showBesideLines);
  connect(&practice, &WorkingPractice::newNumbersRequested, this, [this] { m_freshStart.renewNumbers(); });
  connect(&panels.scene().caseLine(), &CaseLine::afreshChosen, this, [this] { m_freshStart.startOver(); });
  connect(&m_highlights, &MarkHighlights::markHovered, &m_flight, &FlightPresenter::showHovered);
  connect(&m_flight, &FlightPresenter::fragmentHovered, &m_highlights, &MarkHighlights::setFragment);
}

void StepPresenter::showAll() {
  m_page.showLesson();
  showStep();
  showOutcome();
}

void StepPresenter::showStep() {
  m_page.showStep();
  m_scene.handles().select({}); // its tools would stand in the next step's figure
  m_progress.ofStep().tasks.arrive();
}

void StepPresenter::showOutcome() {
  m_page.showLines();
  showBesideLines();
}

void StepPresenter::showBesideLines() {
  const bool hidden = m_question.isOpen() || m_practice.hasBlanks(); // until they are answered
  m_inspector.setResultsHidden(hidden);
  m_scene.drawn().setNumbersHidden(hidden);
  m_flight.setNumbersHidden(hidden);
  m_inspector.showSession();
  m_page.showWords(hidden);
  m_flight.show();
  m_case.show(hidden);
}

} // namespace halfspace
