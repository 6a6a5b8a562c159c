#include "app/check.h"

#include "lessons/guess.h"
#include "lessons/lesson/lesson_words.h"
#include "lessons/lesson/name_check.h"
#include "lessons/lesson/words_check.h"
#include "lessons/text.h"
#include "lessons/words.h"
#include "widgets/formula/read_latex.h"
#include "widgets/text/picture_object.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
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

void addIfUnreadable(const MarkdownFormula::Side &formula, const LessonWords &piece, const Lesson &lesson,
                     std::vector<Problem> &problems) {
  const auto read = math::readLatex(formula.text, piece.isOnPage ? lesson.macros : Macros());
  const auto *error = std::get_if<math::ReadError>(&read);
  if (error)
    problems.push_back(
        {words("In “{formula}”, column {column}: {sentence}", {{"formula", shortened(formula.text)},
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

void addIfNotShown(const std::string &picture, const LessonWords &piece, const Lesson &lesson,
                   const LessonPictures &ofPage, std::vector<Problem> &problems) {
  const std::string &written = piece.text.written();
  if (const auto image = readPicture(ofPage, picture); !image)
    problems.push_back({image.problem().sentence, lesson.file,
                        piece.lineAt(std::min(written.find(picture), written.size())), piece.field});
}

/// What in a piece of words would not be seen as it is meant: formulas that cannot be read, each with its
/// line and the column within it, and pictures.
void addUnreadable(const LessonWords &piece, const Lesson &lesson, const LessonPictures &ofPage,
                   std::vector<Problem> &problems) {
  const Markdown &markdown = piece.text.markdown();
  for (const MarkdownFormula &formula : markdown.formulas)
    for (const MarkdownFormula::Side &side : formula.sides)
      if (!side.isLive)
        addIfUnreadable(side, piece, lesson, problems);
  std::vector<std::string> pictures;
  if (piece.showsPictures)
    addPictures(markdown.blocks, pictures);
  for (const std::string &picture : pictures)
    addIfNotShown(picture, piece, lesson, ofPage, problems);
}

/// Step by step, as each has a page of its own, with room for its pictures.
void addUnreadable(const Lesson &lesson, std::vector<Problem> &problems) {
  for (const LessonStep &step : lesson.steps) {
    const LessonPictures ofPage{std::filesystem::path(lesson.file).parent_path()};
    for (const LessonWords &piece : wordsOf(step))
      addUnreadable(piece, lesson, ofPage, problems);
  }
}

using Ids = std::set<std::string>;

Ids idsOf(const LessonLibrary &library) {
  Ids ids;
  for (const Lesson &lesson : library.lessons)
    ids.insert(lesson.id);
  for (const Problem &problem : library.problems) // of a lesson that cannot be read, but may well be needed
    ids.insert(std::filesystem::path(problem.file).stem().string());
  return ids;
}

/// Holds lessons against the others that there are: those of their folder and the program's own.
class LibraryCheck {
public:
  LibraryCheck(const Ids &beside, const LessonLibrary &ours) : m_ours(ours), m_ids(idsOf(ours)) {
    const auto known =
        std::ranges::count_if(m_ids, [&](const std::string &id) { return beside.contains(id); });
    // A folder with most of the program's lessons is where they come from.
    m_isOurs = 2 * static_cast<std::size_t>(known) > m_ids.size();
    m_ids.insert(beside.begin(), beside.end());
  }

  void addProblems(const Lesson &lesson, std::vector<Problem> &problems) const {
    if (!m_isOurs && m_ours.find(lesson.id))
      problems.push_back(
          {words("A lesson of the program has the id “{id}” already, and this one would be left "
                 "out beside it. Give it its own.",
                 {{"id", lesson.id}}),
           lesson.file, lesson.idLine, "id"});
    for (const Need &need : lesson.needs)
      if (const std::string sentence = whyNotNeeded(need.id, lesson); !sentence.empty())
        problems.push_back({sentence, lesson.file, need.line, "needs"});
  }

private:
  /// Why a lesson cannot need the one with this id; empty where it can.
  [[nodiscard]] std::string whyNotNeeded(const std::string &id, const Lesson &lesson) const {
    if (id == lesson.id)
      return words("The lesson cannot come before itself. Take this id away.");
    if (m_ids.contains(id))
      return {};
    return withGuess(words("There is no lesson “{id}”.", {{"id", shortened(id)}}), id,
                     std::vector(m_ids.begin(), m_ids.end()));
  }

  const LessonLibrary &m_ours;
  Ids m_ids;
  bool m_isOurs = false;
};

/// The ids of the lessons of folders. Each is read once.
class FolderIds {
public:
  const Ids &of(const std::filesystem::path &folder) {
    const auto [found, isNew] = m_ids.try_emplace(folder.empty() ? "." : folder);
    if (isNew)
      found->second = idsOf(readLessons(found->first));
    return found->second;
  }

private:
  std::map<std::filesystem::path, Ids> m_ids;
};

void check(const LessonLibrary &library, const LibraryCheck &libraryCheck, Checked &checked) {
  std::vector<Problem> problems = library.problems;
  for (const Lesson &lesson : library.lessons) {
    libraryCheck.addProblems(lesson, problems);
    std::ranges::move(problemsIn(lesson), std::back_inserter(problems));
  }
  std::ranges::stable_sort(problems, {}, [](const Problem &each) { return std::tie(each.file, each.line); });
  checked.lessons += library.lessons.size();
  std::ranges::move(problems, std::back_inserter(checked.problems));
}

} // namespace

std::vector<Problem> problemsIn(const Lesson &lesson) {
  std::vector<Problem> problems = problemsWithWords(lesson);
  addUnreadable(lesson, problems);
  std::ranges::move(problemsWithNames(lesson), std::back_inserter(problems));
  std::ranges::stable_sort(problems, {}, &Problem::line);
  return problems;
}

Checked checkLessons(const std::vector<std::filesystem::path> &filesAndFolders, const LessonLibrary &ours) {
  Checked checked;
  FolderIds folders;
  for (const std::filesystem::path &path : filesAndFolders) {
    const LessonLibrary library = libraryOf(path);
    check(library, LibraryCheck(isFolder(path) ? idsOf(library) : folders.of(path.parent_path()), ours),
          checked);
  }
  return checked;
}

} // namespace halfspace
