#include "lessons/lesson/lesson.h"

#include "lessons/files/read_file.h"
#include "lessons/lesson/lesson_fields.h"
#include "lessons/lesson/lesson_markup.h"
#include "lessons/lesson/lesson_words.h"
#include "lessons/lesson/macro_work.h"
#include "lessons/reading/document.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>
#include <utility>

namespace halfspace {
namespace {

constexpr std::string_view frontMatterFence = "---";

/// A fenced block: its word, its text, and itself as it stands.
struct Fence {
  std::string word;
  TextBlock content;
  std::string whole;
};

/// Whether a line opens the next block while this one is still open. In Markdown it would be of its text, but
/// no instruction is meant to be.
bool opensNext(std::string_view line, std::string_view opening) {
  const auto &known = instructionBlocks();
  return fenceOf(line).starts_with(opening) &&
         std::find(known.begin(), known.end(), wordOfFence(line)) != known.end();
}

Result<Fence> readFence(LineScanner &lines, const std::string &file) {
  const int openedAt = lines.number();
  const std::string opening(fenceOf(lines.line()));
  Fence fence{std::string(wordOfFence(lines.line())), {"", openedAt + 1}, std::string(lines.line()) + "\n"};
  while (lines.next() && !opensNext(lines.line(), opening)) {
    fence.whole += std::string(lines.line()) + "\n";
    if (closes(lines.line(), opening))
      return fence;
    fence.content.text += std::string(lines.line()) + "\n";
  }
  return Problem{
      words("The block that opens here is never closed. End it with a line {fence}.", {{"fence", opening}}),
      file, openedAt, ""};
}

/// Words that are read line by line.
struct GatheredWords {
  std::string text;
  std::vector<int> lines; ///< where each of its lines stands in the file
};

/// A step that is read from top to bottom.
struct OpenStep {
  LessonStep step;
  GatheredWords words; ///< behind its last block
};

void addLine(GatheredWords &words, std::string_view line, int number) {
  words.text += std::string(line) + "\n";
  words.lines.push_back(number);
}

void addLines(GatheredWords &words, const TextBlock &block) {
  LineScanner lines(block.text, block.firstLine);
  while (lines.next())
    addLine(words, lines.line(), lines.number());
}

/// Without empty lines before and behind the words, and what is empty at their ends.
StepWords trimmedWords(GatheredWords words) {
  std::string &text = words.text;
  const auto begin = std::min(text.find_first_not_of(" \t\n"), text.size());
  const auto end = text.find_last_not_of(" \t\n") + 1; // 0 where there is nothing else
  const auto linesBefore = [&](std::size_t place) {
    return std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n');
  };
  words.lines.erase(words.lines.begin(), words.lines.begin() + linesBefore(begin));
  text = begin < end ? text.substr(begin, end - begin) : "";
  if (!text.empty())
    words.lines.resize(static_cast<std::size_t>(linesBefore(text.size())) + 1);
  return {std::move(text), std::move(words.lines)};
}

/// Puts the words, if there are any, where they stand in the step.
void closeWords(OpenStep &open) {
  StepWords words = trimmedWords(std::exchange(open.words, {}));
  if (!words.text.isEmpty())
    open.step.blocks.emplace_back(std::move(words));
}

Result<StepNote> readNote(const TextBlock &block, const std::string &file) {
  LineScanner lines(block.text, block.firstLine);
  StepNote note;
  while (note.title.empty() && lines.next()) {
    note.title = printable(trimmed(lines.line()));
  }
  GatheredWords below;
  addLines(below, {std::string(lines.rest()), lines.number() + 1});
  note.words = trimmedWords(std::move(below));
  if (note.words.text.isEmpty())
    return Problem{words("A note needs a title in its first line, and words below it."), file,
                   block.firstLine - 1, "note"};
  return note;
}

/// Puts what a block holds into its step; or why it cannot be read.
using BlockReader = std::optional<Problem> (*)(const TextBlock &, const std::string &file, OpenStep &);

/// Of what stands on the page, by what reads it.
template <auto read>
std::optional<Problem> addBlock(const TextBlock &block, const std::string &file, OpenStep &open) {
  auto made = read(block, file);
  if (!made)
    return made.problem();
  closeWords(open);
  open.step.blocks.emplace_back(std::move(*made));
  return {};
}

std::optional<Problem> addQuestion(const TextBlock &block, const std::string &file, OpenStep &open) {
  if (predictionOf(open.step))
    return Problem{words("A step asks one question. Move the second into a step of its own."), file,
                   block.firstLine - 1, "predict"};
  return addBlock<readPrediction>(block, file, open);
}

std::optional<Problem> readBlank(const TextBlock &block, const std::string &file, OpenStep &open) {
  const auto fading = readFading(block, file);
  if (!fading)
    return fading.problem();
  open.step.blank = *fading;
  return {};
}

std::optional<Problem> readDrawn(const TextBlock &block, const std::string &file, OpenStep &open) {
  return readMarkIds(block, file, open.step);
}

std::optional<Problem> addHidden(const TextBlock &block, const std::string &file, OpenStep &open) {
  return readHidden(block, file, open.step);
}

std::optional<Problem> addTerm(const TextBlock &block, const std::string &file, OpenStep &open) {
  auto term = readTerm(block, file);
  if (!term)
    return term.problem();
  open.step.terms.push_back(std::move(*term));
  return {};
}

std::optional<Problem> addFormulas(const TextBlock &block, const std::string &file, OpenStep &open) {
  GatheredWords gathered;
  addLines(gathered, block);
  StepWords formulas = trimmedWords(std::move(gathered));
  if (formulas.text.isEmpty())
    return Problem{words("Here formulas and words are expected that are to be kept of the lesson."), file,
                   block.firstLine - 1, "formulas"};
  open.step.formulas.push_back(std::move(formulas));
  return {};
}

/// A sort of blocks that are no code, by the word behind their fence.
struct Instruction {
  std::string_view word;
  BlockReader read;
};

constexpr std::array instructions{Instruction{"lines", &addBlock<readLines>},
                                  Instruction{"note", &addBlock<readNote>},
                                  Instruction{"task", &addBlock<readTask>},
                                  Instruction{"predict", &addQuestion},
                                  Instruction{"flight", &addBlock<readFlight>},
                                  Instruction{"fragments", &addBlock<readFragments>},
                                  Instruction{"cost", &addBlock<readCost>},
                                  Instruction{"blank", &readBlank},
                                  Instruction{"term", &addTerm},
                                  Instruction{"formulas", &addFormulas},
                                  Instruction{"draw", &readDrawn},
                                  Instruction{"hide", &addHidden}};

/// Puts a fenced block where it belongs in the step.
std::optional<Problem> addFence(const Fence &fence, OpenStep &open, const std::string &file) {
  for (const Instruction &instruction : instructions)
    if (instruction.word == fence.word)
      return instruction.read(fence.content, file, open);
  addLines(open.words, {fence.whole, fence.content.firstLine - 1}); // code
  return {};
}

/// Splits the file at the end of its front matter.
struct LessonParts {
  TextBlock frontMatter;
  TextBlock body;
};

Result<LessonParts> splitFrontMatter(std::string_view text, const std::string &file) {
  LineScanner lines(text, 1);
  if (!lines.next() || trimmed(lines.line()) != frontMatterFence)
    return Problem{words("A lesson begins with a line --- and its id, title and scene below it."), file, 1,
                   ""};
  TextBlock frontMatter{"", 2};
  while (lines.next()) {
    if (trimmed(lines.line()) == frontMatterFence)
      return LessonParts{frontMatter, {std::string(lines.rest()), lines.number() + 1}};
    frontMatter.text += std::string(lines.line()) + "\n";
  }
  return Problem{words("The head that opens here has no end. Put a line --- between it and the first step."),
                 file, 1, ""};
}

/// Why words above the first step cannot stand there.
std::string whyAboveAll(std::string_view line) {
  const std::string sentence = whyNoStep(line);
  return sentence.empty() ? words("These words belong to no step. Put a heading ## above them.") : sentence;
}

/// Where a step says nothing of lines, all stand behind its first words.
void addAllLines(LessonStep &step) {
  const auto isLines = [](const StepBlock &block) { return std::holds_alternative<StepLines>(block); };
  if (std::any_of(step.blocks.begin(), step.blocks.end(), isLines))
    return;
  const bool hasWords = !step.blocks.empty() && std::holds_alternative<StepWords>(step.blocks.front());
  step.blocks.insert(step.blocks.begin() + (hasWords ? 1 : 0), StepLines());
}

LessonStep finished(OpenStep open) {
  closeWords(open);
  addAllLines(open.step);
  return std::move(open.step);
}

std::string_view withoutByteOrderMark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

Problem tooLarge(const std::string &file) {
  return {words("The file is too large to be a lesson: at most {limit} KiB are read.",
                {{"limit", std::to_string(maxLessonBytes >> 10)}}),
          file, 0, ""};
}

std::size_t bytesFromMacros(const Markdown &markdown, const Macros &macros) {
  std::size_t bytes = 0;
  for (const MarkdownFormula &formula : markdown.formulas)
    bytes += bytesFromMacros(writtenIn(formula), macros);
  return bytes;
}

/// What has kept a lesson's words from being read as Markdown, or makes them too much to be set, if anything
/// has.
std::optional<Problem> problemOfWords(const Lesson &lesson) {
  std::size_t fromMacros = 0;
  for (const LessonWords &piece : wordsOf(lesson)) {
    if (const auto &problem = piece.text.problem())
      return Problem{problem->sentence, lesson.file, piece.lineAt(0), piece.field};
    fromMacros += bytesFromMacros(piece.text.markdown(), lesson.macros);
    if (fromMacros > mostBytesFromMacros)
      return Problem{
          words("Up to here the lesson's macros stand for more than {limit} KiB of LaTeX: that is too "
                "much to be set.",
                {{"limit", std::to_string(mostBytesFromMacros >> 10)}}),
          lesson.file, piece.lineAt(0), piece.field};
  }
  return {};
}

/// Reads all that follows the front matter.
Result<std::vector<LessonStep>> readSteps(const TextBlock &block, const std::string &file) {
  std::vector<OpenStep> steps;
  LineScanner lines(block.text, block.firstLine);
  while (lines.next()) {
    const auto title = stepTitle(lines.line());
    if (title) {
      steps.emplace_back().step.title = *title;
      continue;
    }
    if (steps.empty()) {
      if (!trimmed(lines.line()).empty())
        return Problem{whyAboveAll(lines.line()), file, lines.number(), ""};
      continue;
    }
    if (fenceOf(lines.line()).empty()) {
      addLine(steps.back().words, lines.line(), lines.number());
      continue;
    }
    const auto fence = readFence(lines, file);
    if (!fence)
      return fence.problem();
    if (const auto problem = addFence(*fence, steps.back(), file))
      return *problem;
  }
  if (steps.empty())
    return Problem{words("The lesson has no steps. Each begins with a heading ##."), file, lines.number(),
                   ""};
  std::vector<LessonStep> read;
  read.reserve(steps.size());
  for (OpenStep &step : steps)
    read.push_back(finished(std::move(step)));
  return read;
}

} // namespace

const std::vector<std::string> &instructionBlocks() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    all.reserve(instructions.size());
    for (const Instruction &instruction : instructions)
      all.emplace_back(instruction.word);
    return all;
  }();
  return names;
}

