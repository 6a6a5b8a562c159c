// Which handles have a line down to the ground, whose foot has its numbers on the axes.
#include "widgets/picture/hand/drop_line.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

Handle handleThat(Handle::Motion motion) {
  Handle handle;
  handle.motion = motion;
  handle.at = {1, 2, 3};
  return handle;
}

TEST(DropLine, ofAPlace_goesDownFromIt) {
  for (const auto motion : {Handle::Motion::Coordinate, Handle::Motion::OnHost})
    EXPECT_EQ(dropLineOf(handleThat(motion), false), (DropLine{{1, 2, 3}}));
  for (const auto motion : {Handle::Motion::AlongNormal, Handle::Motion::Whole, Handle::Motion::Length})
    EXPECT_EQ(dropLineOf(handleThat(motion), false), std::nullopt);
}

TEST(DropLine, ofAPointOnSomething_isNotThereWhileNumbersAreHidden) {
  EXPECT_EQ(dropLineOf(handleThat(Handle::Motion::OnHost), true), std::nullopt);
  EXPECT_EQ(dropLineOf(handleThat(Handle::Motion::Coordinate), true), (DropLine{{1, 2, 3}}));
}

} // namespace
} // namespace halfspace
