#include "app/check.h"

#include "lessons/guess.h"
#include "lessons/lesson/lesson_picture.h"
#include "lessons/lesson/name_check.h"
#include "lessons/reading/document.h"
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

/// Blocks of code that were perhaps meant to be instructions: ```tusk.
void addBlocksNearlyKnown(const LessonWords &piece, const Lesson &lesson, std::vector<Problem> &problems) {
  const std::vector<std::string> known{"lines", "note", "task", "predict", "blank", "draw"};
  constexpr std::string_view fence = "```";
  for (auto place = piece.text.find(fence); place != std::string::npos;
       place = piece.text.find(fence, place + fence.size())) {
    const auto begin = place + fence.size();
    const std::string word(
        trimmed(std::string_view(piece.text).substr(begin, piece.text.find('\n', begin) - begin)));
    if (!nearestOf(word, known).empty())
      problems.push_back(
          {withGuess(words("There is no block “{word}”.", {{"word", shortened(word)}}), word, known),
           lesson.file, piece.lineAt(place), piece.field});
  }
}

/// What in a lesson's words would not be seen as it is meant: formulas that cannot be read, each with its
/// line and the column within it, and pictures.
void addUnreadable(const Lesson &lesson, std::vector<Problem> &problems) {
  for (const LessonWords &piece : wordsOf(lesson)) {
    addBlocksNearlyKnown(piece, lesson, problems);
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

} // namespace

Checked checkLessons(const std::filesystem::path &fileOrFolder) {
  LessonLibrary library = libraryOf(fileOrFolder);
  Checked checked{library.lessons.size(), std::move(library.problems)};
  for (const Lesson &lesson : library.lessons) {
    addUnreadable(lesson, checked.problems);
    std::ranges::move(problemsWithNames(lesson), std::back_inserter(checked.problems));
  }
  std::stable_sort(checked.problems.begin(), checked.problems.end(), [](const Problem &a, const Problem &b) {
    return std::tie(a.file, a.line) < std::tie(b.file, b.line);
  });
  return checked;
}

} // namespace halfspace
