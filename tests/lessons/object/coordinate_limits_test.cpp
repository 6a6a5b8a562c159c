#include "lessons/object/coordinate_limits.h"
#include "lessons/object/kinds/plane.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(RefuseCoordinate, AtTheLimits_TakesWhatIsWithinAndSaysWhyNotBeyond) {
  EXPECT_FALSE(refuseCoordinate(coordinateLimit));
  EXPECT_FALSE(refuseCoordinate(powerOfTen(-39)));
  EXPECT_TRUE(refuseCoordinate(Rational(coordinateLimit + 1))->find("too large") != std::string::npos);
  EXPECT_TRUE(refuseCoordinate(Rational(-coordinateLimit - 1)));
  EXPECT_TRUE(refuseCoordinate(powerOfTen(-40))->find("too long") != std::string::npos);
}

TEST(RefusedCoordinateOf, AnObject_NamesTheCoordinate) {
  EXPECT_FALSE(refusedCoordinateOf(PlaneObject{{1, 2, 3}, {0, 0, 1}}));
  EXPECT_EQ(refusedCoordinateOf(PlaneObject{{1, 2, 3}, {0, 0, coordinateLimit * 2}})->name, "n");
}

} // namespace
} // namespace halfspace
