// What the scene comes to, told in the case line, and the way to what is special close by.
#pragma once

#include "lessons/scene/near_special_cases.h"
#include "widgets/session_model.h"

#include <QObject>

#include <vector>

class QWidget;

namespace halfspace {

class CaseLine;
class StepAtStart;
class StepQuestion;

/// Writes the case line from the session, and goes where the learner wants to be taken.
class CasePresenter : public QObject {
  Q_OBJECT
public:
  /// `scene` is described by the same words for those who do not see it. All must outlive it.
  CasePresenter(SessionModel &model, CaseLine &line, QWidget &scene, const StepQuestion &question,
                StepAtStart &atStart);

  /// `numbersHidden`: until the question is answered, or blank lines are filled in.
  void show(bool numbersHidden);

private:
  [[nodiscard]] QString words(bool numbersHidden) const;
  void showNearby(bool numbersHidden);
  void goToNearby(int which);

  SessionModel &m_model;
  CaseLine &m_line;
  QWidget &m_scene;
  const StepQuestion &m_question;
  StepAtStart &m_atStart;
  std::vector<NearSpecialCase> m_nearby; ///< of what the step shows
};

} // namespace halfspace
