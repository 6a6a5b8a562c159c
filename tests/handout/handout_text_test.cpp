// What handouts say, and what they leave to the learner.
#include "tests/handout/handouts.h"
#include "widgets/handout/handout_text.h"

#include <algorithm>

namespace halfspace {
namespace {

std::string plain(const InlineText &text) {
  std::string words;
  for (const InlinePiece &piece : text)
    std::visit(Overloaded{[&](const StyledWords &each) { words += each.text; },
                          [&](const InlineFormula &formula) { words += formula.plain; },
                          [&](const LineEnd &) { words += "\n"; }},
               piece);
  return words;
}

std::string plain(const HandoutBlocks &blocks);

std::string plainList(const ListBlock &list) {
  std::string text;
  for (const ListItem &item : list.items)
    text += item.mark + " " + plain(item.blocks);
  return text;
}

std::string plain(const HandoutBlocks &blocks) {
  std::string text;
  const Overloaded add{[&](const HeadingBlock &each) { text += "# " + plain(each.title) + "\n"; },
                       [&](const ParagraphBlock &each) { text += plain(each.text) + "\n"; },
                       [&](const FormulaBlock &each) { text += each.formula.plain + "\n"; },
                       [&](const QuoteBlock &each) { text += plain(each.blocks); },
                       [&](const ListBlock &each) { text += plainList(each); },
                       [&](const NoteBlock &each) { text += plain(each.title) + "\n" + plain(each.blocks); },
                       [&](const FigureBlock &each) { text += plain(each.caption) + "\n"; },
                       [&](const RoomBlock &) { text += "____\n"; },
                       [](const auto &) {}};
  for (const HandoutBlock &block : blocks)
    std::visit(add, block.content);
  return text;
}

Lesson lessonWith(const std::string &steps) {
  auto lesson = parseLesson("---\nid: own\ntitle: Own\nscene:\n"
                            "  - {name: E, plane: {P0: [5, 4, 7], n: [1, 2, 2]}}\n"
                            "  - {name: Q, point: [11, 15, 8]}\n"
                            "  - {name: distance, construction: signed-distance, of: {E: E, Q: Q}}\n---\n" +
                                steps,
                            "own.md");
  EXPECT_TRUE(lesson) << lesson.problem().text();
  return *lesson;
}

std::string textOf(const Lesson &lesson, bool hasAnswers = false) {
  const WholeHandout handout(lesson);
  HandoutRequest request = handout.request();
  request.hasAnswers = hasAnswers;
  return plain(handoutText(request, handoutLook(request.paper, request.columns), math::fonts()).body);
}

bool has(const std::string &text, const std::string &part) { return text.find(part) != std::string::npos; }

const std::string question =
    "## One\n```predict\nask: Where is $Q$?\nanswer: side\nchoices:\n"
    "  positive: Up there\n  negative: Down there\n  on: Within\nwhy: Because.\n```\n"
    "So {f} it is:\n```lines\nf\n```\n";

TEST(HandoutText, OfAQuestion_AsksIt_AndTellsNothing) {
  const std::string text = textOf(lessonWith(question));
  EXPECT_TRUE(has(text, "Question 1. Where is Q?\n□ Up there\n□ Down there\n□ Within\n")) << text;
  EXPECT_TRUE(has(text, "f(Q) = n·(Q − P₀)\n")) << text;
  EXPECT_TRUE(has(text, "So ? it is:")) << text;
  EXPECT_FALSE(has(text, "30")) << text;
  EXPECT_FALSE(has(text, "Because")) << text;
}

TEST(HandoutText, OfAQuestionWithAnswers_TellsThem) {
  const std::string text = textOf(lessonWith(question), true);
  EXPECT_TRUE(has(text, "✓ Up there\n□ Down there\n")) << text;
  EXPECT_TRUE(has(text, "Answer: Because.")) << text;
  EXPECT_TRUE(has(text, "So 30 it is:")) << text;
  EXPECT_TRUE(has(text, "= 30\n")) << text;
}

const std::string task = "## One\n```lines\nf\n```\n```task\ndo: Drag $Q$ down.\nwhen: side = negative\n"
                         "hints: ['Try it.']\ndone: It is down.\n```\n";

TEST(HandoutText, OfATask_IsAnExercise_WithoutHints) {
  const std::string text = textOf(lessonWith(task));
  EXPECT_TRUE(has(text, "Exercise 1. Drag Q down.\n")) << text;
  EXPECT_FALSE(has(text, "It is down")) << text;
  EXPECT_FALSE(has(text, "Try it")) << text;
  EXPECT_TRUE(has(textOf(lessonWith(task), true), "Answer: It is down.\n"));
}

const std::string blank = "## One\n```lines\nf\n```\n```blank\nall\n```\nHow much is it?\n\n"
                          "```note\nThe answer\nIt is much.\n```\n";

TEST(HandoutText, OfLinesThatAreLeftToTheLearner_HasRoomToWrite) {
  const std::string text = textOf(lessonWith(blank));
  EXPECT_TRUE(has(text, "f(Q) = n·(Q − P₀) = ?\n") || has(text, "f(Q) = n·(Q − P₀)\n")) << text;
  EXPECT_FALSE(has(text, "30")) << text;
  EXPECT_TRUE(has(text, "How much is it?\n____\n")) << text;
  EXPECT_FALSE(has(text, "It is much")) << text;
}

TEST(HandoutText, OfLinesThatAreLeftToTheLearner_WithAnswers_TellsAll) {
  const std::string text = textOf(lessonWith(blank), true);
  EXPECT_TRUE(has(text, "= 30\n")) << text;
  EXPECT_TRUE(has(text, "The answer\nIt is much.\n")) << text;
}

TEST(HandoutText, OfANoteElsewhere_PrintsIt) {
  const std::string text = textOf(lessonWith("## One\n```lines\nf\n```\n```note\nAside\nIt is so.\n```\n"));
  EXPECT_TRUE(has(text, "Aside\nIt is so.\n")) << text;
}

TEST(HandoutText, OfAFigureThatWasPrinted_NamesIt) {
  const std::string text = textOf(lessonWith("## One\nWords.\n```lines\nf\n```\n## Two\n```lines\nf\n```\n"));
  EXPECT_TRUE(has(text, "Words.\nFigure 1.")) << text;
  EXPECT_TRUE(has(text, "# Two\nSee figure 1.\n")) << text;
}

TEST(HandoutText, TellsTheSameOfFigures_BelowTheFirstOfThem) {
  const std::string text = textOf(*library().find("signed-distance"));
  const std::string told = "is positive: Q lies on the side that n points to";
  EXPECT_TRUE(has(text, "Figure 3.\n")) << text;
  EXPECT_EQ(text.find(told), text.rfind(told)) << text;
}

TEST(HandoutText, PutsAFigureBehindWhatLeadsToAFormula) {
  const std::string text = textOf(lessonWith("## One\nSee:\n```lines\nf\n```\nEnd.\n"));
  EXPECT_LT(text.find("= 30"), text.find("Figure 1.")) << text;
}

TEST(HandoutText, OfChosenSteps_KeepsTheirNumbers) {
  const Lesson &lesson = *library().find("signed-distance");
  const WholeHandout handout(lesson);
  HandoutRequest request = handout.request();
  request.steps = {2};
  const HandoutText text = handoutText(request, handoutLook(HandoutPaper::A4, 1), math::fonts());
  const auto &heading = std::get<HeadingBlock>(text.body.front().content);
  EXPECT_EQ(heading.number, "3");
  EXPECT_EQ(heading.plain, lesson.steps[2].title);
  EXPECT_EQ(std::count_if(text.body.begin(), text.body.end(),
                          [](const HandoutBlock &block) {
                            const auto *each = std::get_if<HeadingBlock>(&block.content);
                            return each && each->level == 2;
                          }),
            1);
}

} // namespace
} // namespace halfspace
