// Numbers that are left out of worked lines can be found, but are not to be read elsewhere.
#include "lessons/lesson/gap_choice.h"

#include "lessons/lesson/lesson.h"
#include "lessons/lesson/practice.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"

#include "lessons/lesson/shown.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

Working workingOf(const std::string &lesson) {
  return test::ownLines(readLessons(LESSON_FOLDER).find(lesson)->scene);
}

TEST(NumberGaps, OfALine_AreAllItsNumbersAndLists) {
  const Working working = workingOf("signed-distance"); // (1, 2, 2)·(6, 11, 1) = 30
  std::vector<std::string> texts;
  for (const Gap &gap : numberGaps(askedChain(*findLine(working, "f"))))
    texts.push_back(plainText(gap.hidden));
  EXPECT_EQ(texts,
            (std::vector<std::string>{"(1, 2, 2)", "1", "2", "2", "(6, 11, 1)", "6", "11", "1", "30"}));
}

TEST(Fade, ByGaps_HidesNothingThatStandsInAnotherLine) {
  const Working working = workingOf("signed-distance");
  const Fade faded = fade(working, Fading::Gaps, {});
  EXPECT_FALSE(faded.gaps.contains("length")) << "the next line divides by it";
  const Gap &distance = faded.gaps.at("distance");
  EXPECT_NE(plainText(distance.hidden), "30") << "f(Q) is told by its own line";
}

/// x = a·b with numbers put in and multiplied out, a = (0, 2, 0) + (0, 1, 1) and b given.
WorkingLine lineOfProduct(const std::string &id, const Vec3<Rational> &b) {
  const Term sum = name(letter("u"), TermValue(Vec3<Rational>(0, 2, 0))) +
                   name(letter("v"), TermValue(Vec3<Rational>(0, 1, 1)));
  return {id, {withNumbers(name(letter("x"), Rational(3)) == dot(sum, name(letter("b"), TermValue(b))))}};
}

TEST(GapChoice, ThatAZeroMultiplies_IsAnother) {
  for (const char *id : {"a", "b", "c", "d", "e", "f"}) {
    const WorkingLine line = lineOfProduct(id, {0, 1, 0});
    const Working working{{line}};
    const auto gap = GapChoice(working).of(line);
    ASSERT_TRUE(gap);
    EXPECT_EQ(plainText(gap->hidden), "3") << "0·? = 0 takes every number";
  }
}

TEST(GapChoice, OfALineThatMultipliesAListByZero_IsNotTheList) {
  const Term sum = name(letter("u"), TermValue(Vec3<Rational>(1, 2, 3))) +
                   name(letter("v"), TermValue(Vec3<Rational>(1, 1, 1)));
  for (const char *id : {"a", "b", "c", "d", "e", "f"}) {
    const WorkingLine line{id,
                           {withNumbers(name(letter("x"), TermValue(Vec3<Rational>(0, 0, 0))) ==
                                        name(letter("t"), Rational(0)) * sum)}};
    const Working working{{line}};
    const auto gap = GapChoice(working).of(line);
    ASSERT_TRUE(gap);
    EXPECT_TRUE(gap->entry || plainText(gap->hidden) == "(0, 0, 0)") << plainText(gap->hidden);
    EXPECT_NE(plainText(gap->hidden).find('0'), std::string::npos) << "0·? takes every list";
  }
}

TEST(GapChoice, OfALineWhoseNumberIsWrittenBesideIt_IsAnother) {
  const WorkingLine line = lineOfProduct("x", {1, 1, 1});
  const WorkingLine result{
      "y", {withNumbers(name(letter("y"), Rational(6)) == 2 * name(letter("x"), Rational(3)))}};
  const Working both{{line, result}};
  const auto gap = GapChoice(both).of(line);
  ASSERT_TRUE(gap);
  EXPECT_TRUE(gap->entry) << "x stands in the next line: " << plainText(gap->hidden);
}

/// Whether another number of the lines is calculated by the same formula and comes to the same.
bool isWrittenElsewhere(const Gap &gap, const Working &working) {
  for (const WorkingLine &line : working.lines)
    for (const Chain &chain : line.chains)
      for (const Gap &other : numberGaps(chain)) {
        const bool isSamePlace = &*other.hidden == &*gap.hidden || (gap.entry && other.entry != gap.entry);
        if (!isSamePlace && other.hidden->origin && readAlike(*other.hidden->origin, *gap.hidden->origin) &&
            areEqual(*other.hidden->value, *gap.hidden->value) == true)
          return true;
      }
  return false;
}

/// 0·? or ?·0, wherever the gap stands.
bool isMultipliedByZero(const std::string &text) {
  for (auto gap = text.find('?'); gap != std::string::npos; gap = text.find('?', gap + 1)) {
    const std::string before = text.substr(0, gap);
    const bool isZeroBefore = before.ends_with("(0·") || before.ends_with(" 0·");
    if (!isZeroBefore && !text.substr(gap + 1).starts_with("·0"))
      return false;
  }
  return true;
}

TEST(GapChoice, OfEveryStepOfEveryLesson_AreNotToBeReadElsewhere_AndCount) {
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons) {
    const Evaluation evaluation = evaluate(lesson.scene);
    for (const LessonStep &step : lesson.steps) {
      const Working working = shownIn(step, evaluation).working;
      for (const auto &[id, gap] : fade(working, Fading::Gaps, {}).gaps) {
        SCOPED_TRACE(lesson.id + ", " + step.title + ", " + id);
        EXPECT_FALSE(isWrittenElsewhere(gap, working)) << plainText(gap.hidden);
        const std::string text = questionText(*findLine(working, id), gap);
        EXPECT_FALSE(isMultipliedByZero(text)) << text;
      }
    }
  }
}

} // namespace
} // namespace halfspace