Result<Lesson> parseLesson(std::string_view text, const std::string &file) {
  if (text.size() > maxLessonBytes)
    return tooLarge(file);
  if (const auto at = firstNoText(text))
    return Problem{notText(), file, lineAt(text, *at), ""};
  const auto parts = splitFrontMatter(withoutByteOrderMark(text), file);
  if (!parts)
    return parts.problem();
  auto lesson = readFrontMatter(parts->frontMatter, file);
  if (!lesson)
    return lesson;
  auto steps = readSteps(parts->body, file);
  if (!steps)
    return steps.problem();
  lesson->steps = std::move(*steps);
  lesson->file = file;
  lesson->text = text;
  if (auto problem = problemOfWords(*lesson))
    return std::move(*problem);
  return lesson;
}

Result<Lesson> readLesson(const std::filesystem::path &file) {
  const auto text = readFile(file, maxLessonBytes);
  return text ? parseLesson(*text, file.string()) : Result<Lesson>(text.problem());
}

namespace {

/// The first block of a sort; null where there is none.
template <class Block> const Block *firstBlock(const LessonStep &step) {
  for (const StepBlock &block : step.blocks)
    if (const auto *found = std::get_if<Block>(&block))
      return found;
  return nullptr;
}

} // namespace

const StepFlight *flightOf(const LessonStep &step) { return firstBlock<StepFlight>(step); }

const Prediction *predictionOf(const LessonStep &step) { return firstBlock<Prediction>(step); }

std::vector<Task> tasksOf(const LessonStep &step) {
  std::vector<Task> tasks;
  for (const StepBlock &block : step.blocks)
    if (const auto *task = std::get_if<Task>(&block))
      tasks.push_back(*task);
  return tasks;
}

const LessonStep &stepOf(const Lesson &lesson, int step) {
  static const LessonStep everything{{}, {StepLines()}};
  const auto index = static_cast<std::size_t>(step);
  return index < lesson.steps.size() ? lesson.steps[index] : everything;
}

} // namespace halfspace
