#include "lessons/lesson/line_practice.h"

#include "lessons/object/object.h"
#include "lessons/term/rewrite.h"
#include "tests/lessons/called_line.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using test::called;
using Ids = std::set<std::string>;

/// f(Q) = 2·15 = 30, h = f(Q)/3 = 10, F = (1, 2, 3)
Working someWorking(int value = 30) {
  const Term f = applied(letter("f"), name(letter("Q"), ExactVec3(1, 0, 0)), Rational(value));
  const Term h = name(letter("h"), Rational(value, 3));
  const Term F = name(letter("F"), ExactVec3(1, 2, 3));
  return {{called("f", asked(Chain(f).then(2 * Term(Rational(value, 2))).then(calculated(f)))),
           called("distance", asked(withNumbers(h == f / 3), "Divided by the length.")),
           called("foot", line(withResult(F)))}};
}

/// The first step of a lesson, whose lines are blank.
class BlankLines : public testing::Test {
protected:
  BlankLines() {
    practice.setStep("lesson", 0, {});
    practice.setWorking(someWorking(), false);
    practice.choose(Fading::All);
  }
  [[nodiscard]] Ids blank() const {
    Ids ids;
    for (const auto &[line, gap] : practice.fade().gaps)
      ids.insert(line);
    return ids;
  }

  LinePractice practice;
};

using Score = LinePractice::Score;

TEST_F(BlankLines, FilledInRight_AreOpen_AndCountAtTheFirstTryAlone) {
  EXPECT_EQ(blank(), (Ids{"f", "distance"}));
  EXPECT_TRUE(practice.answer("f", "31"));
  EXPECT_EQ(practice.score(), (Score{0, 1}));
  EXPECT_FALSE(practice.remarks().at("f").right);
  EXPECT_TRUE(practice.answer("f", "30"));
  EXPECT_TRUE(practice.answer("distance", "10"));
  EXPECT_EQ(practice.score(), (Score{1, 2}));
  EXPECT_EQ(blank(), Ids());
  EXPECT_FALSE(practice.answer("f", "30")) << "it asks no more";
  EXPECT_FALSE(practice.answer("nowhere", "30"));
}

TEST_F(BlankLines, WithWhatIsNoAnswer_CountNothing) {
  EXPECT_TRUE(practice.answer("f", "what?"));
  EXPECT_EQ(practice.score(), Score());
  EXPECT_FALSE(practice.remarks().at("f").text.empty());
}

TEST_F(BlankLines, ThatAreShown_CountAsTried) {
  practice.open("f");
  EXPECT_EQ(blank(), Ids{"distance"});
  EXPECT_EQ(practice.score(), (Score{0, 1}));
  EXPECT_TRUE(practice.remarks().empty());
}

TEST_F(BlankLines, WithOtherNumbers_AskAnew_AndKeepWhatWasSaidAsSuch) {
  practice.answer("f", "30");
  practice.setWorking(someWorking(60), false);
  EXPECT_EQ(blank(), (Ids{"f", "distance"}));
  EXPECT_FALSE(practice.remarks().at("f").isOfNow);
  practice.answer("f", "60");
  EXPECT_TRUE(practice.remarks().at("f").isOfNow);
  EXPECT_EQ(practice.score(), (Score{2, 2}));
  practice.forgetLines();
  EXPECT_TRUE(practice.remarks().empty());
  EXPECT_EQ(practice.score(), (Score{2, 2}));
}

TEST_F(BlankLines, WhileAQuestionGoesBefore_AskNothingAndTellNothing_AndAreAsTheyWereBehindIt) {
  practice.answer("f", "30");
  practice.setWorking(someWorking(60), true); // not the numbers of the scene
  EXPECT_EQ(blank(), Ids());
  EXPECT_EQ(practice.fade().waiting, (Ids{"f", "distance", "foot"}));
  EXPECT_TRUE(practice.remarks().empty());
  practice.setWorking(someWorking(), false);
  EXPECT_EQ(blank(), Ids{"distance"});
  EXPECT_TRUE(practice.remarks().at("f").isOfNow);
}

TEST_F(BlankLines, ChosenInAStep_HoldForTheLesson_ButWhereAStepAsks) {
  practice.answer("f", "30");
  EXPECT_FALSE(practice.setStep("lesson", 0, {})) << "it is there";
  EXPECT_TRUE(practice.setStep("lesson", 1, {}));
  practice.setWorking(someWorking(), false);
  EXPECT_EQ(practice.fading(), Fading::All);
  EXPECT_EQ(practice.score(), Score());
  practice.setStep("lesson", 2, Fading::Last);
  EXPECT_EQ(practice.fading(), Fading::Last);
  practice.setStep("other", 0, {});
  EXPECT_EQ(practice.fading(), Fading::None);
  practice.setStep("lesson", 0, Fading::Last);
  EXPECT_EQ(practice.fading(), Fading::All) << "the learner's own choice there";
  EXPECT_EQ(practice.score(), (Score{1, 1}));
}

TEST_F(BlankLines, ChosenAnew_AreBlankAndUncounted) {
  practice.answer("f", "30");
  practice.choose(Fading::Last);
  EXPECT_EQ(blank(), Ids{"distance"});
  EXPECT_EQ(practice.score(), Score());
  practice.choose(Fading::None);
  EXPECT_EQ(blank(), Ids());
}

TEST(LinePractice, OfLinesThatAskForNothing_HasNumbersToFindWhereTheyAreWorkedOut) {
  LinePractice practice;
  practice.setWorking(someWorking(), false);
  EXPECT_TRUE(practice.hasNumbersToFind());
  practice.setWorking({{called("foot", line(withResult(name(letter("F"), ExactVec3(1, 2, 3)))))}}, false);
  EXPECT_FALSE(practice.hasNumbersToFind());
  const Term f = name(letter("f"), Rational(6));
  const Term a = name(letter("a"), Rational(2));
  practice.setWorking({{called("f", line(withNumbers(f == a * (a + 1))))}}, false);
  EXPECT_TRUE(practice.hasNumbersToFind());
  EXPECT_TRUE(practice.fade().gaps.empty()) << "nothing was chosen";
  practice.choose(Fading::Gaps);
  EXPECT_EQ(practice.fade().gaps.size(), 1U);
}

} // namespace
} // namespace halfspace
