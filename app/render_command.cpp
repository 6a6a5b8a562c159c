// Pictures of a figure in files, one or as many as a flight has frames.
#include "app/commands.h"
#include "app/figures/figure_maker.h"
#include "app/standard_streams.h"
#include "lessons/files/write_file.h"
#include "lessons/lesson/nearest_step.h"
#include "lessons/lesson/shown.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/scene/file/session_file.h"
#include "lessons/words.h"
#include "widgets/picture/camera_views.h"
#include "widgets/picture/lesson_picture.h"
#include "widgets/picture/shapes/surface_layers.h"
#include "widgets/typeset/typesetter.h"

#include <utility>

namespace halfspace {
namespace {

/// The last step that shows the lesson's flight; null where it has none.
const LessonStep *stepOfFlight(const OpenedSession &opened) {
  const LessonStep *last = nullptr;
  if (opened.lesson)
    for (const LessonStep &step : opened.lesson->steps)
      if (flightOf(step))
        last = &step;
  return last;
}

/// The step that the pictures show, null for the whole figure; or that the lesson does not have it.
Result<const LessonStep *> stepToShow(const RenderCommand &command, const OpenedSession &opened) {
  const Lesson *lesson = opened.lesson;
  const std::size_t steps = lesson ? lesson->steps.size() : 0;
  if (command.step && static_cast<std::size_t>(*command.step) > steps)
    return Problem{words("The lesson has {count} steps.", {{"count", std::to_string(steps)}}), "", 0,
                   "--step"};
  if (command.step)
    return &stepOf(*lesson, *command.step - 1);
  if (const LessonStep *step = command.frames ? stepOfFlight(opened) : nullptr)
    return step;
  const bool isSession = opened.origin != OpenedSession::Origin::Lesson;
  return lesson && isSession ? &stepOf(*lesson, nearestStep(*lesson, opened.session.step)) : nullptr;
}

/// What the figures of a command are of.
struct Motif {
  const RenderCommand &command;
  const OpenedSession &opened; ///< with the scene of the picture that comes next
  const LessonStep *step;      ///< that they show; null: the whole figure
  Stage stage;
};

/// What is to be seen when a picture is opened again: its scene, at its step.
Session sessionOf(const Motif &motif) {
  Session session = motif.opened.session;
  const std::size_t steps = motif.step ? motif.opened.lesson->steps.size() : 0;
  for (std::size_t i = 0; i < steps; ++i)
    if (&motif.opened.lesson->steps[i] == motif.step)
      session.step = static_cast<int>(i);
  return session;
}

/// Where a scene is looked at from: as somebody had put the camera when the session was saved, or as its
/// lesson begins.
Camera cameraFor(const Motif &motif, const Evaluation &evaluation, const View &frame) {
  if (const auto &view = motif.opened.session.view)
    return cameraOf(*view);
  return homeOf(motif.opened.lesson, evaluation, motif.stage, frame.size, frame.pixelRatio);
}

/// Flat pictures are each laid on their page by themselves.
Result<FlatPicture> flatPictureOf(const Motif &motif, const Evaluation &evaluation) {
  const auto &[command, opened, step, stage] = motif;
  const auto frame = opened.lesson ? flatFrame(opened.lesson->flat, opened.session.scene) : std::nullopt;
  if (!frame)
    return Problem{words("Here is no flat picture: the lesson has none, or not of this scene."), "", 0,
                   "--flat"};
  return FlatPicture(*frame, stage, figureOf(evaluation), figureShown(step, evaluation));
}

/// The figures of a command, which are drawn one after the other, seen from one place.
class Figures {
public:
  Figures(Motif motif, const Evaluation &evaluation)
      : m_motif(std::move(motif)), m_camera(cameraFor(m_motif, evaluation, m_motif.command.choices.frame())) {
  }

  /// From now on they show what came after this: they are framed and labelled as it is.
  void begin(const Evaluation &evaluation) { m_beginning = content(evaluation); }

