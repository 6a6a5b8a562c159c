#include "lessons/files/held_signals.h"

#include <gtest/gtest.h>

#include <optional>

namespace halfspace {
namespace {

volatile std::sig_atomic_t noted = 0;
void note(int signal) { noted = signal; }
void noteLater(int signal) { noted = -signal; }

/// SIGTERM does again what it did before when the test ends.
class HeldSignalsTest : public testing::Test {
protected:
  HeldSignalsTest() : m_before(std::signal(SIGTERM, note)) { noted = 0; }
  ~HeldSignalsTest() override { std::signal(SIGTERM, m_before); }

private:
  void (*m_before)(int);
};

TEST_F(HeldSignalsTest, OneThatComesMeanwhile_DoesItsWorkAfterwards) {
  {
    const HeldSignals held;
    EXPECT_FALSE(held.isOneWaiting());
    std::raise(SIGTERM);
    EXPECT_TRUE(held.isOneWaiting());
    EXPECT_EQ(noted, 0);
  }
  EXPECT_EQ(noted, SIGTERM);
}

TEST_F(HeldSignalsTest, WhatIsToBeDoneFromNowOn_StaysAsItWasSetMeanwhile) {
  {
    const HeldSignals held;
    std::signal(SIGTERM, noteLater);
  }
  std::raise(SIGTERM);
  EXPECT_EQ(noted, -SIGTERM);
}

TEST_F(HeldSignalsTest, ThoseThatLiveMeanwhile_HoldNothing) {
  std::optional<HeldSignals> first(std::in_place);
  {
    const HeldSignals second;
    std::raise(SIGTERM);
  }
  EXPECT_EQ(noted, 0);
  first.reset();
  EXPECT_EQ(noted, SIGTERM);
}

} // namespace
} // namespace halfspace
