#include "app/commands.h"

#include "app/check.h"
#include "app/lessons_folder.h"
#include "app/new_lesson.h"
#include "app/standard_streams.h"
#include "app/subject_opener.h"
#include "lessons/construction/reference.h"
#include "lessons/files/read_file.h"
#include "lessons/language.h"
#include "lessons/scene/file/explain_formats.h"
#include "lessons/text.h"
#include "lessons/typed/typed_scene.h"
#include "lessons/words.h"
#include "widgets/mesh_files/serve_mesh.h"

#include <nlohmann/json.hpp>

#include <unistd.h>

namespace halfspace {
namespace {

/// What was asked for was done, and found something.
constexpr int exitProblems = 1;
/// Nobody types more.
constexpr std::size_t mostTypedBytes = 1U << 20U;

Result<std::string> readStandardInput(std::size_t mostBytes) {
  std::string text;
  while (text.size() <= mostBytes) {
    const std::size_t begun = text.size();
    text.resize(begun + mostBytes / 16);
    const ReadPart part = readSome(STDIN_FILENO, text.data() + begun, text.size() - begun);
    text.resize(begun + part.count);
    if (part.error != 0)
      return Problem{words("What comes in cannot be read."), "", 0, ""};
    if (part.count == 0)
      return text;
  }
  return Problem{words("What comes in is too long."), "", 0, ""};
}

} // namespace

Result<OpenedSession> openSubject(LessonLibrary &library, const std::string &subject, const OwnLessons &own,
                                  const std::vector<std::string> &assignments) {
  auto opened = SubjectOpener(own).open(subject, library);
  return opened ? withValues(std::move(*opened), assignments) : opened;
}

Result<OpenedSession> openTyped(const std::string &file, const std::vector<std::string> &assignments) {
  const auto text = file == "-" ? readStandardInput(mostTypedBytes) : readFile(file, mostTypedBytes);
  if (!text)
    return text.problem();
  auto scene = readTypedScene(*text, file, language().decimalMark);
  if (!scene)
    return scene.problem();
  OpenedSession opened;
  opened.session.scene = std::move(*scene);
  return withValues(std::move(opened), assignments);
}

int runLessons(const LessonsCommand &command) {
  SubjectOpener opener(command.ownLessons);
  auto list = nlohmann::ordered_json::array();
  std::string lines;
  for (const Lesson &lesson : opener.all().lessons) {
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
  if (readLessons(lessonsFolder()).find(command.id))
    return fail({words("A lesson of the program has the id “{id}” already. Give yours its own.",
                       {{"id", command.id}}),
                 "", 0, ""});
  const auto written = writeNewLesson(command.id, {});
  if (!written)
    return fail(written.problem());
  return printOut(words("{file} is written. Try it: halfspace --lessons . {id}",
                        {{"file", written->filename().string()}, {"id", command.id}}) +
                  "\n");
}

int runConstructions() { return printOut(referenceOfConstructions()); }

int runComplete(const CompleteCommand &command) {
  std::string lines = command.files == CompleteCommand::Files::All       ? "file\n"
                      : command.files == CompleteCommand::Files::Folders ? "directory\n"
                                                                         : "\n";
  for (const std::string &word : command.words)
    lines += word + "\n";
  if (command.lessons)
    for (const Lesson &lesson : allLessons(command.ownLessons).lessons)
      if (lesson.id.starts_with(command.typed))
        lines += lesson.id + "\n";
  return printOut(lines);
}

int runReadMesh(const ReadMeshCommand &command) {
  boundThisProcess(readingBounds);
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
  LessonLibrary library;
  const auto opened = command.typedFile
                          ? openTyped(*command.typedFile, command.assignments)
                          : openSubject(library, command.subject, command.ownLessons, command.assignments);
  if (!opened)
    return fail(opened.problem());
  const Scene &scene = opened->session.scene;
  const Evaluation evaluation = evaluate(scene);
  const std::string title = printable(opened->lesson ? opened->lesson->title : opened->session.lesson);
  if (command.format == "json")
    return printOut(explanationJson(opened->session.lesson, scene, evaluation));
  if (command.format == "latex")
    return printOut(explanationLatex(title, evaluation));
  return printOut(command.format == "mathml" ? explanationMathMl(title, evaluation)
                                             : explanationText(title, evaluation));
}

} // namespace halfspace
