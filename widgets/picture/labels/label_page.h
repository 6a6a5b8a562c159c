// Labels on the screen as vectors: which formula stands where. Pixels are one way to paint them.
#pragma once

#include "widgets/picture/labels/label_requests.h"
#include "widgets/picture/labels/label_setter.h"
#include "widgets/picture/shapes/shape.h"

namespace halfspace {

/// A label that has its place.
struct LabelOnPage {
  WrittenLabel text;
  LabelFormula formula;
  PlacedLabel place;
};

/// Sets labels and places them, from frame to frame. Empty ones, and those without a place, are left out.
/// Requires ids that stand once.
class LabelPage {
public:
  [[nodiscard]] std::vector<LabelOnPage> place(const std::vector<WrittenLabel> &texts,
                                               const LabelObstacles &obstacles, const LabelSetter &set,
                                               const View &view);

private:
  LabelLayout m_layout;
};

/// The leader from a label's anchor to the label; nothing for one that stands beside it.
[[nodiscard]] std::optional<LabelObstacles::Segment> leaderOf(const PlacedLabel &label);

/// Of leaders, in design pixels.
inline constexpr double leaderWidth = 1;

/// What labels look like on the page: leaders, so many pixels wide, and before them the formulas.
[[nodiscard]] std::vector<Shape> shapesOf(const std::vector<LabelOnPage> &labels, Color leaders,
                                          double width);

} // namespace halfspace
