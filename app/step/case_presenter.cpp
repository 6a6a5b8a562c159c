#include "app/step/case_presenter.h"

#include "app/step/step_at_start.h"
#include "app/step/step_question.h"
#include "lessons/lesson/short_move.h"
#include "widgets/text/unbroken.h"
#include "widgets/view/case_line.h"

namespace halfspace {

CasePresenter::CasePresenter(SessionModel &model, CaseLine &line, QWidget &scene,
                             const StepQuestion &question, StepAtStart &atStart)
    : m_model(model), m_line(line), m_scene(scene), m_question(question), m_atStart(atStart) {
  connect(&line, &CaseLine::nearbyChosen, this, &CasePresenter::goToNearby);
  connect(&model.history(), &SessionHistory::stepsChanged, &line, &CaseLine::endMessage); // it is of the past
  connect(&model.history(), &SessionHistory::gestureChanged, this, [this] {
    if (m_model.history().inGesture())
      m_line.endMessage();
  });
}

void CasePresenter::show(bool numbersHidden) {
  const QString said = words(numbersHidden);
  m_line.setCase(said, m_model.shown().degenerate && !numbersHidden);
  m_scene.setAccessibleDescription(said);
  m_line.offerAfresh(!m_question.isOpen() && m_atStart.lacksLines());
  showNearby(numbersHidden);
}

QString CasePresenter::words(bool numbersHidden) const {
  if (m_question.isOpen())
    return tr("Answer the question first: the numbers are hidden until you do.");
  if (numbersHidden)
    return tr("Fill in the blank lines: other numbers are hidden until you do.");
  return unbroken(QString::fromStdString(m_model.shown().description));
}

void CasePresenter::showNearby(bool numbersHidden) {
  m_nearby.clear();
  if (numbersHidden)
    return m_line.setNearby({}, {});
  std::set<std::string> entries;
  for (const WorkingLine &line : m_model.shown().working.lines)
    entries.insert(entryOf(line.id));
  m_nearby = specialCasesNear(m_model.session().scene, m_model.evaluation(), entries);
  if (m_nearby.empty())
    return m_line.setNearby({}, {});
  std::vector<NearbyCase> cases;
  for (const NearSpecialCase &near : m_nearby)
    cases.push_back({unbroken(QString::fromStdString(near.sentence)), near.change.has_value()});
  const QString nearest = tr("Close by: %1").arg(cases.front().words);
  m_line.setNearby(
      cases.front().canBeReached ? nearest : tr("%1 There, coordinates have roots.").arg(nearest), cases);
}

void CasePresenter::goToNearby(int which) {
  const NearSpecialCase near = m_nearby.at(static_cast<std::size_t>(which));
  const Rational step = m_model.snapping().step * m_model.stage().unit();
  if (const QString refused = m_model.history().edit(shortMoveTo(near, m_model.session().scene, step),
                                                     tr("Go to the special case"));
      !refused.isEmpty())
    m_line.say(refused);
}

} // namespace halfspace
