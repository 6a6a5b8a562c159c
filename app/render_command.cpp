// Pictures of a figure in files, one or as many as a flight has frames.
#include "app/commands.h"
#include "app/standard_streams.h"
#include "lessons/lesson/nearest_step.h"
#include "lessons/lesson/shown.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/words.h"
#include "widgets/picture/camera_views.h"
#include "widgets/picture/design_scale.h"
#include "widgets/picture/flat_picture.h"
#include "widgets/picture/shapes/surface_layers.h"
#include "widgets/scene/offscreen.h"
#include "widgets/scene/png.h"
#include "widgets/typeset/flat_painter.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <algorithm>
#include <filesystem>
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
  return lesson && opened.text ? &stepOf(*lesson, nearestStep(*lesson, opened.session.step)) : nullptr;
}

/// What is shown of a scene: by a step, or the whole of it.
Figure figureShown(const LessonStep *step, const Evaluation &evaluation) {
  return step ? shownIn(*step, evaluation).figure : figureOf(evaluation);
}

/// The flat picture of a scene; why there is none.
Result<RgbaImage> drawFlatly(const RenderCommand &command, const OpenedSession &opened,
                             const LessonStep *step, const Evaluation &evaluation, const Stage &stage,
                             const Typesetter &typesetter) {
  const auto frame = opened.lesson ? flatFrame(opened.lesson->flat, opened.session.scene) : std::nullopt;
  if (!frame)
    return Problem{words("Here is no flat picture: the lesson has none, or not of this scene."), "", 0,
                   "--flat"};
  const FlatPicture picture(*frame, stage, figureOf(evaluation), figureShown(step, evaluation));
  const View view = picture.fitted({{}, command.size, ownPixelRatio(command.size)});
  return drawFlat(picture.seenFrom(view), command.theme, view, command.transparent, typesetter);
}

/// How a scene is put into all of its pictures: those of a flight are seen from one place, and their labels
/// stand where they stand at its beginning.
struct Setting {
  const LessonStep *step = nullptr; ///< that they show; null: the whole figure
  Stage stage;
  Camera camera;
  std::optional<SceneContent> beginning;
};

Setting settingOf(const RenderCommand &command, const OpenedSession &opened, const LessonStep *step,
                  const Evaluation &evaluation) {
  const Scene &scene = opened.session.scene;
  const Stage stage = stageOf(scene, boundObjectsOf(scene, evaluation));
  const CameraView view = opened.lesson ? opened.lesson->camera : CameraView{};
  if (opened.session.view) // where somebody had put the camera when the session was saved
    return {step, stage, cameraOf(*opened.session.view), {}};
  return {step,
          stage,
          homeView(view, toStage(figureOf(evaluation), stage), stage.hasAxes(), command.size,
                   ownPixelRatio(command.size)),
          {}};
}

/// The picture of a scene in space.
SceneContent contentOf(const OpenedSession &opened, const LessonStep *step, const Evaluation &evaluation,
                       const Stage &stage) {
  SceneContent content;
  content.stage = stage;
  content.hasShadows = !opened.lesson || opened.lesson->hasShadows;
  content.figure = toStage(figureShown(step, evaluation), stage);
  return content;
}

/// Of a flight once, by its beginning.
void tellWhereOverfull(const Figure &figure) {
  if (isOverfull(figure))
    printError(overfullWords());
}

/// Draws the pictures of a command.
class CommandPainter {
public:
  CommandPainter(const RenderCommand &command, const OpenedSession &opened, Setting setting)
      : m_command(command), m_opened(opened), m_setting(std::move(setting)) {}

  /// From now on pictures show what came after this: their labels stand where they stand in it.
  void begin(const Evaluation &evaluation) {
    m_setting.beginning = contentOf(m_opened, m_setting.step, evaluation, m_setting.stage);
    if (!m_command.flat)
      tellWhereOverfull(m_setting.beginning->figure);
  }

  [[nodiscard]] Result<RgbaImage> draw(const Evaluation &evaluation) {
    if (m_command.flat)
      return drawFlatly(m_command, m_opened, m_setting.step, evaluation, m_setting.stage, m_typesetter);
    PictureRequest request;
    request.content = contentOf(m_opened, m_setting.step, evaluation, m_setting.stage);
    request.labelledLike = m_setting.beginning;
    request.camera = m_setting.camera;
    request.theme = m_command.theme;
    request.size = m_command.size;
    request.transparent = m_command.transparent;
    if (!m_setting.beginning)
      tellWhereOverfull(request.content.figure);
    return m_painter.draw(request);
  }

private:
  const RenderCommand &m_command;
  const OpenedSession &m_opened;
  Setting m_setting;
  Typesetter m_typesetter;
  OffscreenPainter m_painter{labelSetter(m_typesetter.fonts()), labelPainter(m_typesetter)};
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

/// frames/0007.png for the frame 7 of frames/%04d.png.
std::string fileOf(const NumberedFile &file, int frame) {
  std::string digits = std::to_string(frame);
  digits.insert(0, file.digits - std::min(file.digits, digits.size()), '0');
  return file.before + digits + file.behind;
}

/// Draws and writes one frame after the other.
std::optional<Problem> writeFrames(const RenderCommand &command, OpenedSession &opened, Evaluation evaluation,
                                   CommandPainter &painter) {
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
  painter.begin(evaluation);
  for (int frame = first; frame <= last; ++frame) {
    goToFrame(frame, *number, scene);
    evaluation = evaluate(scene, evaluation);
    const auto picture = painter.draw(evaluation);
    if (!picture)
      return picture.problem();
    const std::string file = command.numbered ? fileOf(*command.numbered, frame) : command.output;
    if (auto problem = writePng(*picture, file))
      return problem;
  }
  return {};
}

std::optional<Problem> writePicture(const RenderCommand &command, const Evaluation &evaluation,
                                    CommandPainter &painter) {
  const auto picture = painter.draw(evaluation);
  return picture ? writePng(*picture, command.output) : picture.problem();
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
  Evaluation evaluation = evaluate(opened->session.scene);
  CommandPainter painter(command, *opened, settingOf(command, *opened, *step, evaluation));
  const auto problem = command.frames ? writeFrames(command, *opened, std::move(evaluation), painter)
                                      : writePicture(command, evaluation, painter);
  return problem ? fail(*problem) : 0;
}

} // namespace halfspace
