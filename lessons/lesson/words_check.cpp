#include "lessons/lesson/words_check.h"

#include "lessons/guess.h"
#include "lessons/lesson/lesson_markup.h"
#include "lessons/lesson/lesson_words.h"
#include "lessons/reading/yaml_hint.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <regex>

namespace halfspace {
namespace {

/// Goes through the lines of words.
class LinesCheck {
public:
  LinesCheck(const StepWords &block, const std::string &file, std::vector<Problem> &problems)
      : m_block(block), m_file(file), m_problems(problems), m_lines(block.text.written(), 0) {}

  void lookThroughStep() {
    while (m_lines.next())
      if (!passCode())
        complain(whyNoStep(m_lines.line()));
  }

  /// No step was to begin inside of one.
  void lookThroughNote() {
    while (m_lines.next())
      passCode();
  }

private:
  void complain(const std::string &sentence) {
    if (!sentence.empty())
      m_problems.push_back(
          {sentence, m_file, m_block.lines.at(static_cast<std::size_t>(m_lines.number())), ""});
  }

  /// Goes on behind a block of code, if one begins here. It was perhaps meant to be an instruction: ```tusk.
  bool passCode() {
    const std::string_view opening = fenceOf(m_lines.line());
    if (opening.empty())
      return false;
    const std::string word(wordOfFence(m_lines.line()));
    if (!nearestOf(word, instructionBlocks()).empty())
      complain(withGuess(words("There is no block “{word}”.", {{"word", shortened(word)}}), word,
                         instructionBlocks()));
    while (m_lines.next() && !closes(m_lines.line(), opening)) {
    }
    return true;
  }

  const StepWords &m_block;
  const std::string &m_file;
  std::vector<Problem> &m_problems;
  LineScanner m_lines;
};

/// One of each paragraph: where one is missing, two may be without a partner.
void addLoneDollars(const LessonWords &piece, const std::string &file, std::vector<Problem> &problems) {
  const std::string &text = piece.text.written();
  std::optional<std::size_t> before;
  for (const std::size_t place : piece.text.markdown().loneDollars) {
    if (!before || text.substr(*before, place - *before).find("\n\n") != std::string::npos)
      problems.push_back(
          {words("This $ has no partner in its paragraph. End the formula with another, without "
                 "a space before it, or write \\$ for a dollar."),
           file, piece.lineAt(place), piece.field});
    before = place;
  }
}

/// What YAML's signs leave of LaTeX in double quotes, beside control characters: a tab of `\theta`, the end
/// of a line of `\rho`, and rarer ones of `\Lambda` and `\Pi`, and of `\nu` within a formula.
const std::regex &leftoversOfLatex() {
  static const std::regex leftovers("\t|\r(?!\n)|\u2028|\u2029");
  return leftovers;
}

/// LaTeX in double quotes may read as YAML all the same: `"\theta"` begins with a tab, `"\frac"` with the end
/// of a page.
void addIfEscaped(const LessonWords &piece, const std::string &file, std::vector<Problem> &problems) {
  if (piece.field.empty() || piece.field == "note") // Markdown
    return;
  const std::string &text = piece.text.written();
  std::smatch leftover;
  std::size_t place = firstNoText(text).value_or(std::string::npos);
  if (std::regex_search(text, leftover, leftoversOfLatex()))
    place = std::min(place, static_cast<std::size_t>(leftover.position()));
  if (place != std::string::npos)
    problems.push_back({singleQuotesHint(), file, piece.lineAt(place), piece.field});
}

} // namespace

std::vector<Problem> problemsWithWords(const Lesson &lesson) {
  std::vector<Problem> problems;
  for (const LessonStep &step : lesson.steps)
    for (const StepBlock &block : step.blocks)
      if (const auto *words = std::get_if<StepWords>(&block))
        LinesCheck(*words, lesson.file, problems).lookThroughStep();
      else if (const auto *note = std::get_if<StepNote>(&block))
        LinesCheck(note->words, lesson.file, problems).lookThroughNote();
  for (const LessonWords &piece : wordsOf(lesson)) {
    addLoneDollars(piece, lesson.file, problems);
    addIfEscaped(piece, lesson.file, problems);
  }
  return problems;
}

} // namespace halfspace
