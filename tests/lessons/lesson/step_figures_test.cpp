// The figures of our lessons' steps: what a step speaks of is drawn.
#include "lessons/lesson/lesson_words.h"
#include "lessons/lesson/shown.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

namespace halfspace {
namespace {

using Tokens = std::vector<std::string>;

/// Commands and single characters of LaTeX, without what is only there for grouping or for the eye.
Tokens tokensOf(std::string_view latex) {
  Tokens tokens;
  const auto isLetter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t i = 0; i < latex.size(); ++i) {
    std::string token(1, latex[i]);
    if (latex[i] == '\\')
      while (i + 1 < latex.size() && (token.size() == 1 || (isLetter(token[1]) && isLetter(latex[i + 1])))) {
        token += latex[++i];
        if (!isLetter(token[1]))
          break;
      }
    if (token != " " && token != "\n" && token != "{" && token != "}")
      tokens.push_back(token);
  }
  return tokens;
}

/// Whether a formula has the letter, not as a part of another: P of P − Q, but neither of P₀ nor in n_P.
bool speaksOf(const Tokens &formula, const Tokens &letter) {
  const auto isPartBefore = [](const std::string &token) {
    return token == "_" || token == "^" || token == "\\vec";
  };
  const auto isPartBehind = [](const std::string &token) { return token == "_" || token == "^"; };
  for (auto at = formula.begin();;) {
    at = std::search(at, formula.end(), letter.begin(), letter.end());
    if (at == formula.end())
      return false;
    const auto behind = at + static_cast<std::ptrdiff_t>(letter.size());
    if ((at == formula.begin() || !isPartBefore(*std::prev(at))) &&
        (behind == formula.end() || !isPartBehind(*behind)))
      return true;
    ++at;
  }
}

/// What stands between dollars, one or two.
std::vector<std::string> formulasIn(std::string text) {
  for (auto at = text.find("$$"); at != std::string::npos; at = text.find("$$", at))
    text.replace(at, 2, "$");
  std::vector<std::string> formulas;
  for (auto begin = text.find('$'); begin != std::string::npos;) {
    const auto end = text.find('$', begin + 1);
    formulas.push_back(text.substr(begin + 1, end - begin - 1));
    begin = end == std::string::npos ? end : text.find('$', end + 1);
  }
  return formulas;
}

/// One step of a lesson, with all that it says.
struct StepOf {
  const Lesson &lesson;
  const LessonStep &step;
  Shown shown;
  Figure whole;

  [[nodiscard]] std::string name() const { return lesson.id + ", " + step.title; }

  /// In words, question, tasks, notes and lines; what a term means is told without the figure.
  [[nodiscard]] std::vector<std::string> formulas() const {
    std::vector<std::string> all;
    for (const LessonWords &words : wordsOf(step))
      if (words.isOnPage)
        for (std::string &formula : formulasIn(words.text.written()))
          all.push_back(std::move(formula));
    for (const WorkingLine &line : shown.working.lines)
      all.push_back(latexOf(line, LinePiece::Symbols));
    return all;
  }
};

std::vector<StepOf> allSteps() {
  static const LessonLibrary library = readLessons(LESSON_FOLDER);
  std::vector<StepOf> steps;
  for (const Lesson &lesson : library.lessons) {
    const Evaluation start = evaluate(lesson.scene);
    for (const LessonStep &step : lesson.steps)
      steps.push_back({lesson, step, shownIn(step, start), figureOf(start)});
  }
  return steps;
}

/// The signs + and − are labels too, which formulas have for other reasons.
bool hasLetter(const std::string &label) {
  return std::any_of(label.begin(), label.end(),
                     [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
}

bool hasLabel(const Figure &figure, const std::string &label) {
  return std::any_of(figure.marks.begin(), figure.marks.end(),
                     [&](const Mark &mark) { return baseOf(mark).label == label; });
}

TEST(SpeaksOf, FindsALetterAlone_AndNotWithinAnother) {
  const auto speaks = [](std::string_view formula, std::string_view letter) {
    return speaksOf(tokensOf(formula), tokensOf(letter));
  };
  EXPECT_TRUE(speaks("0 = \\vec n\\cdot(P - P_0)", "P"));
  EXPECT_TRUE(speaks("P_0BP_2", "P_2"));
  EXPECT_TRUE(speaks("\\vec u^\\perp", "\\vec u^{\\perp}"));
  EXPECT_TRUE(speaks("\\cos\\theta", "\\theta"));
  EXPECT_FALSE(speaks("\\vec n\\cdot P_0", "P"));
  EXPECT_FALSE(speaks("\\vec n_{f}", "\\vec n"));
  EXPECT_FALSE(speaks("\\vec n_{F}", "F"));
  EXPECT_FALSE(speaks("\\vec v", "v"));
}

TEST(StepFigures, HaveWhatTheStepSpeaksOf) {
  for (const StepOf &each : allSteps()) {
    std::set<std::string> missing;
    for (const Mark &mark : each.whole.marks)
      if (const std::string &label = baseOf(mark).label;
          hasLetter(label) && !hasLabel(each.shown.figure, label))
        missing.insert(label);
    for (const std::string &formula : each.formulas())
      for (const std::string &label : missing)
        EXPECT_FALSE(speaksOf(tokensOf(formula), tokensOf(label)))
            << each.name() << ": " << label << " is not drawn, though there is " << formula;
  }
}

std::vector<Place> endsOf(const Mark &mark) {
  if (const auto *segment = std::get_if<SegmentMark>(&mark))
    return {segment->from, segment->to};
  // The tip of a normal or of a ray's direction is a place only for those who go there.
  if (const auto *arrow = std::get_if<ArrowMark>(&mark); arrow && !arrow->drawnLength && !arrow->isFree)
    return {arrow->from, arrow->from + arrow->vector};
  return {};
}

bool hasPointAt(const Figure &figure, const Place &place) {
  return std::any_of(figure.marks.begin(), figure.marks.end(), [&](const Mark &mark) {
    const auto *point = std::get_if<PointMark>(&mark);
    return point && point->at == place;
  });
}

TEST(StepFigures, HaveThePointsAtTheEndsOfTheirPieces) {
  for (const StepOf &each : allSteps())
    for (const Mark &mark : each.shown.figure.marks)
      for (const Place &end : endsOf(mark))
        EXPECT_EQ(hasPointAt(each.shown.figure, end), hasPointAt(each.whole, end))
            << each.name() << ": " << baseOf(mark).id << " ends at a point that is not drawn";
}

/// The step as it is in a case that has none of its lines: with them goes what they show.
LessonStep withoutLines(LessonStep step) {
  for (StepBlock &block : step.blocks)
    if (auto *lines = std::get_if<StepLines>(&block))
      lines->ids = {"none"};
  return step;
}

TEST(StepFigures, DrawEveryMarkThatTheStepNames) {
  for (const StepOf &each : allSteps()) {
    const Evaluation start = evaluate(each.lesson.scene);
    const LessonStep step = withoutLines(each.step);
    const std::size_t marks = shownIn(step, start).figure.marks.size();
    for (const std::string &id : step.drawn) {
      LessonStep without = step;
      std::erase(without.drawn, id);
      EXPECT_GT(marks, shownIn(without, start).figure.marks.size())
          << each.name() << ": " << id << " is unknown, or drawn anyway";
    }
  }
}

} // namespace
} // namespace halfspace
