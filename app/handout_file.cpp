#include "app/handout_file.h"

#include "app/figures/figure_maker.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/scene/placed_scene.h"
#include "widgets/carriers/carrier.h"
#include "widgets/picture/lesson_picture.h"
#include "widgets/typeset/text_faces.h"
#include "widgets/typeset/typesetter.h"

#include <numeric>
#include <utility>

namespace halfspace {
namespace {

/// Draws the figures of a handout as those of files are drawn.
class HandoutFigures {
public:
  HandoutFigures(const Lesson &lesson, const Session &session, const Evaluation &evaluation,
                 HiddenLines hidden, const Typesetter &typesetter)
      : m_lesson(lesson), m_session(session), m_evaluation(evaluation),
        m_stage(stageOf(session.scene, boundObjectsOf(session.scene, evaluation))), m_maker(typesetter) {
    m_choices.format = figureFormatWith(".pdf");
    m_choices.isCropped = true;
    m_choices.theme = *findTheme("print");
    m_choices.hidden = hidden;
  }

  std::vector<Drawing> draw(const Figure &shown, const FigureSize &size) {
    m_choices.paper = PaperSize{size.width, size.typeSize};
    FigureSubject subject;
    subject.content = contentOf(&m_lesson, shown, m_evaluation, m_stage);
    subject.camera = cameraFor(m_session, &m_lesson, m_evaluation, m_stage, m_choices.frame());
    std::vector<Drawing> drawings{m_maker.drawing(subject, m_choices)};
    if (const auto frame = flatFrame(m_lesson.flat, m_session.scene)) {
      subject.flat.emplace(*frame, m_stage, figureOf(m_evaluation), shown);
      drawings.push_back(m_maker.drawing(subject, m_choices));
    }
    return drawings;
  }

private:
  const Lesson &m_lesson;
  const Session &m_session;
  const Evaluation &m_evaluation;
  Stage m_stage;
  FigureMaker m_maker;
  FigureChoices m_choices;
};

} // namespace

std::vector<std::size_t> allStepsOf(const Lesson &lesson) {
  std::vector<std::size_t> steps(lesson.steps.size());
  std::iota(steps.begin(), steps.end(), std::size_t{0});
  return steps;
}

std::string handoutFile(const Lesson &lesson, const Session &session, const HandoutChoices &choices,
                        const Typesetter &typesetter) {
  const Evaluation evaluation = evaluate(session.scene);
  HandoutFigures figures(lesson, session, evaluation, choices.hidden, typesetter);
  const HandoutRequest request{
      lesson,
      evaluation,
      choices.steps,
      choices.paper,
      choices.columns,
      choices.hasAnswers,
      [&](const Figure &shown, const FigureSize &size) { return figures.draw(shown, size); }};
  const math::TextFaces words = textFaces();
  std::string file = handoutOf(request, {typesetter.fonts(), words});
  if (choices.isAnonymous)
    return file;
  Session carried = session;
  if (!choices.steps.empty())
    carried.step = static_cast<int>(choices.steps.front());
  return withSession(std::move(file), writeSession(carried));
}

} // namespace halfspace
