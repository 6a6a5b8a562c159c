#include "app/check.h"

#include "lessons/lesson/name_check.h"
#include "lessons/reading/document.h"
#include "lessons/reading/markdown.h"
#include "lessons/text.h"
#include "lessons/words.h"
#include "widgets/picture/math/read_latex.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace halfspace {
namespace {

LessonLibrary libraryOf(const std::filesystem::path &fileOrFolder) {
  std::error_code error;
  if (std::filesystem::is_directory(fileOrFolder, error))
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

/// The formulas in a lesson's words that cannot be read, each with its line and the column within it.
void addUnreadableFormulas(const Lesson &lesson, std::vector<Problem> &problems) {
  for (const LessonWords &piece : wordsOf(lesson))
    if (const auto markdown = readMarkdown(piece.text))
      for (const MarkdownFormula &formula : markdown->formulas)
        for (const MarkdownFormula::Source &source : formula.sources)
          addIfUnreadable(source, piece, lesson, problems);
}

} // namespace

Checked checkLessons(const std::filesystem::path &fileOrFolder) {
  LessonLibrary library = libraryOf(fileOrFolder);
  Checked checked{library.lessons.size(), std::move(library.problems)};
  for (const Lesson &lesson : library.lessons) {
    addUnreadableFormulas(lesson, checked.problems);
    std::ranges::move(problemsWithNames(lesson), std::back_inserter(checked.problems));
  }
  std::stable_sort(checked.problems.begin(), checked.problems.end(), [](const Problem &a, const Problem &b) {
    return std::tie(a.file, a.line) < std::tie(b.file, b.line);
  });
  return checked;
}

} // namespace halfspace
