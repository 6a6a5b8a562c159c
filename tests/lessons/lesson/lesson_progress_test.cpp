#include "lessons/lesson/lesson_progress.h"

#include <algorithm>
#include <iterator>

#include <gtest/gtest.h>

namespace halfspace {
namespace {

/// A question, two tasks, and a step that asks for nothing.
Lesson someLesson() {
  Lesson lesson;
  lesson.id = "distance";
  lesson.steps = {{"Predict", {Prediction{"Which side?", "side", {{"positive", "That of n"}}, "It is so."}}},
                  {"Try", {Task{"Drag Q.", {}}, Task{"Drag E.", {}}}},
                  {"Read", {StepLines()}}};
  return lesson;
}

StepProgress answered(const std::string &chosen) { return {chosen, "positive", {}}; }
StepProgress withTasks(std::vector<bool> done) { return {{}, {}, TaskProgress(std::move(done))}; }

LessonState stateWith(const LessonProgress &progress) { return stateOf(someLesson(), progress); }

TEST(LessonStateOf, ALessonWithNothingDone_IsNew) {
  EXPECT_EQ(stateWith({}), LessonState::New);
  EXPECT_EQ(stateWith({{{"distance", "Try"}, withTasks({false, false})}}), LessonState::New);
  EXPECT_EQ(stateWith({{{"distance", "Read"}, {}}}), LessonState::New);
  EXPECT_EQ(stateWith({{{"another", "Predict"}, answered("positive")}}), LessonState::New);
}

TEST(LessonStateOf, ALessonWithSomethingLeft_IsBegun) {
  EXPECT_EQ(stateWith({{{"distance", "Predict"}, answered("positive")}}), LessonState::Begun);
  EXPECT_EQ(stateWith({{{"distance", "Try"}, withTasks({true, true})}}), LessonState::Begun);
  EXPECT_EQ(stateWith({{{"distance", "Predict"}, answered("positive")},
                       {{"distance", "Try"}, withTasks({true, false})}}),
            LessonState::Begun);
  EXPECT_EQ(
      stateWith({{{"distance", "Predict"}, answered("positive")}, {{"distance", "Try"}, withTasks({true})}}),
      LessonState::Begun); // a task has been added since
}

TEST(LessonStateOf, ALessonWithEveryTaskDoneAndQuestionAnswered_IsDone) {
  for (const char *answer : {"positive", "negative"}) // right or wrong
    EXPECT_EQ(stateWith({{{"distance", "Predict"}, answered(answer)},
                         {{"distance", "Try"}, withTasks({true, true})}}),
              LessonState::Done);
  EXPECT_EQ(stateWith({{{"distance", "Predict"}, answered("x")},
                       {{"distance", "Try"}, withTasks({true, true, false})}}),
            LessonState::Done); // a task has gone since
}

TEST(LessonStateOf, ALessonThatAsksForNothing_IsNeverDone) {
  Lesson lesson = someLesson();
  lesson.steps.erase(lesson.steps.begin(), lesson.steps.begin() + 2);
  EXPECT_EQ(stateOf(lesson, {}), LessonState::New);
  lesson.steps.clear();
  EXPECT_EQ(stateOf(lesson, {}), LessonState::New);
}

TEST(LessonStateOf, ALessonThatGotAStepBetween_KeepsWhatWasDoneInTheOthers) {
  const Lesson before = someLesson();
  const LessonProgress progress{{{"distance", nameOfStep(before, 0)}, answered("positive")},
                                {{"distance", nameOfStep(before, 1)}, withTasks({true, true})}};
  Lesson lesson = before;
  lesson.steps = {{"Before", {StepLines()}}};
  std::ranges::copy(before.steps, std::back_inserter(lesson.steps));
  EXPECT_EQ(stateOf(lesson, progress), LessonState::Done);
}

TEST(NameOfStep, OfStepsWithTheSameTitle_IsAnotherForEach) {
  Lesson lesson = someLesson();
  lesson.steps.push_back(lesson.steps.front());
  lesson.steps.push_back(lesson.steps.front());
  EXPECT_EQ(nameOfStep(lesson, 0), "Predict");
  EXPECT_NE(nameOfStep(lesson, 0), nameOfStep(lesson, 3));
  EXPECT_NE(nameOfStep(lesson, 3), nameOfStep(lesson, 4));
}

TEST(ProgressWithStepNames, OfAnOlderFile_HasNamesWhereTheLessonsHaveSuchSteps) {
  const LessonProgress older{{{"distance", 0}, answered("positive")},
                             {{"distance", 7}, answered("on")},
                             {{"elsewhere", 0}, withTasks({true})}};
  const LessonProgress renamed{{{"distance", "Predict"}, answered("positive")},
                               {{"distance", 7}, answered("on")},
                               {{"elsewhere", 0}, withTasks({true})}};
  EXPECT_EQ(withStepNames(older, {someLesson()}), renamed);
  EXPECT_EQ(withStepNames(renamed, {someLesson()}), renamed);
}

TEST(ProgressWithStepNames, BesideProgressByName_HasBoth) {
  const LessonProgress both{{{"distance", 1}, withTasks({false, true})},
                            {{"distance", "Try"}, withTasks({true, false})}};
  EXPECT_EQ(withStepNames(both, {someLesson()}),
            (LessonProgress{{{"distance", "Try"}, withTasks({true, true})}}));
}

TEST(MergedProgress, HasWhatIsDoneInOneOrTheOther) {
  const LessonProgress first{{{"a", 0}, withTasks({true, false, false})}, {{"b", 1}, answered("positive")}};
  const LessonProgress second{{{"a", 0}, withTasks({false, true})}, {{"c", 2}, answered("negative")}};
  const LessonProgress both{{{"a", 0}, withTasks({true, true, false})},
                            {{"b", 1}, answered("positive")},
                            {{"c", 2}, answered("negative")}};
  EXPECT_EQ(merged(first, second), both);
  EXPECT_EQ(merged(second, first), both);
  EXPECT_EQ(merged(first, {}), first);
  EXPECT_EQ(merged({}, first), first);
}

TEST(MergedProgress, WithTwoAnswers_HasTheFirstsWithItsVerdict) {
  const LessonProgress mine{{{"a", 0}, {"negative", "positive", {}}}};
  const LessonProgress other{{{"a", 0}, {"on", "on", {}}}};
  EXPECT_EQ(merged(mine, other), mine);
  EXPECT_EQ(merged(other, mine), other);
}

} // namespace
} // namespace halfspace
