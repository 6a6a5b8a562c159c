#include "widgets/handout/handout_text.h"

#include "lessons/lesson/live_values.h"
#include "lessons/lesson/shown.h"
#include "lessons/words.h"
#include "widgets/exports/append.h"
#include "widgets/exports/paper_look.h"
#include "widgets/handout/markdown_blocks.h"
#include "widgets/handout/worked_lines.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// Wider figures would be larger than their words are worth, in points.
constexpr double widestFigure = 10 * pointsPerCentimetre;
/// Narrower figures do not stand beside each other.
constexpr double leastFigure = 6 * pointsPerCentimetre;
/// No figure is higher than this part of a column.
constexpr double highestFigure = 0.34;
/// Labels are a little smaller than running text.
constexpr double labelType = 0.9;
/// So many lines are left to write an answer.
constexpr int linesToWrite = 4;

constexpr const char *openBox = "□";
constexpr const char *rightBox = "✓";

/// A paragraph that begins with bold words.
ParagraphBlock labelled(const std::string &label, InlineText text) {
  text.insert(text.begin(), StyledWords{label + " ", {.strong = true}});
  return {std::move(text)};
}

/// Whether a paragraph leads to what comes next.
bool endsWithColon(const HandoutBlock &block) {
  const auto *paragraph = std::get_if<ParagraphBlock>(&block.content);
  if (!paragraph || paragraph->text.empty())
    return false;
  const InlinePiece &last = paragraph->text.back();
  const auto *words = std::get_if<StyledWords>(&last);
  const auto *formula = std::get_if<InlineFormula>(&last);
  return (words && words->text.ends_with(':')) || (formula && formula->plain.ends_with(':'));
}

class HandoutMaker {
public:
  HandoutMaker(const HandoutRequest &request, const HandoutLook &look, const math::MathFonts &fonts)
      : m_request(request), m_look(look),
        m_theme(*findTheme("print")), m_setting{fonts, request.lesson.macros,
                                                [this](const std::string &mark) { return inkOf(mark); }} {}

  HandoutText make() {
    const Lesson &lesson = m_request.lesson;
    HandoutText handout;
    handout.title = lesson.title;
    handout.front.push_back({HeadingBlock{1, "", inlineText(lesson.title, {.strong = true}), lesson.title}});
    if (!lesson.chapter.empty())
      handout.front.push_back({ParagraphBlock{inlineText(lesson.chapter, {.emphasized = true})}});
    for (const std::size_t step : m_request.steps) {
      m_step = &lesson.steps[step];
      const std::string &title = m_step->title;
      handout.body.push_back(
          {HeadingBlock{2, std::to_string(step + 1), inlineText(title, {.strong = true}), title}, true});
      append(handout.body, stepBlocks());
    }
    return handout;
  }

private:
  /// The colour of a mark that is drawn. So none gives the answer away while a question is open.
  [[nodiscard]] std::optional<Color> inkOf(const std::string &id) const {
    const Mark *mark = findMark(m_shown.figure, id);
    return mark ? std::optional(m_theme.inkOf(hueOf(baseOf(*mark)))) : std::nullopt;
  }

  /// Whether the step's question is not answered.
  [[nodiscard]] bool isOpen() const { return !m_request.hasAnswers && predictionOf(*m_step); }
  /// Whether numbers are to be found by the learner: then nothing else tells them.
  [[nodiscard]] bool withholds() const { return isOpen() || !m_fade.gaps.empty(); }

  HandoutBlocks stepBlocks() {
    m_shown = shownIn(*m_step, m_request.evaluation, isOpen() ? Question::Open : Question::Answered);
    m_fade = fadeOfStep();
    if (withholds())
      m_shown.figure = withoutNumbers(std::move(m_shown.figure));
    m_line = 0;
    m_block = 0;
    HandoutBlocks blocks;
    for (const StepBlock &block : m_step->blocks)
      std::visit([&](const auto &each) { add(each, blocks); }, block);
    addFigure(blocks);
    return blocks;
  }

  [[nodiscard]] Fade fadeOfStep() const {
    if (m_request.hasAnswers)
      return {};
    if (isOpen())
      return withheld(m_shown.working);
    return fade(m_shown.working, m_step->blank.value_or(Fading::None), {});
  }

  [[nodiscard]] FilledMarkdown filled(const MarkdownText &text) const {
    const LiveValues values = withholds() ? LiveValues::Hidden : LiveValues::Shown;
    return filledIn(text.markdown(), [&](const std::string &name) {
      return liveValue(name, m_request.evaluation.scene, m_request.evaluation, values);
    });
  }
  [[nodiscard]] InlineText sentence(const MarkdownText &text) const {
    return oneParagraph(filled(text), m_setting);
  }

  /// Of a question, whose words hold whatever the scene is.
  [[nodiscard]] InlineText sentenceAsWritten(const MarkdownText &text) const {
    return oneParagraph(withNames(text.markdown()), m_setting);
  }

  void add(const StepWords &words, HandoutBlocks &blocks) {
    append(blocks, handoutBlocks(filled(words.text), m_setting));
  }

  void add(const StepLines &, HandoutBlocks &blocks) {
    const std::size_t begin = m_line;
    m_line += m_shown.linesIn.at(m_block++);
    if (!blocks.empty() && endsWithColon(blocks.back()))
      blocks.back().keepsWithNext = true;
    append(blocks, workedLines({m_shown.working, begin, m_line}, m_fade, m_setting));
  }

