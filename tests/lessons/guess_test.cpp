#include "lessons/guess.h"

#include <gtest/gtest.h>

#include <vector>

namespace halfspace {
namespace {

TEST(NearestOf, FewLettersWrong_IsTheNameThatIsNearest) {
  const std::vector<std::string> names{"distance", "foot", "f", "side", "signed_distance"};
  EXPECT_EQ(nearestOf("fot", names), "foot");
  EXPECT_EQ(nearestOf("distence", names), "distance");
  EXPECT_EQ(nearestOf("sid", names), "side");
  EXPECT_EQ(nearestOf("signd-distance", names), "signed_distance");
}

TEST(NearestOf, NothingNear_IsNothing) {
  EXPECT_EQ(nearestOf("t", std::vector<std::string>{"f", "foot"}), "") << "no letter is the same";
  EXPECT_EQ(nearestOf("parallel", std::vector<std::string>{"coincident"}), "");
  EXPECT_EQ(nearestOf("x", {}), "");
  EXPECT_EQ(nearestOf(std::string(5000, 'a'), std::vector<std::string>{std::string(5000, 'a')}), "");
}

} // namespace
} // namespace halfspace
