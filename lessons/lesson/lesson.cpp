#include "lessons/lesson/lesson.h"

#include "lessons/files/read_file.h"
#include "lessons/lesson/lesson_fields.h"
#include "lessons/lesson/lesson_markup.h"
#include "lessons/lesson/macro_work.h"
#include "lessons/reading/document.h"
#include "lessons/reading/markdown.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>

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

/// The words that a step goes on with.
StepWords &wordsAtEnd(LessonStep &step) {
  if (step.blocks.empty() || !std::holds_alternative<StepWords>(step.blocks.back()))
    step.blocks.emplace_back(StepWords());
  return std::get<StepWords>(step.blocks.back());
}

void addLine(StepWords &words, std::string_view line, int number) {
  words.markdown += std::string(line) + "\n";
  words.lines.push_back(number);
}

void addLines(StepWords &words, const TextBlock &block) {
  LineScanner lines(block.text, block.firstLine);
  while (lines.next())
    addLine(words, lines.line(), lines.number());
}

/// Takes away empty lines before and behind the words, and what is empty at their ends.
void trimEnds(StepWords &words) {
  std::string &markdown = words.markdown;
  const auto begin = std::min(markdown.find_first_not_of(" \t\n"), markdown.size());
  const auto end = markdown.find_last_not_of(" \t\n") + 1; // 0 where there is nothing else
  const auto linesBefore = [&](std::size_t place) {
    return std::count(markdown.begin(), markdown.begin() + static_cast<std::ptrdiff_t>(place), '\n');
  };
  words.lines.erase(words.lines.begin(), words.lines.begin() + linesBefore(begin));
  markdown = begin < end ? markdown.substr(begin, end - begin) : "";
  if (!markdown.empty())
    words.lines.resize(static_cast<std::size_t>(linesBefore(markdown.size())) + 1);
}

Result<StepNote> readNote(const TextBlock &block, const std::string &file) {
  LineScanner lines(block.text, block.firstLine);
  StepNote note;
  while (note.title.empty() && lines.next()) {
    note.title = printable(trimmed(lines.line()));
  }
  addLines(note.words, {std::string(lines.rest()), lines.number() + 1});
  trimEnds(note.words);
  if (note.words.markdown.empty())
    return Problem{words("A note needs a title in its first line, and words below it."), file,
                   block.firstLine - 1, "note"};
  return note;
}

/// Puts what a block holds into its step; or why it cannot be read.
using BlockReader = std::optional<Problem> (*)(const TextBlock &, const std::string &file, LessonStep &);

/// Of what stands on the page, by what reads it.
template <auto read>
std::optional<Problem> addBlock(const TextBlock &block, const std::string &file, LessonStep &step) {
  auto made = read(block, file);
  if (!made)
    return made.problem();
  step.blocks.emplace_back(std::move(*made));
  return {};
}

std::optional<Problem> addQuestion(const TextBlock &block, const std::string &file, LessonStep &step) {
  if (predictionOf(step))
    return Problem{words("A step asks one question. Move the second into a step of its own."), file,
                   block.firstLine - 1, "predict"};
  return addBlock<readPrediction>(block, file, step);
}

std::optional<Problem> readBlank(const TextBlock &block, const std::string &file, LessonStep &step) {
  const auto fading = readFading(block, file);
  if (!fading)
    return fading.problem();
  step.blank = *fading;
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
                                  Instruction{"draw", &readMarkIds}};