  /// In a step that leaves its lines to the learner a note has the answer to what is asked there.
  void add(const StepNote &note, HandoutBlocks &blocks) {
    const bool isAnswer = m_step->blank.value_or(Fading::None) != Fading::None;
    if (isAnswer && !m_request.hasAnswers) {
      if (!blocks.empty())
        blocks.back().keepsWithNext = true;
      blocks.push_back({RoomBlock{linesToWrite}});
    } else {
      blocks.push_back({NoteBlock{inlineText(note.title, {.strong = true}),
                                  handoutBlocks(filled(note.words.text), m_setting)}});
    }
  }

  void add(const Task &task, HandoutBlocks &blocks) {
    const std::string label = words("Exercise {number}.", {{"number", std::to_string(++m_counts.tasks)}});
    blocks.push_back({labelled(label, sentence(task.instruction))});
    if (!m_request.hasAnswers || task.answer.isEmpty())
      return;
    blocks.back().keepsWithNext = true;
    blocks.push_back({labelled(words("Answer:"), sentence(task.answer))});
  }

  void add(const Prediction &prediction, HandoutBlocks &blocks) {
    const std::string label = words("Question {number}.", {{"number", std::to_string(++m_counts.questions)}});
    blocks.push_back({labelled(label, sentenceAsWritten(prediction.question)), true});
    const std::string right =
        m_request.hasAnswers ? rightChoice(prediction, m_request.evaluation) : std::string();
    ListBlock choices;
    for (const Prediction::Choice &choice : prediction.choices)
      choices.items.push_back({!right.empty() && choice.word == right ? rightBox : openBox,
                               {{ParagraphBlock{sentenceAsWritten(choice.text)}}}});
    blocks.push_back({std::move(choices)});
    if (m_request.hasAnswers)
      blocks.push_back({labelled(words("Answer:"), sentenceAsWritten(prediction.reason))});
  }

  // What is there to be played with has nothing to be printed.
  void add(const StepFlight &, HandoutBlocks &) {}
  void add(const StepFragments &, HandoutBlocks &) {}
  void add(const StepCost &, HandoutBlocks &) {}

  /// The figure stands behind the first block that does not lead to something else. One that was printed
  /// before is named at the beginning.
  void addFigure(HandoutBlocks &blocks) {
    const std::vector<Mark> marks(m_shown.figure.marks.begin(), m_shown.figure.marks.end());
    const auto known = std::find_if(m_printed.begin(), m_printed.end(),
                                    [&](const Printed &printed) { return printed.marks == marks; });
    if (known != m_printed.end()) {
      const std::string number = std::to_string(known->number);
      blocks.insert(blocks.begin(),
                    {ParagraphBlock{inlineText(words("See figure {number}.", {{"number", number}}),
                                               {.emphasized = true}),
                                    TextSize::Small},
                     true});
      return;
    }
    const auto place = std::find_if(blocks.begin(), blocks.end(), [](const HandoutBlock &block) {
      return !block.keepsWithNext && !endsWithColon(block);
    });
    FigureBlock figure = newFigure();
    if (figure.drawings.empty())
      return;
    blocks.insert(place == blocks.end() ? place : place + 1, {std::move(figure)});
    m_printed.push_back({marks, m_counts.figures});
  }

  /// What is to be seen is told below the first of several figures of which the same is true.
  [[nodiscard]] FigureBlock newFigure() {
    const double beside = (m_look.columnWidth() - m_look.leading()) / 2;
    const bool isPair = m_request.lesson.flat && beside >= leastFigure;
    const double width = isPair ? beside : std::min(m_look.columnWidth(), widestFigure);
    FigureBlock figure{drawn(width), descriptionOfFigure(), {}};
    if (figure.drawings.empty())
      return figure; // it has no number
    const std::string label = words("Figure {number}.", {{"number", std::to_string(++m_counts.figures)}});
    figure.caption.emplace_back(StyledWords{label, {.strong = true}});
    if (!withholds() && std::exchange(m_told, figure.description) != figure.description) {
      figure.caption.emplace_back(StyledWords{" "});
      append(figure.caption, inlineText(figure.description));
    }
    return figure;
  }

  /// Figures that would be too high are drawn less wide.
  [[nodiscard]] std::vector<Drawing> drawn(double width) const {
    const double typeSize = labelType * m_look.typeSize;
    std::vector<Drawing> drawings = m_request.drawFigure(m_shown.figure, {width, typeSize});
    double height = 0;
    for (const Drawing &drawing : drawings)
      height = std::max(height, drawing.size.y);
    const double most = highestFigure * m_look.textHeight();
    return height > most ? m_request.drawFigure(m_shown.figure, {width * most / height, typeSize})
                         : std::move(drawings);
  }

  /// While something is to be found nothing is said of what is to be seen.
  [[nodiscard]] std::string descriptionOfFigure() const {
    return withholds() ? words("The scene of the step “{title}”.", {{"title", m_step->title}})
                       : m_shown.description;
  }

  /// How many were told so far.
  struct Counts {
    int tasks = 0;
    int questions = 0;
    int figures = 0;
  };
  /// A figure that stands in the handout already.
  struct Printed {
    std::vector<Mark> marks;
    int number;
  };

  const HandoutRequest &m_request;
  const HandoutLook &m_look;
  Theme m_theme;
  FormulaSetting m_setting;
  const LessonStep *m_step = nullptr; ///< that is being made
  Shown m_shown;                      ///< in it
  Fade m_fade;
  std::size_t m_line = 0;  ///< the first that is not told yet
  std::size_t m_block = 0; ///< likewise, of lines
  std::vector<Printed> m_printed;
  std::string m_told; ///< of the scene, below the last figure that said something of it
  Counts m_counts;
};

} // namespace

HandoutText handoutText(const HandoutRequest &request, const HandoutLook &look,
                        const math::MathFonts &fonts) {
  return HandoutMaker(request, look, fonts).make();
}

} // namespace halfspace
