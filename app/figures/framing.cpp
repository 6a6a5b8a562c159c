#include "app/figures/framing.h"

#include "widgets/picture/screen_shapes.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// Around what is drawn, in design pixels: lines have a width, and print needs air.
constexpr double margin = 6;
/// What is drawn fills its page well enough with this part of it.
constexpr double wellFilled = 0.98;
/// Labels come to stand elsewhere when a view grows, so that the best size is found in steps.
constexpr int mostSteps = 8;
/// A small figure is not drawn larger than so many times: its labels would be lost in it.
constexpr double mostMagnified = 3;

/// The view so many times as large, and not narrower than it was: it shows more at its left and its right
/// rather than that, and nothing on it moves or grows.
View magnified(const View &view, double factor) {
  View larger = view;
  larger.size = {std::max(view.size.width, static_cast<int>(std::lround(view.size.width * factor))),
                 std::max(1, static_cast<int>(std::lround(view.size.height * factor)))};
  return larger;
}

/// The place of a page of a length along a side of the view, around a middle.
double pageStart(double middle, double length, double side) {
  return std::clamp(std::round(middle - length / 2), 0.0, side - length);
}

} // namespace

Framing wholeOf(const View &view) { return {view, view.box()}; }

Framing croppedTo(const View &view, int longestSide,
                  const std::function<std::optional<PixelBox>(const View &)> &drawnOn) {
  const double mostFactor = std::clamp(
      static_cast<double>(longestSide) / std::max(view.size.width, view.size.height), 1.0, mostMagnified);
  const double width = view.size.width;
  const glm::dvec2 most(width, std::round(width * highestPage));
  double factor = 1;
  View larger = view;
  auto drawn = drawnOn(larger);
  for (int step = 0; drawn && step < mostSteps; ++step) {
    const glm::dvec2 fits = most / grown(*drawn, margin * view.pixelRatio).extent();
    const double fit = std::min(fits.x, fits.y);
    const bool isLargest = factor >= mostFactor && fit >= 1;
    if (isLargest || (fit >= 1 && fit * wellFilled <= 1))
      break;
    factor = std::min(factor * (fit < 1 ? fit * (1 + wellFilled) / 2 : fit), mostFactor);
    larger = magnified(view, factor);
    drawn = drawnOn(larger);
  }
  if (!drawn)
    return wholeOf(view);
  const PixelBox kept = grown(*drawn, margin * view.pixelRatio);
  const double height =
      std::clamp(std::ceil(kept.extent().y), 1.0, std::min<double>(most.y, larger.size.height));
  const glm::dvec2 middle = (kept.low + kept.high) / 2.0;
  const glm::dvec2 low(pageStart(middle.x, width, larger.size.width),
                       pageStart(middle.y, height, larger.size.height));
  return {larger, {low, low + glm::dvec2(width, height)}};
}

} // namespace halfspace
