// Which part of a view becomes a figure.
#include "app/figures/framing.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

constexpr int unbounded = 1'000'000;

View viewOf(PixelSize size) { return {{}, size, 1}; }

/// As if a drawing took this part of a view, and labels of a fixed size beside it.
auto drawing(glm::dvec2 low, glm::dvec2 high, double labels) {
  return [=](const View &view) -> std::optional<PixelBox> {
    const glm::dvec2 middle = glm::dvec2(view.size.width, view.size.height) / 2.0;
    const double height = view.size.height; // what a view shows is measured by it
    return PixelBox{middle + low * height, middle + high * height + labels};
  };
}

TEST(Framing, OfAWholeView_IsAllOfIt) {
  const Framing framing = wholeOf(viewOf({600, 400}));
  EXPECT_EQ(framing.page, (PixelBox{{0, 0}, {600, 400}}));
}

TEST(Framing, Cropped_IsAsWideAsTheView_AndAroundWhatIsDrawn) {
  const auto drawnOn = drawing({-0.4, -0.2}, {0.5, 0.2}, 30);
  const Framing framing = croppedTo(viewOf({1600, 1000}), unbounded, drawnOn);
  const PixelBox drawn = *drawnOn(framing.view);
  EXPECT_EQ(framing.page.extent().x, 1600);
  EXPECT_LE(framing.page.low.x, drawn.low.x);
  EXPECT_LE(framing.page.low.y, drawn.low.y);
  EXPECT_GE(framing.page.high.x, drawn.high.x);
  EXPECT_GE(framing.page.high.y, drawn.high.y);
  EXPECT_GT(drawn.extent().x, 0.95 * 1600) << "it fills the page";
  EXPECT_LT(framing.page.extent().y, drawn.extent().y + 20);
}

TEST(Framing, CroppedToWhatIsTall_IsNoHigherThanAFigureMayBe) {
  const auto drawnOn = drawing({-0.05, -0.45}, {0.05, 0.45}, 0);
  const Framing framing = croppedTo(viewOf({600, 1000}), unbounded, drawnOn);
  const PixelBox drawn = *drawnOn(framing.view);
  EXPECT_EQ(framing.page.extent().x, 600);
  EXPECT_LE(framing.page.extent().y, 600 * highestPage);
  EXPECT_LE(framing.page.low.y, drawn.low.y);
  EXPECT_GE(framing.page.high.y, drawn.high.y);
  EXPECT_GE(framing.page.low.x, 0);
  EXPECT_LE(framing.page.high.x, framing.view.size.width);
}

TEST(Framing, CroppedToADot_IsNotMagnifiedWithoutEnd) {
  const Framing framing = croppedTo(viewOf({600, 400}), unbounded, drawing({0, 0}, {0.001, 0.001}, 0));
  EXPECT_LE(framing.view.size.width, 3 * 600);
  EXPECT_EQ(framing.page.extent().x, 600);
}

TEST(Framing, Cropped_GrowsNoLargerThanItMay) {
  const Framing framing = croppedTo(viewOf({600, 400}), 700, drawing({0, 0}, {0.1, 0.1}, 0));
  EXPECT_LE(framing.view.size.width, 700);
  EXPECT_EQ(framing.page.extent().x, 600);
  EXPECT_EQ(croppedTo(viewOf({600, 400}), 100, drawing({0, 0}, {0.1, 0.1}, 0)).view.size.width, 600);
}

TEST(Framing, CroppedToNothing_IsTheWholeView) {
  const Framing framing =
      croppedTo(viewOf({600, 400}), unbounded, [](const View &) { return std::optional<PixelBox>(); });
  EXPECT_EQ(framing.page, (PixelBox{{0, 0}, {600, 400}}));
}

} // namespace
} // namespace halfspace
