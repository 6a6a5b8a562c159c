#include "widgets/exports/paper_look.h"

#include "widgets/picture/labels/label_requests.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// No page is higher than so many times its width, nor wider than so many times its height.
constexpr double longest = 10;

} // namespace

std::optional<Color> groundOf(const PaperLook &look, Color background) {
  constexpr Color white{255, 255, 255};
  return look.hasGround && background != white ? std::optional(background) : std::nullopt;
}

View viewOnPaper(PixelSize shape, double width, double typeSize, const Theme &theme, int pixelsAcross) {
  const double heightPerWidth =
      std::clamp(static_cast<double>(shape.height) / shape.width, 1 / longest, longest);
  const int height = std::max(1, static_cast<int>(std::lround(pixelsAcross * heightPerWidth)));
  return {{}, {pixelsAcross, height}, typeSize / (markTextSize * theme.textScale) * pixelsAcross / width};
}

} // namespace halfspace
