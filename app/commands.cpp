#include "app/commands.h"

#include "app/check.h"
#include "app/lessons_folder.h"
#include "app/new_lesson.h"
#include "app/open_session.h"
#include "app/standard_streams.h"
#include "lessons/construction/reference.h"
#include "lessons/scene/explain_formats.h"
#include "lessons/text.h"
#include "lessons/words.h"
#include "widgets/mesh_files/serve_mesh.h"
#include "widgets/picture/camera_views.h"
#include "widgets/picture/design_scale.h"
#include "widgets/picture/flat_page.h"
#include "widgets/scene/offscreen.h"
#include "widgets/scene/png.h"
#include "widgets/typeset/flat_painter.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

namespace halfspace {
namespace {

/// What was asked for was done, and found something.
constexpr int exitProblems = 1;

/// A library with problems still serves the lessons that could be read; the others are told about.
LessonLibrary openLibrary(const OwnLessons &own) {
  LessonLibrary library = allLessons(own);
  for (const Problem &problem : library.problems)
    printError(problem.text());
  return library;
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

} // namespace

int runLessons(const LessonsCommand &command) {
  const LessonLibrary library = openLibrary(command.ownLessons);
  auto list = nlohmann::ordered_json::array();
  std::string lines;
  for (const Lesson &lesson : library.lessons) {
    const std::string title = printable(lesson.title);
    auto sources = nlohmann::ordered_json::array();
    for (const std::string &source : lesson.sources)
      sources.push_back(printable(source));
    auto needs = nlohmann::ordered_json::array();
    for (const Need &need : lesson.needs)
      needs.push_back(printable(need.id));
    list.push_back({{"id", lesson.id},
                    {"title", title},
                    {"chapter", printable(lesson.chapter)},
                    {"needs", needs},
                    {"steps", lesson.steps.size()},
                    {"sources", sources}});
    lines += lesson.id + "  " + title + "\n";
  }
  return printOut(command.json ? list.dump(2) + "\n" : lines);
}

int runNewLesson(const NewLessonCommand &command) {
  const auto written = writeNewLesson(command.id, std::filesystem::current_path());
  if (!written)
    return fail(written.problem());
  return printOut(words("{file} is written. Try it: halfspace --lessons . {id}",
                        {{"file", written->filename().string()}, {"id", command.id}}) +
                  "\n");
}

int runConstructions() { return printOut(referenceOfConstructions()); }

int runReadMesh(const ReadMeshCommand &command) {
  boundThisProcess();
  return serveMesh(command.file, STDOUT_FILENO);
}

int runCheck(const CheckCommand &command) {
  std::vector<std::filesystem::path> paths(command.paths.begin(), command.paths.end());
  if (paths.empty())
    paths.push_back(lessonsFolder());
  const Checked checked = checkLessons(paths, readLessons(lessonsFolder()));
  std::string lines;
  for (const Problem &problem : checked.problems)
    lines += printable(problem.text()) + "\n";
  if (lines.empty())
    return printOut(
        words("Nothing is wrong. Lessons: {count}", {{"count", std::to_string(checked.lessons)}}) + "\n");
  const int printed = printOut(lines);
  return printed == 0 ? exitProblems : printed;
}

int runExplain(const ExplainCommand &command) {
  LessonLibrary library = openLibrary(command.ownLessons);
  const auto opened = openSession(library, command.subject, command.assignments);
  if (!opened)
    return fail(opened.problem());
  const Scene &scene = opened->session.scene;
  const Evaluation evaluation = evaluate(scene);
  const std::string title = printable(opened->lesson ? opened->lesson->title : opened->session.lesson);
  if (command.format == "json")
    return printOut(explanationJson(opened->session.lesson, scene, evaluation));
  return printOut(command.format == "latex" ? explanationLatex(title, evaluation)
                                            : explanationText(title, evaluation));
}

int runRender(const RenderCommand &command) {
  LessonLibrary library = openLibrary(command.ownLessons);
  const auto opened = openSession(library, command.subject, command.assignments);
  if (!opened)
    return fail(opened.problem());
  const Evaluation evaluation = evaluate(opened->session.scene);
  const Figure whole = figureOf(evaluation);
  const Stage stage = stageOf(opened->session.scene, boundObjectsOf(opened->session.scene, evaluation));
  const CameraView view = opened->lesson ? opened->lesson->camera : CameraView{};
  const Camera camera = homeView(view, toStage(whole, stage), stage.hasAxes(), command.size,
                                 command.size.height / designHeight);
  Figure figure = whole;
  if (command.step) {
    const auto steps = opened->lesson ? opened->lesson->steps.size() : 0;
    if (static_cast<std::size_t>(*command.step) > steps)
      return fail(
          {words("The lesson has {count} steps.", {{"count", std::to_string(steps)}}), "", 0, "--step"});
    figure = shownIn(opened->lesson->steps[static_cast<std::size_t>(*command.step - 1)], evaluation).figure;
  }

  const Typesetter typesetter;
  PictureRequest request;
  request.content.stage = stage;
  request.content.figure = toStage(figure, stage);
  request.camera = camera;
  request.theme = *findTheme(command.theme);
  request.size = command.size;
  request.transparent = command.transparent;
  const auto picture = command.flat
                           ? drawFlatly(command, *opened, toStage(whole, stage), request.content, typesetter)
                           : drawOffscreen(request, labelPainter(typesetter));
  if (!picture)
    return fail(picture.problem());
  if (const auto problem = writePng(*picture, command.output))
    return fail(*problem);
  return 0;
}

} // namespace halfspace
