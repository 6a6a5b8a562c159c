#include "lessons/lesson/lesson_draft.h"

#include "lessons/lesson/condition.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Without white space around it, each line ended by one sign alone.
std::string withPlainLines(std::string text) {
  text = replacedAll(std::move(text), "\r\n", "\n");
  for (const char *end : {"\r", "\u2028", "\u2029"})
    text = replacedAll(std::move(text), end, "\n");
  return std::string(trimmed(text));
}

/// … and without tabs and lines of white space.
std::string tidiedText(std::string text) {
  text = replacedAll(withPlainLines(std::move(text)), "\t", " ");
  std::string tidy;
  for (std::string_view rest = text;;) {
    const auto end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    tidy += trimmed(line).empty() ? std::string_view() : line;
    if (end == std::string_view::npos)
      return tidy;
    tidy += '\n';
    rest.remove_prefix(end + 1);
  }
}

void tidy(std::string &text) { text = tidiedText(std::move(text)); }

void tidy(DraftStep &step) {
  tidy(step.title);
  step.words = withPlainLines(std::move(step.words));
  if (step.question) {
    tidy(step.question->ask);
    tidy(step.question->why);
    for (DraftChoice &choice : step.question->choices)
      tidy(choice.text);
  }
  if (step.task) {
    tidy(step.task->instruction);
    tidy(step.task->condition);
    if (const auto conditions = parseConditions(step.task->condition))
      step.task->condition = toText(*conditions);
  }
}

/// Why a title cannot be one; empty where it can.
std::string whyNoTitle(const std::string &title) {
  if (title.find('\n') != std::string::npos)
    return words("A title stands on one line.");
  return printable(title) == title ? std::string()
                                   : words("In the title is a character that nobody sees: write it again.");
}

std::string whyNotText(const std::string &text) {
  return firstNoText(text) ? words("In “{text}” is a character that nobody sees: write it again.",
                                   {{"text", shortened(printable(text))}})
                           : std::string();
}

/// Whether a step has these words and nothing else.
bool isWordsAlone(const LessonStep &step, const std::string &words) {
  const auto *own = step.blocks.empty() ? nullptr : std::get_if<StepWords>(&step.blocks.front());
  const bool areThere = words.empty() ? step.blocks.size() == 1
                                      : step.blocks.size() == 2 && own && own->text.written() == words;
  return areThere && !step.blank && !step.drawsAllResults && step.drawn.empty() && step.hidden.empty() &&
         step.terms.empty() && step.formulas.empty();
}

/// Why words would be read as something else; empty where they would not.
std::string whyNotWords(const std::string &text) {
  if (std::string sentence = whyNotText(text); !sentence.empty())
    return sentence;
  const auto read = parseLesson("---\nid: words\ntitle: Words\nscene: []\n---\n## Words\n" + text + "\n", "");
  if (!read)
    return read.problem().sentence;
  if (read->steps.size() > 1)
    return words(
        "A line that begins with ## begins a step: add one, or write ### for a heading among words.");
  return isWordsAlone(read->steps.front(), text)
             ? std::string()
             : words("Among the words stands a block that is an instruction in lessons: what it says has its "
                     "own place here.");
}

/// Gathers what is wrong with a draft.
class DraftCheck {
public:
  std::vector<DraftProblem> of(const LessonDraft &draft) {
    require(draft.title, words("The lesson has no title."));
    complain(whyNoTitle(draft.title));
    if (draft.steps.empty())
      complain(words("The lesson has no step."));
    for (std::size_t place = 0; place < draft.steps.size(); ++place) {
      m_step = place;
      check(draft.steps[place]);
    }
    return std::move(m_problems);
  }

private:
  void complain(const std::string &sentence) {
    if (!sentence.empty())
      m_problems.push_back({m_step, sentence});
  }
  void require(const std::string &text, const std::string &sentence) {
    complain(text.empty() ? sentence : whyNotText(text));
  }

  void check(const DraftStep &step) {
    if (step.title.empty())
      complain(words("The step has no title."));
    complain(whyNoTitle(step.title));
    complain(whyNotWords(step.words));
    if (step.question)
      check(*step.question);
    if (step.task)
      check(*step.task);
  }
  void check(const DraftQuestion &question) {
    require(question.ask, words("The question has no words."));
    if (question.value.empty())
      complain(words("Nothing decides the question: choose a value."));
    for (const DraftChoice &choice : question.choices)
      require(choice.text, words("The answer “{word}” has no words.", {{"word", choice.word}}));
    require(question.why, words("Nothing tells why the answer is right."));
  }
  void check(const DraftTask &task) {
    require(task.instruction, words("The task does not say what to do."));
    require(task.condition, words("The task does not say when it is done."));
  }

  std::optional<std::size_t> m_step;
  std::vector<DraftProblem> m_problems;
};

} // namespace

LessonDraft tidied(LessonDraft draft) {
  tidy(draft.title);
  for (DraftStep &step : draft.steps)
    tidy(step);
  return draft;
}

std::vector<DraftProblem> problemsOf(const LessonDraft &draft) { return DraftCheck().of(tidied(draft)); }

} // namespace halfspace
