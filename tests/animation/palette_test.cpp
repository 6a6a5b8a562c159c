#include "widgets/animation/palette.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace halfspace {
namespace {

RgbaImage imageOf(const std::vector<Color> &colors, std::uint8_t alpha = 255) {
  RgbaImage image{static_cast<int>(colors.size()), 1, {}};
  for (const Color &color : colors)
    image.rgba.insert(image.rgba.end(), {color.red, color.green, color.blue, alpha});
  return image;
}

TEST(Palette, OfFewColors_HasThemExactly) {
  const std::vector<Color> colors{{255, 255, 255}, {0, 0, 0}, {213, 94, 0}, {0, 114, 178}, {254, 255, 255}};
  ColorSamples samples(1);
  samples.add(imageOf(colors));
  Palette palette(samples, 255);
  for (int again = 0; again < 2; ++again) // what is known is as it was
    for (const Color &color : colors)
      EXPECT_EQ(palette.colors()[palette.nearest(color)], color);
}

TEST(Palette, OfVeryManyColors_HasOneNearEach) {
  std::vector<Color> colors;
  for (int red = 0; red < 256; red += 4)
    for (int blue = 0; blue < 256; blue += 4)
      colors.push_back({static_cast<std::uint8_t>(red), 128, static_cast<std::uint8_t>(blue)});
  ColorSamples samples(1);
  samples.add(imageOf(colors));
  Palette palette(samples, 255);
  EXPECT_LE(palette.colors().size(), 255U);
  for (const Color &color : colors) {
    const Color near = palette.colors()[palette.nearest(color)];
    EXPECT_LE(std::abs(near.red - color.red), 24);
    EXPECT_LE(std::abs(near.blue - color.blue), 24);
  }
}

TEST(Palette, OfPixelsThatAreNotDrawn_HasNoneOfTheirColors) {
  ColorSamples samples(2);
  samples.add(imageOf({{10, 20, 30}}, 0));
  samples.add(imageOf({{200, 100, 50}}));
  EXPECT_EQ(Palette(samples, 255).colors(), (std::vector<Color>{{200, 100, 50}}));
}

TEST(Palette, OfNothing_HasAColorAllTheSame) {
  Palette palette(ColorSamples(1), 255);
  EXPECT_EQ(palette.nearest({1, 2, 3}), 0);
  EXPECT_EQ(palette.colors().size(), 1U);
}

} // namespace
} // namespace halfspace
