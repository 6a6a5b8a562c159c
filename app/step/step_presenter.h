// The step that is shown, in all panels at once.
#pragma once

#include "app/step/case_presenter.h"
#include "app/step/flight_presenter.h"
#include "app/step/fresh_start.h"
#include "app/step/mark_highlights.h"
#include "app/step/page_presenter.h"
#include "app/step/step_at_start.h"
#include "app/step/step_question.h"
#include "app/step/step_turner.h"

namespace halfspace {

class Inspector;
class WindowPanels;
class WorkingPractice;

/// Writes the lines, the numbers, the words, the flight and the case line at every change of the session, in
/// this order; the scene, the flat picture and the card of numbers follow the session themselves. Each part
/// of it shows one thing.
class StepPresenter : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  StepPresenter(SessionModel &model, WindowPanels &panels, LearnerProgress &progress);

  /// Shows the session as it stands there: for the first time.
  void showAll();

  [[nodiscard]] StepQuestion &question() { return m_question; }
  [[nodiscard]] FreshStart &freshStart() { return m_freshStart; }
  [[nodiscard]] StepTurner &turner() { return m_turner; }
  [[nodiscard]] PagePresenter &page() { return m_page; }
  [[nodiscard]] FlightPresenter &flight() { return m_flight; }
  [[nodiscard]] MarkHighlights &highlights() { return m_highlights; }

private:
  void showStep();
  void showOutcome();
  /// All but the lines, which have blanks of their own that hide it or show it.
  void showBesideLines();

  LearnerProgress &m_progress;
  SceneView &m_scene;
  Inspector &m_inspector;
  const WorkingPractice &m_practice;
  StepQuestion m_question;
  StepAtStart m_atStart;
  StepTurner m_turner;
  FreshStart m_freshStart;
  FlightPresenter m_flight;
  PagePresenter m_page;
  CasePresenter m_case;
  MarkHighlights m_highlights;
};

} // namespace halfspace
