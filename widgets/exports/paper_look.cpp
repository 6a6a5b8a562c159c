#include "widgets/exports/paper_look.h"

#include "widgets/picture/labels/label_requests.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// A page is so many pixels wide: labels stand on whole ones, which are finer than what is printed.
constexpr int pixelsAcross = 4800;
/// No page is higher than so many times its width, nor wider than so many times its height.
constexpr double longest = 10;

} // namespace

std::optional<Color> groundOf(const PaperLook &look, Color background) {
  constexpr Color white{255, 255, 255};
  return look.hasGround && background != white ? std::optional(background) : std::nullopt;
}

View viewOnPaper(PixelSize shape, double width, double typeSize, const Theme &theme) {
  const double heightPerWidth =
      std::clamp(static_cast<double>(shape.height) / shape.width, 1 / longest, longest);
  const int height = static_cast<int>(std::lround(pixelsAcross * heightPerWidth));
  return {{}, {pixelsAcross, height}, typeSize / (markTextSize * theme.textScale) * pixelsAcross / width};
}

} // namespace halfspace
