#include "widgets/shown_scene.h"

#include <utility>

namespace halfspace {

void ShownScene::evaluate(const Scene &scene) {
  m_evaluation = halfspace::evaluate(scene, m_evaluation);
  m_figure = figureOf(m_evaluation);
}

bool ShownScene::takeStage(const Scene &scene) {
  const Stage before = std::exchange(m_stage, stageOf(scene, boundObjectsOf(scene, m_evaluation)));
  return !(m_stage == before);
}

void ShownScene::takeStep(const LessonStep &step, Question question) {
  m_shown = shownIn(step, m_evaluation, m_figure, question);
  m_question = question;
}

} // namespace halfspace
