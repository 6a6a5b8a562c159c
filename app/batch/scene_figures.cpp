#include "app/batch/scene_figures.h"

#include "app/batch/flight_frame.h"
#include "lessons/lesson/nearest_step.h"
#include "lessons/lesson/shown.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/words.h"
#include "widgets/picture/lesson_picture.h"

#include <utility>

namespace halfspace {

namespace {

/// The step that a figure shows, null for the whole of the scene: the one of this number, counted from 1, or
/// where none is asked for that of the flight, of frames, or of a session. Requires that the lesson has it.
const LessonStep *stepShown(const OpenedSession &opened, std::optional<int> step, bool isFrame) {
  const Lesson *lesson = opened.lesson;
  if (step)
    return &stepOf(*lesson, *step - 1);
  if (const LessonStep *flight = isFrame ? stepOfFlight(opened) : nullptr)
    return flight;
  const bool isSession = opened.origin != OpenedSession::Origin::Lesson;
  return lesson && isSession ? &stepOf(*lesson, nearestStep(*lesson, opened.session.step)) : nullptr;
}

} // namespace

SceneFigures::SceneFigures(const RenderCommand &command, OpenedSession opened, std::string name)
    : m_command(command), m_opened(std::move(opened)), m_name(std::move(name)) {
  if (command.onlyChanged)
    m_openedAs = writeSession(m_opened.session);
}

Result<FigureSubject> SceneFigures::subjectOf(std::optional<int> step, std::optional<int> frame,
                                              const FigureChoices &choices) {
  evaluateOnce();
  if (auto problem = frame ? showFrame(*frame) : std::nullopt)
    return std::move(*problem);
  const LessonStep *shown = stepShown(m_opened, step, frame.has_value());
  FigureSubject subject;
  subject.content = contentAt(shown, m_now);
  if (frame)
    subject.framedLike = contentAt(shown, *m_firstFrame);
  subject.camera = cameraFor(m_opened.session, m_opened.lesson, *m_beginning, m_stage, choices.frame());
  if (m_command.flat) {
    auto flat = flatAt(shown);
    if (!flat)
      return flat.problem();
    subject.flat = std::move(*flat);
  }
  subject.title = m_opened.lesson ? m_opened.lesson->title : m_name;
  subject.description = shownIn(shown ? *shown : LessonStep(), m_now).description;
  if (!m_command.anonymous)
    subject.session = writeSession(sessionAt(shown));
  return subject;
}

std::string SceneFigures::madeOf(std::optional<int> step, std::optional<int> frame) const {
  std::string all;
  for (const std::string &part : {m_name, m_opened.lesson ? m_opened.lesson->text : "", m_openedAs,
                                  std::to_string(step.value_or(0)), frame ? std::to_string(*frame) : ""})
    all += part + '\0';
  return all;
}

void SceneFigures::evaluateOnce() {
  if (m_beginning)
    return;
  const Scene &scene = m_opened.session.scene;
  m_beginning = evaluate(scene);
  m_now = *m_beginning;
  m_stage = stageOf(scene, boundObjectsOf(scene, m_now));
}

std::optional<Problem> SceneFigures::showFrame(int frame) {
  if (!m_firstFrame) {
    goToFirstFrame(m_opened);
    m_firstFrame = evaluate(m_opened.session.scene, m_now);
  }
  auto problem = goToFrame(frame, m_opened);
  m_now = evaluate(m_opened.session.scene, m_now);
  return problem;
}

SceneContent SceneFigures::contentAt(const LessonStep *step, const Evaluation &evaluation) const {
  return contentOf(m_opened.lesson, step, evaluation, m_stage);
}

Result<FlatPicture> SceneFigures::flatAt(const LessonStep *step) const {
  const auto frame =
      m_opened.lesson ? flatFrame(m_opened.lesson->flat, m_opened.session.scene) : std::nullopt;
  if (!frame)
    return Problem{words("Here is no flat picture: the lesson has none, or not of this scene."), "", 0,
                   "--flat"};
  return FlatPicture(*frame, m_stage, figureOf(m_now), figureShown(step, m_now));
}

Session SceneFigures::sessionAt(const LessonStep *step) const {
  Session session = m_opened.session;
  const std::size_t steps = step ? m_opened.lesson->steps.size() : 0;
  for (std::size_t i = 0; i < steps; ++i)
    if (&m_opened.lesson->steps[i] == step)
      session.step = static_cast<int>(i);
  return session;
}

} // namespace halfspace
