// How many wrong answers are named: those that a learner reads more about than that they are wrong.
#include "tests/lessons/construction/expected/expected.h"

#include "tests/effort.h"
#include "tests/lessons/construction/construction_ids.h"
#include "tests/lessons/construction/random_objects.h"
#include "tests/lessons/scenes.h"
#include "tests/test_name.h"

#include "lessons/lesson/practice.h"
#include "lessons/reading/typed_answer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace halfspace {
namespace {

using namespace test;

constexpr int scenesPerConstruction = isWatched ? 20 : 60;

struct Named {
  int named = 0;
  int all = 0;
  [[nodiscard]] double share() const { return static_cast<double>(named) / all; }
};

std::optional<std::string> typed(const Surd &number) {
  const auto text = toText(number);
  return text && text->size() <= longestAnswer ? text : std::nullopt;
}

bool isNamed(const std::string &sentence) { return !sentence.ends_with(" once more."); }

std::vector<const Object *> pointersTo(const std::vector<Object> &objects) {
  std::vector<const Object *> pointers;
  for (const Object &object : objects)
    pointers.push_back(&object);
  return pointers;
}

void judgeWrongAnswers(const Construction &construction, const std::vector<Object> &objects, Named &count) {
  const Working working = ownLines(sceneOf(construction, objects));
  std::set<std::pair<std::string, std::string>> judged;
  for (const WrongAnswer &wrong : expectedOf(construction).wrongAnswers(pointersTo(objects))) {
    if (wrong.typed.size() > longestAnswer || !judged.emplace(wrong.line, wrong.typed).second)
      continue;
    const WorkingLine &line = *findLine(working, wrong.line);
    const Judgement judgement = judge(line, resultGap(line), wrong.typed);
    EXPECT_FALSE(judgement.right) << wrong.line << ": " << wrong.how << ", " << wrong.typed;
    count.named += isNamed(judgement.sentence) ? 1 : 0;
    ++count.all;
  }
}

/// Calls back with random objects for a construction.
template <class Use> void forScenes(const Construction &construction, Use use) {
  for (const Writing writing : {Writing::SmallIntegers, Writing::Halves}) {
    RandomObjects random(77);
    for (int i = 0; i < scenesPerConstruction / 2; ++i) {
      const std::vector<Object> objects = random.objectsFor(construction, writing);
      use(objects);
    }
  }
}

class JudgeOfEveryConstruction : public testing::TestWithParam<std::string> {
protected:
  const Construction &m_construction = *findConstruction(GetParam());
};

TEST_P(JudgeOfEveryConstruction, WrongAnswersOfManyKinds_AFairShareOfThemIsNamed) {
  Named count;
  forScenes(m_construction,
            [&](const std::vector<Object> &objects) { judgeWrongAnswers(m_construction, objects, count); });
  EXPECT_GT(count.share(), expectedOf(m_construction).leastShareNamed) << count.named << " of " << count.all;
  EXPECT_GT(count.all, isWatched ? 100 : 500);
}

TEST_P(JudgeOfEveryConstruction, RightAnswer_NoMistakeIsNamed) {
  forScenes(m_construction, [&](const std::vector<Object> &objects) {
    for (const WorkingLine &line : ownLines(sceneOf(m_construction, objects)).lines) {
      const Real *number = line.asked == Asked::Value ? numberOf(line.chains.back().last()) : nullptr;
      if (const auto text = number ? typed(*number->exact()) : std::nullopt) {
        EXPECT_EQ(judge(line, resultGap(line), *text).sentence, "Right.") << line.id << ": " << *text;
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(WrongWorkings, JudgeOfEveryConstruction, testing::ValuesIn(constructionIds()),
                         testName);

} // namespace
} // namespace halfspace
