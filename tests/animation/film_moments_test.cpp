#include "tests/animation/animated_lessons.h"
#include "widgets/animation/film.h"

namespace halfspace {
namespace {

/// Of so many seconds.
class Still : public Motion {
public:
  Still(double seconds, bool isLoop) : m_seconds(seconds), m_isLoop(isLoop) {}
  [[nodiscard]] double seconds() const override { return m_seconds; }
  [[nodiscard]] bool isLoop() const override { return m_isLoop; }
  [[nodiscard]] Moment at(double) override { return {}; }

private:
  double m_seconds;
  bool m_isLoop;
};

TEST(FilmMoments, OfAMotionWithAnEnd_GoFromItsBeginningToThat) {
  EXPECT_EQ(momentsOf(Still(1, false), 4), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
}

TEST(FilmMoments, OfALoop_LeaveOutTheEndThatIsItsBeginning) {
  EXPECT_EQ(momentsOf(Still(1, true), 4), (std::vector<double>{0, 0.25, 0.5, 0.75}));
}

TEST(FilmMoments, OfLessThanAPicture_AreOneOrTwo) {
  EXPECT_EQ(momentsOf(Still(0.1, true), 1).size(), 1U);
  EXPECT_EQ(momentsOf(Still(0.1, false), 1).size(), 2U);
}

TEST(Film, ThatIsTooLongOrTooLarge_IsRefusedBeforeAnythingIsWritten) {
  const AnimationFormat *gif = animationFormatOf("a.gif");
  ASSERT_NE(gif, nullptr);
  Still motion(600, false);
  const FilmWatch nobody{[] { return false; }, [](int, int) {}};
  FilmRequest request;
  request.file = "no-such-folder/a.gif";
  request.size = {16, 16};
  request.framesPerSecond = 50;
  const auto tooLong = film(motion, *gif, request, nobody);
  ASSERT_FALSE(tooLong);
  EXPECT_NE(tooLong.problem().sentence.find("at most 10000 pictures, not 30001"), std::string::npos)
      << tooLong.problem().text();
  Still forEver(1e300, true);
  EXPECT_FALSE(film(forEver, *gif, request, nobody));
  request.framesPerSecond = 10;
  request.size = {16384, 16384};
  const auto tooLarge = film(motion, *gif, request, nobody);
  ASSERT_FALSE(tooLarge);
  EXPECT_NE(tooLarge.problem().sentence.find("16384 × 16384"), std::string::npos)
      << tooLarge.problem().text();
}

TEST(Film, WithoutABackground_OfAVideo_IsRefused) {
  Still motion(1, false);
  FilmRequest request;
  request.file = "a.mp4";
  request.size = {16, 16};
  request.isTransparent = true;
  const auto refused =
      film(motion, *animationFormatOf("a.mp4"), request, {[] { return false; }, [](int, int) {}});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.problem().sentence.find("no transparent pictures"), std::string::npos);
}

} // namespace
} // namespace halfspace
