// Pictures of a figure in files, one or as many as a flight has frames.
#include "app/commands.h"
#include "app/open_session.h"
#include "app/standard_streams.h"
#include "lessons/lesson/shown.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/words.h"
#include "widgets/picture/camera_views.h"
#include "widgets/picture/design_scale.h"
#include "widgets/picture/flat_page.h"
#include "widgets/picture/shapes/surface_layers.h"
#include "widgets/scene/offscreen.h"
#include "widgets/scene/png.h"
#include "widgets/typeset/flat_painter.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <algorithm>
#include <filesystem>

namespace halfspace {
namespace {

const LessonStep &stepAt(const OpenedSession &opened, int counted) {
  return opened.lesson->steps[static_cast<std::size_t>(counted - 1)];
}

/// The flat picture of a figure that is on its stage; why there is none.
Result<LabelPicture> drawFlatly(const RenderCommand &command, const OpenedSession &opened,
                                const Figure &whole, SceneContent content, const Typesetter &typesetter) {
  const auto frame = opened.lesson && opened.lesson->flat
                         ? flatFrame(*opened.lesson->flat, opened.session.scene)
                         : std::nullopt;
  if (!frame)
    return Problem{words("Here is no flat picture: the lesson has none, or not of this scene."), "", 0,
                   "--flat"};
  View view{{}, command.size, command.size.height / designHeight};
  view.camera = flatCamera(laidFlat(whole, *frame), view);
  content.figure = clippedTo(view, laidFlat(content.figure, *frame));
  return drawFlat(content, *findTheme(command.theme), view, command.transparent, typesetter);
}

/// Where somebody had put the camera when the session was saved.
Camera cameraOf(const ChosenView &chosen) {
  Camera camera(chosen.view);
  camera.orthographic = chosen.orthographic;
  return camera;
}

/// How a scene is put into all of its pictures: those of a flight are seen from one place, and their labels
/// stand where they stand at its beginning.
struct Setting {
  Stage stage;
  Camera camera;
  std::optional<SceneContent> beginning;
};

Setting settingOf(const RenderCommand &command, const OpenedSession &opened) {
  const Scene &scene = opened.session.scene;
  const Evaluation evaluation = evaluate(scene);
  const Stage stage = stageOf(scene, boundObjectsOf(scene, evaluation));
  const CameraView view = opened.lesson ? opened.lesson->camera : CameraView{};
  if (opened.session.view)
    return {stage, cameraOf(*opened.session.view), {}};
  return {stage,
          homeView(view, toStage(figureOf(evaluation), stage), stage.hasAxes(), command.size,
                   command.size.height / designHeight),
          {}};
}

/// The step that a session's file was left at; nothing for a lesson, whose whole figure is drawn.
std::optional<int> stepOfFile(const OpenedSession &opened) {
  if (!opened.text || !opened.lesson)
    return {};
  return std::min(opened.session.step + 1, static_cast<int>(opened.lesson->steps.size()));
}

/// What is shown of a scene.
SceneContent contentOf(const RenderCommand &command, const OpenedSession &opened,
                       const Evaluation &evaluation, const Stage &stage) {
  SceneContent content;
  content.stage = stage;
  content.hasShadows = !opened.lesson || opened.lesson->hasShadows;
  content.figure = toStage(
      command.step ? shownIn(stepAt(opened, *command.step), evaluation).figure : figureOf(evaluation), stage);
  return content;
}

/// Of a flight once, by its beginning.
void tellWhereOverfull(const Figure &figure) {
  if (isOverfull(figure))
    printError(overfullWords());
}

Result<LabelPicture> drawPicture(const RenderCommand &command, const OpenedSession &opened,
                                 const Setting &setting, const Typesetter &typesetter) {
  const Evaluation evaluation = evaluate(opened.session.scene);
  PictureRequest request;
  request.content = contentOf(command, opened, evaluation, setting.stage);
  request.labelledLike = setting.beginning;
  request.camera = setting.camera;
  request.theme = *findTheme(command.theme);
  request.size = command.size;
  request.transparent = command.transparent;
  if (command.flat)
    return drawFlatly(command, opened, toStage(figureOf(evaluation), setting.stage), request.content,
                      typesetter);
  if (!setting.beginning)
    tellWhereOverfull(request.content.figure);
  return OffscreenPainter(labelSetter(typesetter.fonts()), labelPainter(typesetter)).draw(request);
}

/// Counted from 1: the last step that shows the lesson's flight; nothing where it has none.
std::optional<int> stepOfFlight(const OpenedSession &opened) {
  std::optional<int> last;
  if (opened.lesson)
    for (std::size_t i = 0; i < opened.lesson->steps.size(); ++i)
      if (flightOf(opened.lesson->steps[i]))
        last = static_cast<int>(i) + 1;
  return last;
}

/// The scene's number that counts the frames of the lesson's flight; null where there is none.
Object *frameNumberOf(OpenedSession &opened) {
  const auto step = stepOfFlight(opened);
  return step ? findObject(opened.session.scene, flightOf(stepAt(opened, *step))->frame) : nullptr;
}

std::optional<Problem> refuseStep(const RenderCommand &command, const OpenedSession &opened) {
  const auto steps = opened.lesson ? opened.lesson->steps.size() : 0;
  if (!command.step || static_cast<std::size_t>(*command.step) <= steps)
    return {};
  return Problem{words("The lesson has {count} steps.", {{"count", std::to_string(steps)}}), "", 0, "--step"};
}

/// frames/0007.png for the frame 7 of frames/%04d.png.
std::string fileOf(const NumberedFile &file, int frame) {
  std::string digits = std::to_string(frame);
  digits.insert(0, file.digits - std::min(file.digits, digits.size()), '0');
  return file.before + digits + file.behind;
}

/// Draws and writes one frame after the other.
std::optional<Problem> writeFrames(const RenderCommand &command, OpenedSession &opened, Setting setting,
                                   const Typesetter &typesetter) {
  Object *number = frameNumberOf(opened);
  if (!number)
    return Problem{words("This lesson has no flight whose frames could be drawn."), "", 0, "--frame"};
  const auto [first, last] = *command.frames;
  const auto goTo = [number](const Rational &frame) {
    (*number)[0].x = frame;
    number->kind().settle(*number);
    return (*number)[0].x == frame;
  };
  for (const int frame : {first, last}) // before any picture is written
    if (!goTo(frame))
      return Problem{words("The flight has no frame {frame}: the nearest is {nearest}.",
                           {{"frame", std::to_string(frame)}, {"nearest", toText((*number)[0].x)}}),
                     "", 0, "--frame"};
  goTo(objectAs<NumberObject>(*number)->from);
  setting.beginning = contentOf(command, opened, evaluate(opened.session.scene), setting.stage);
  if (!command.flat)
    tellWhereOverfull(setting.beginning->figure);
  for (int frame = first; frame <= last; ++frame) {
    goTo(frame);
    const auto picture = drawPicture(command, opened, setting, typesetter);
    if (!picture)
      return picture.problem();
    const std::string file = command.numbered ? fileOf(*command.numbered, frame) : command.output;
    if (auto problem = writePng(*picture, file))
      return problem;
  }
  return {};
}

} // namespace

int runRender(RenderCommand command) {
  LessonLibrary library = openLibrary(command.ownLessons);
  auto opened = openSession(library, command.subject, command.assignments);
  if (!opened)
    return fail(opened.problem());
  if (const auto refused = refuseStep(command, *opened))
    return fail(*refused);
  if (command.frames && !command.step)
    command.step = stepOfFlight(*opened);
  if (!command.step)
    command.step = stepOfFile(*opened);
  const Typesetter typesetter;
  const Setting setting = settingOf(command, *opened);
  if (command.frames) {
    const auto problem = writeFrames(command, *opened, setting, typesetter);
    return problem ? fail(*problem) : 0;
  }
  const auto picture = drawPicture(command, *opened, setting, typesetter);
  if (!picture)
    return fail(picture.problem());
  const auto problem = writePng(*picture, command.output);
  return problem ? fail(*problem) : 0;
}

} // namespace halfspace
