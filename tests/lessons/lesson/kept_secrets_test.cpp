// What a learner is to find in a blank stands nowhere else on the page or in the figure.
#include "lessons/lesson/lesson_words.h"
#include "lessons/lesson/shown.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "tests/lessons/lesson/filled_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace halfspace {
namespace {

bool isPartOfNumber(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.'; }

/// Whether the text has the number or list by itself, not as a part of another, and not as an index.
bool tells(const std::string &text, const std::string &answer) {
  for (auto at = text.find(answer); at != std::string::npos; at = text.find(answer, at + 1)) {
    const auto end = at + answer.size();
    const bool beginsHere = at == 0 || (!isPartOfNumber(text[at - 1]) && text[at - 1] != '_');
    if (beginsHere && (end == text.size() || !isPartOfNumber(text[end])))
      return true;
  }
  return false;
}

bool tells(const std::string &text, const Term &answer) {
  return tells(text, plainText(answer)) || tells(text, latexOf(answer)) ||
         tells(text, latexOf(answer, Fractions::Flat));
}

/// A lesson at one of its steps, with one of its lines left to the learner.
class BlankLine {
public:
  BlankLine(const Lesson &lesson, const LessonStep &step, const Evaluation &evaluation)
      : m_scene(lesson.scene), m_step(step), m_evaluation(evaluation), m_shown(shownIn(step, evaluation)) {}

  void expectSecrets(Fading fading) {
    const Fade all = fade(m_shown.working, fading, {});
    for (const auto &[id, gap] : all.gaps) {
      SCOPED_TRACE(id + ", fading " + std::to_string(static_cast<int>(fading)));
      expectSecret(calculated(gap.hidden));
      expectWaitingLinesKeep(id, fading, all);
    }
  }

private:
  void expectSecret(const Term &answer) {
    for (const LessonWords &words : wordsOf(m_step)) {
      const std::string filled = test::filledText(words.text, m_scene, m_evaluation, LiveValues::Hidden);
      // What the author has written is no live value: the 0 of “it is 0 in the plane”.
      EXPECT_TRUE(tells(words.text.written(), answer) || !tells(filled, answer)) << filled;
    }
    for (const Mark &mark : withoutNumbers(m_shown.figure).marks) {
      EXPECT_FALSE(tells(baseOf(mark).label + baseOf(mark).numbers, answer)) << baseOf(mark).id;
      EXPECT_EQ(baseOf(mark).coordinates, "") << baseOf(mark).id;
    }
  }

  /// The lines that wait for one that is still blank when all others are filled in.
  void expectWaitingLinesKeep(const std::string &blank, Fading fading, const Fade &all) {
    std::set<std::string> opened;
    for (const auto &[id, gap] : all.gaps)
      if (id != blank)
        opened.insert(id);
    const Term answer = calculated(all.gaps.at(blank).hidden);
    for (const std::string &waiting : fade(m_shown.working, fading, opened).waiting) {
      const std::string symbols = symbolsText(*findLine(m_shown.working, waiting));
      EXPECT_TRUE(symbols.find(plainText(answer)) == std::string::npos || !answer->value->isList) << symbols;
    }
  }

  const Scene &m_scene;
  const LessonStep &m_step;
  const Evaluation &m_evaluation;
  Shown m_shown;
};

TEST(KeptSecrets, ofEveryStepOfEveryLesson_areInNoLiveValue_noLabel_andNoLineThatWaits) {
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons) {
    const Evaluation evaluation = evaluate(lesson.scene);
    for (const LessonStep &step : lesson.steps) {
      SCOPED_TRACE(lesson.id + ", " + step.title);
      BlankLine blank(lesson, step, evaluation);
      for (const Fading fading : {Fading::Last, Fading::All})
        blank.expectSecrets(fading);
    }
  }
}

/// What is written at the pins of the points beside a plane.
std::set<std::string> labelsOfPins(const Figure &figure) {
  std::set<std::string> labels;
  for (const Mark &mark : figure.marks)
    if (baseOf(mark).id.find("side-") != std::string::npos)
      labels.insert(baseOf(mark).label + baseOf(mark).numbers);
  return labels;
}

TEST(KeptSecrets, signsOfSides_standAtThePinsOnlyWhileNumbersAreShown) {
  const LessonLibrary library = readLessons(LESSON_FOLDER);
  const Lesson *lesson = library.find("half-spaces");
  ASSERT_TRUE(lesson);
  const Figure figure = figureOf(evaluate(lesson->scene));
  EXPECT_EQ(labelsOfPins(figure), (std::set<std::string>{"+", "-"}));
  EXPECT_EQ(labelsOfPins(withoutNumbers(figure)), std::set<std::string>{""});
}

} // namespace
} // namespace halfspace
