#include "widgets/picture/theme.h"

#include "widgets/picture/shapes/mark_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halfspace {
namespace {

double luminance(Color color) {
  const auto channel = [](std::uint8_t value) {
    const double c = value / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * channel(color.red) + 0.7152 * channel(color.green) + 0.0722 * channel(color.blue);
}

/// The contrast ratio of the Web Content Accessibility Guidelines.
double contrast(Color a, Color b) {
  const double brighter = std::max(luminance(a), luminance(b));
  const double darker = std::min(luminance(a), luminance(b));
  return (brighter + 0.05) / (darker + 0.05);
}

TEST(Theme, EveryInkReadsOnItsHaloAndOnThePanel) {
  for (const Theme &theme : themes()) {
    std::vector<Color> inks(theme.inks.begin(), theme.inks.end());
    inks.insert(inks.end(), {theme.ink, theme.mutedInk, theme.accent, theme.warning});
    for (std::size_t i = 0; i < inks.size(); ++i)
      for (const Color ground : {theme.halo, theme.panel, theme.backgroundTop})
        EXPECT_GE(contrast(inks[i], ground), 4.5) << theme.name << ", ink " << i;
  }
}

/// What the guidelines ask of graphics that are no text.
constexpr double leastContrast = 3;
/// Of what is to stay in the background, on the background and behind a plane.
constexpr double leastGhostContrast = 2;
constexpr double leastCoveredContrast = 1.7;

constexpr std::array allHues{Hue::Grey,  Hue::Blue,   Hue::Orange, Hue::Yellow,
                             Hue::Green, Hue::Purple, Hue::Pink,   Hue::Red};
static_assert(allHues.size() == hueCount);

TEST(Theme, EverySolidIsSeenOnTheBackground) {
  for (const Theme &theme : themes())
    for (const Hue hue : allHues)
      for (const Color ground : {theme.backgroundTop, theme.backgroundBottom})
        EXPECT_GE(contrast(theme.colorOf(hue), ground), leastContrast) << theme.name << ", " << nameOf(hue);
}

/// Of what is told from something beside it by its brightness alone.
constexpr double leastDifference = 1.8;

TEST(Theme, AxesAreSeenOnTheBackground_AndAreNotTakenForGreyArrows) {
  for (const Theme &theme : themes()) {
    for (const Color ground : {theme.backgroundTop, theme.backgroundBottom})
      EXPECT_GE(contrast(theme.axis, ground), leastContrast) << theme.name;
    EXPECT_GE(contrast(theme.axis, theme.colorOf(Hue::Grey)), leastDifference) << theme.name;
  }
}

TEST(Theme, EveryGhostIsSeenOnTheBackgroundAndBehindAPlane) {
  for (const Theme &theme : themes())
    for (const Hue hue : allHues) {
      MarkBase ghost;
      ghost.role = Role::Ghost;
      ghost.look.hue = hue;
      const Color color = solidColor(ghost, theme, false);
      const auto behindPlane = [&](Color each) { return mix(each, theme.planeFace, theme.planeOpacity); };
      for (const Color ground : {theme.backgroundTop, theme.backgroundBottom}) {
        EXPECT_GE(contrast(color, ground), leastGhostContrast) << theme.name << ", " << nameOf(hue);
        EXPECT_GE(contrast(behindPlane(color), behindPlane(ground)), leastCoveredContrast) << theme.name;
      }
    }
}

TEST(Theme, HasNoTwoHuesAlike) {
  for (const Theme &theme : themes())
    for (const Hue hue : allHues)
      for (const Hue other : allHues)
        EXPECT_TRUE(hue == other || theme.colorOf(hue) != theme.colorOf(other))
            << theme.name << ": " << nameOf(hue) << ", " << nameOf(other);
}

TEST(Theme, IsFoundByItsName) {
  for (const char *name : {"light", "dark", "print", "projector"}) {
    ASSERT_NE(findTheme(name), nullptr);
    EXPECT_EQ(findTheme(name)->name, name);
  }
  EXPECT_EQ(findTheme("sepia"), nullptr);
}

TEST(Theme, MixGoesFromOneColourToTheOther) {
  const Color black{0, 0, 0};
  const Color orange{200, 100, 0};
  EXPECT_EQ(mix(black, orange, 0), black);
  EXPECT_EQ(mix(black, orange, 1), orange);
  EXPECT_EQ(mix(black, orange, 0.5), (Color{100, 50, 0}));
  EXPECT_EQ(mix(black, orange, 7), orange);
}

} // namespace
} // namespace halfspace