  /// Draws one into a file.
  [[nodiscard]] std::optional<Problem> write(const Evaluation &evaluation, const std::string &file) {
    const auto subject = subjectOf(evaluation);
    if (!subject)
      return subject.problem();
    auto figure = m_maker.file(*subject, m_motif.command.choices);
    if (!figure)
      return figure.problem();
    if (figure->leavesOutSurfaces && !std::exchange(m_hasToldOfOverfull, true)) // of a flight many would
      printError(overfullWords());
    return writeFile(file, figure->content);
  }

private:
  [[nodiscard]] SceneContent content(const Evaluation &evaluation) const {
    return contentOf(m_motif.opened.lesson, m_motif.step, evaluation, m_motif.stage);
  }

  [[nodiscard]] Result<FigureSubject> subjectOf(const Evaluation &evaluation) const {
    const auto &[command, opened, step, stage] = m_motif;
    FigureSubject subject;
    subject.content = content(evaluation);
    subject.framedLike = m_beginning;
    subject.camera = m_camera;
    if (command.flat) {
      auto flat = flatPictureOf(m_motif, evaluation);
      if (!flat)
        return flat.problem();
      subject.flat = std::move(*flat);
    }
    subject.title = opened.lesson ? opened.lesson->title : command.subject;
    subject.description = shownIn(step ? *step : LessonStep(), evaluation).description;
    if (!command.anonymous)
      subject.session = writeSession(sessionOf(m_motif));
    return subject;
  }

  Motif m_motif;
  Camera m_camera;
  std::optional<SceneContent> m_beginning;
  bool m_hasToldOfOverfull = false;
  Typesetter m_typesetter;
  FigureMaker m_maker{m_typesetter};
};

/// The name of the scene's number that counts the frames of the lesson's flight; nothing where there is none.
std::optional<std::string> frameNumberOf(const OpenedSession &opened) {
  const LessonStep *step = stepOfFlight(opened);
  return step ? std::optional(flightOf(*step)->frame) : std::nullopt;
}

/// The frame that is nearest to the wanted one, with which the scene is now.
Rational goToFrame(const Rational &wanted, const std::string &name, Scene &scene) {
  Object number = *findObject(scene, name);
  number[0].x = wanted;
  number.kind().settle(number);
  const Rational frame = number[0].x;
  setObject(scene, name, std::move(number));
  return frame;
}

/// Draws and writes one frame after the other.
std::optional<Problem> writeFrames(const RenderCommand &command, OpenedSession &opened, Evaluation evaluation,
                                   Figures &figures) {
  const auto number = frameNumberOf(opened);
  if (!number)
    return Problem{words("This lesson has no flight whose frames could be drawn."), "", 0, "--frame"};
  const auto [first, last] = *command.frames;
  Scene &scene = opened.session.scene;
  for (const int frame : {first, last}) // before any picture is written
    if (const Rational nearest = goToFrame(frame, *number, scene); nearest != frame)
      return Problem{words("The flight has no frame {frame}: the nearest is {nearest}.",
                           {{"frame", std::to_string(frame)}, {"nearest", toText(nearest)}}),
                     "", 0, "--frame"};
  goToFrame(objectAs<NumberObject>(*findObject(scene, *number))->from, *number, scene);
  evaluation = evaluate(scene, evaluation);
  figures.begin(evaluation);
  for (int frame = first; frame <= last; ++frame) {
    goToFrame(frame, *number, scene);
    evaluation = evaluate(scene, evaluation);
    const std::string file = command.numbered ? fileOf(*command.numbered, frame) : command.output;
    if (auto problem = figures.write(evaluation, file))
      return problem;
  }
  return {};
}

} // namespace

int runRender(const RenderCommand &command) {
  LessonLibrary library;
  auto opened = openSubject(library, command.subject, command.ownLessons, command.assignments);
  if (!opened)
    return fail(opened.problem());
  const auto step = stepToShow(command, *opened);
  if (!step)
    return fail(step.problem());
  const Scene &scene = opened->session.scene;
  Evaluation evaluation = evaluate(scene);
  const Stage stage = stageOf(scene, boundObjectsOf(scene, evaluation));
  Figures figures({command, *opened, *step, stage}, evaluation);
  const auto problem = command.frames ? writeFrames(command, *opened, std::move(evaluation), figures)
                                      : figures.write(evaluation, command.output);
  return problem ? fail(*problem) : 0;
}

} // namespace halfspace
