#include "app/check.h"

#include "lessons/guess.h"
#include "lessons/lesson/lesson_picture.h"
#include "lessons/lesson/name_check.h"
#include "lessons/lesson/words_check.h"
#include "lessons/reading/markdown.h"
#include "lessons/text.h"
#include "lessons/words.h"
#include "widgets/picture/math/read_latex.h"
#include "widgets/text/picture_object.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace halfspace {
namespace {

bool isFolder(const std::filesystem::path &path) {
  std::error_code error;
  return std::filesystem::is_directory(path, error);
}

LessonLibrary libraryOf(const std::filesystem::path &fileOrFolder) {
  if (isFolder(fileOrFolder))
    return readLessons(fileOrFolder);
  auto lesson = readLesson(fileOrFolder);
  if (!lesson)
    return {{}, {lesson.problem()}};
  return {{std::move(*lesson)}, {}};
}

void addIfUnreadable(const MarkdownFormula::Source &formula, const LessonWords &piece, const Lesson &lesson,
                     std::vector<Problem> &problems) {
  const auto read = math::readLatex(formula.latex, lesson.macros);
  const auto *error = std::get_if<math::ReadError>(&read);
  if (error)
    problems.push_back(
        {words("In “{formula}”, column {column}: {sentence}", {{"formula", shortened(formula.latex)},
                                                               {"column", std::to_string(error->column)},
                                                               {"sentence", error->sentence}}),
         lesson.file, piece.lineAt(formula.place), piece.field});
}

/// The pictures among blocks, those in each other too.
void addPictures(const std::vector<MarkdownBlock> &blocks, std::vector<std::string> &names) {
  for (const MarkdownBlock &block : blocks) {
    for (const MarkdownSpan &span : block.spans)
      if (span.kind == MarkdownSpan::Kind::Picture)
        names.push_back(span.picture);
    addPictures(block.children, names);
  }
}

/// Why a picture would not be shown; empty where it is.
std::string whyNotShown(const std::string &picture, const Lesson &lesson) {
  const auto bytes = readLessonPicture(std::filesystem::path(lesson.file).parent_path(), picture);
  if (!bytes)
    return bytes.problem().sentence;
  const auto image = imageOf(*bytes);
  return image ? std::string()
               : words("The picture “{name}” cannot be shown. {reason}",
                       {{"name", shortened(picture)}, {"reason", image.problem().sentence}});
}

void addIfNotShown(const std::string &picture, const LessonWords &piece, const Lesson &lesson,
                   std::vector<Problem> &problems) {
  const std::string sentence = whyNotShown(picture, lesson);
  if (!sentence.empty())
    problems.push_back({sentence, lesson.file,
                        piece.lineAt(std::min(piece.text.find(picture), piece.text.size())), piece.field});
}

/// What in a lesson's words would not be seen as it is meant: formulas that cannot be read, each with its
/// line and the column within it, and pictures.
void addUnreadable(const Lesson &lesson, std::vector<Problem> &problems) {
  for (const LessonWords &piece : wordsOf(lesson)) {
    const auto markdown = readMarkdown(piece.text);
    if (!markdown)
      continue; // such a lesson is not read
    for (const MarkdownFormula &formula : markdown->formulas)
      for (const MarkdownFormula::Source &source : formula.sources)
        addIfUnreadable(source, piece, lesson, problems);
    std::vector<std::string> pictures;
    addPictures(markdown->blocks, pictures);
    for (const std::string &picture : pictures)
      addIfNotShown(picture, piece, lesson, problems);
  }
}

void addIds(const LessonLibrary &library, std::vector<std::string> &ids) {
  for (const Lesson &lesson : library.lessons)
    ids.push_back(lesson.id);
  for (const Problem &problem : library.problems) // of a lesson that cannot be read, but may well be needed
    ids.push_back(std::filesystem::path(problem.file).stem().string());
}

/// Holds lessons against the others that there are: those of their folder and the program's own.
class LibraryCheck {
public:
  LibraryCheck(const LessonLibrary &beside, const LessonLibrary &ours) : m_ours(ours) {
    addIds(beside, m_ids);
    addIds(ours, m_ids);
    // A folder with all of the program's lessons is where they come from.
    m_isOurs = std::ranges::all_of(ours.lessons,
                                   [&](const Lesson &lesson) { return beside.find(lesson.id) != nullptr; });
  }

  void addProblems(const Lesson &lesson, std::vector<Problem> &problems) const {
    if (!m_isOurs && m_ours.find(lesson.id))
      problems.push_back(
          {words("A lesson of the program has the id “{id}” already, and this one would be left "
                 "out beside it. Give it its own.",
                 {{"id", lesson.id}}),
           lesson.file, lesson.idLine, "id"});
    for (std::size_t i = 0; i < lesson.needs.size(); ++i)
      if (std::ranges::find(m_ids, lesson.needs[i]) == m_ids.end())
        problems.push_back(
            {withGuess(words("There is no lesson “{id}”.", {{"id", shortened(lesson.needs[i])}}),
                       lesson.needs[i], m_ids),
             lesson.file, lesson.needsLines[i], "needs"});
  }

private:
  const LessonLibrary &m_ours;
  std::vector<std::string> m_ids;
  bool m_isOurs = false;
};

} // namespace

std::vector<Problem> problemsIn(const Lesson &lesson) {
  std::vector<Problem> problems = problemsWithWords(lesson);
  addUnreadable(lesson, problems);
  std::ranges::move(problemsWithNames(lesson), std::back_inserter(problems));
  std::ranges::stable_sort(problems, {}, &Problem::line);
  return problems;
}

Checked checkLessons(const std::filesystem::path &fileOrFolder, const LessonLibrary &ours) {
  LessonLibrary library = libraryOf(fileOrFolder);
  const LibraryCheck libraryCheck(
      isFolder(fileOrFolder) ? library : readLessons(std::filesystem::absolute(fileOrFolder).parent_path()),
      ours);
  Checked checked{library.lessons.size(), std::move(library.problems)};
  for (const Lesson &lesson : library.lessons) {
    libraryCheck.addProblems(lesson, checked.problems);
    std::ranges::move(problemsIn(lesson), std::back_inserter(checked.problems));
  }
  std::stable_sort(checked.problems.begin(), checked.problems.end(), [](const Problem &a, const Problem &b) {
    return std::tie(a.file, a.line) < std::tie(b.file, b.line);
  });
  return checked;
}

} // namespace halfspace