/// Puts a fenced block where it belongs in the step.
std::optional<Problem> addFence(const Fence &fence, LessonStep &step, const std::string &file) {
  for (const Instruction &instruction : instructions)
    if (instruction.word == fence.word)
      return instruction.read(fence.content, file, step);
  addLines(wordsAtEnd(step), {fence.whole, fence.content.firstLine - 1}); // code
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

bool isEmptyWords(const StepBlock &block) {
  const auto *words = std::get_if<StepWords>(&block);
  return words && words->markdown.empty();
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

void finish(LessonStep &step) {
  for (StepBlock &block : step.blocks)
    if (auto *words = std::get_if<StepWords>(&block))
      trimEnds(*words);
  std::erase_if(step.blocks, isEmptyWords);
  addAllLines(step);
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

/// What keeps a lesson's words from being read as Markdown, or makes them too much to be set, if anything
/// does.
std::optional<Problem> problemOfWords(const Lesson &lesson) {
  std::size_t fromMacros = 0;
  for (const LessonWords &piece : wordsOf(lesson)) {
    const auto markdown = readMarkdown(piece.text);
    if (!markdown)
      return Problem{markdown.problem().sentence, lesson.file, piece.lineAt(0), piece.field};
    fromMacros += bytesFromMacros(*markdown, lesson.macros);
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
  std::vector<LessonStep> steps;
  LineScanner lines(block.text, block.firstLine);
  while (lines.next()) {
    const auto title = stepTitle(lines.line());
    if (title) {
      steps.emplace_back().title = *title;
      continue;
    }
    if (steps.empty()) {
      if (!trimmed(lines.line()).empty())
        return Problem{whyAboveAll(lines.line()), file, lines.number(), ""};
      continue;
    }
    if (fenceOf(lines.line()).empty()) {
      addLine(wordsAtEnd(steps.back()), lines.line(), lines.number());
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
  for (LessonStep &step : steps)
    finish(step);
  return steps;
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
  if (auto problem = problemOfWords(*lesson))
    return std::move(*problem);
  return lesson;
}

Result<Lesson> readLesson(const std::filesystem::path &file) {
  const auto text = readFile(file, maxLessonBytes);
  return text ? parseLesson(*text, file.string()) : Result<Lesson>(text.problem());
}

int LessonWords::lineAt(std::size_t place) const {
  const auto passed = std::ranges::lower_bound(lineEnds, place) - lineEnds.begin();
  return lines.empty() ? 0 : lines[std::min(static_cast<std::size_t>(passed), lines.size() - 1)];
}

LessonWords::LessonWords(std::string words, std::vector<int> linesOfWords, std::string fieldOfWords)
    : text(std::move(words)), lines(std::move(linesOfWords)), field(std::move(fieldOfWords)) {
  for (auto end = text.find('\n'); end != std::string::npos; end = text.find('\n', end + 1))
    lineEnds.push_back(end);
}

std::vector<LessonWords> wordsOf(const LessonStep &step) {
  std::vector<LessonWords> words;
  const Overloaded add{
      [&](const StepWords &block) { words.emplace_back(block.markdown, block.lines, ""); },
      [](const StepLines &) {},
      [](const StepFlight &) {},
      [](const StepFragments &) {},
      [](const StepCost &) {},
      [&](const StepNote &note) { words.emplace_back(note.words.markdown, note.words.lines, "note"); },
      [&](const Task &task) {
        words.emplace_back(task.instruction, std::vector{task.line}, "do");
        if (!task.now.empty())
          words.emplace_back(task.now, std::vector{task.nowLine}, "now");
        if (!task.answer.empty())
          words.emplace_back(task.answer, std::vector{task.answerLine}, "done");
      },
      [&](const Prediction &prediction) {
        words.emplace_back(prediction.question, std::vector{prediction.questionLine}, "ask");
        for (const Prediction::Choice &choice : prediction.choices)
          words.emplace_back(choice.text, std::vector{choice.line}, "choices");
        words.emplace_back(prediction.reason, std::vector{prediction.reasonLine}, "why");
      }};
  for (const StepBlock &block : step.blocks)
    std::visit(add, block);
  return words;
}

std::vector<LessonWords> wordsOf(const Lesson &lesson) {
  std::vector<LessonWords> words;
  for (const LessonStep &step : lesson.steps)
    for (LessonWords &piece : wordsOf(step))
      words.push_back(std::move(piece));
  return words;
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
