// Work in a process of its own, whatever becomes of it.
#include "lessons/files/run_apart.h"

#include <csignal>
#include <gtest/gtest.h>
#include <stdexcept>

namespace halfspace {
namespace {

constexpr ProcessBounds bounds{{}, 1};
constexpr std::size_t mostBytes = 1U << 20U;

TEST(RunApart, WorkThatEnds_GivesWhatItComesTo_AndChangesNothingHere) {
  int changed = 0;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, mostBytes}) {
    const auto text =
        runApart([&] { return std::string(size, static_cast<char>(++changed)); }, bounds, mostBytes);
    EXPECT_EQ(text, std::string(size, '\1'));
  }
  EXPECT_EQ(changed, 0);
}

TEST(RunApart, WorkThatCrashesOrThrows_GivesNothing) {
  EXPECT_FALSE(runApart(
      []() -> std::string {
        std::raise(SIGKILL);
        return {};
      },
      bounds, mostBytes));
  EXPECT_FALSE(runApart([]() -> std::string { throw std::runtime_error("no memory"); }, bounds, mostBytes));
}

TEST(RunApart, WorkThatTakesTooLong_IsEnded) {
  const volatile bool goesOn = true;
  const auto text = runApart(
      [&] {
        while (goesOn) {
        }
        return std::string();
      },
      bounds, mostBytes);
  EXPECT_FALSE(text);
}

TEST(RunApart, WorkThatComesToTooMuch_GivesNothing) {
  EXPECT_FALSE(runApart([] { return std::string(mostBytes + 1, 'x'); }, bounds, mostBytes));
  EXPECT_FALSE(runApart([] { return std::string(10 * mostBytes, 'x'); }, bounds, mostBytes));
}

} // namespace
} // namespace halfspace
