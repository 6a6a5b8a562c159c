#include "lessons/lesson/task_progress.h"

#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using Done = std::vector<bool>;

Evaluation withT(int t) { return test::withValues({{"t", "t", Surd(t)}}); }

Task task(Condition::Relation relation, const char *against) { return {"", {{"t", relation, against}}}; }

const std::vector<Task> negative{task(Condition::Relation::Less, "0")};

TEST(TaskProgress, OfWhatIsTrueOnArrival_CountsOnlyAfterItWasUntrue) {
  TaskProgress progress;
  progress.arrive();
  progress.observe(negative, withT(-3));
  EXPECT_EQ(progress.done(), Done{false});
  progress.observe(negative, withT(2));
  EXPECT_EQ(progress.done(), Done{false});
  progress.observe(negative, withT(-1));
  EXPECT_EQ(progress.done(), Done{true});
}

TEST(TaskProgress, OfTheNextTaskTellsWhetherItHoldsAlready) {
  const std::vector<Task> awayAndBack{task(Condition::Relation::Equal, "0"),
                                      task(Condition::Relation::Greater, "0")};
  TaskProgress progress;
  progress.arrive();
  progress.observe(awayAndBack, withT(0));
  EXPECT_EQ(progress.states(), (std::vector{TaskState::HoldsAlready, TaskState::Waiting}));
  progress.observe(awayAndBack, withT(1));
  EXPECT_EQ(progress.states(), (std::vector{TaskState::Open, TaskState::Waiting}))
      << "the second waits its turn";
  progress.observe(awayAndBack, withT(0));
  EXPECT_EQ(progress.states(), (std::vector{TaskState::Done, TaskState::Open}));
}

TEST(TaskProgress, OfWhatBecameTrueElsewhere_DoesNotCountOnReturn) {
  TaskProgress progress;
  progress.arrive();
  progress.observe(negative, withT(2));
  progress.arrive();
  progress.observe(negative, withT(-1));
  EXPECT_EQ(progress.done(), Done{false});
}

TEST(TaskProgress, OfASceneThatBeginsAnew_IsOpenAgain_AndStaysDoneForTheLesson) {
  TaskProgress progress({true});
  progress.observe(negative, withT(2));
  EXPECT_EQ(progress.states(), std::vector{TaskState::Done});
  progress.beginAnew();
  progress.observe(negative, withT(-3));
  EXPECT_EQ(progress.states(), std::vector{TaskState::HoldsAlready}) << "other numbers are no deed";
  progress.observe(negative, withT(2));
  EXPECT_EQ(progress.states(), std::vector{TaskState::Open});
  EXPECT_EQ(progress.done(), Done{true});
  progress.observe(negative, withT(-1));
  EXPECT_EQ(progress.states(), std::vector{TaskState::Done});
}

TEST(TaskProgress, OfADoneTask_StaysDone) {
  TaskProgress progress;
  progress.observe(negative, withT(2));
  progress.observe(negative, withT(-1));
  progress.arrive();
  progress.observe(negative, withT(2));
  EXPECT_EQ(progress.done(), Done{true});
}

TEST(TaskProgress, OfTwoTasks_CountsThemInTheirOrder) {
  const std::vector<Task> awayAndBack{task(Condition::Relation::Equal, "0"),
                                      task(Condition::Relation::Greater, "0")};
  TaskProgress progress;
  progress.observe(awayAndBack, withT(5));
  progress.observe(awayAndBack, withT(-5));
  progress.observe(awayAndBack, withT(5));
  EXPECT_EQ(progress.done(), (Done{false, false}));
  progress.observe(awayAndBack, withT(0));
  EXPECT_EQ(progress.done(), (Done{true, false}));
  progress.observe(awayAndBack, withT(5));
  EXPECT_EQ(progress.done(), (Done{true, true}));
}

} // namespace
} // namespace halfspace
