// Labels on the screen as vectors: which formula stands where. Pixels are one way to paint them.
#pragma once

#include "widgets/picture/labels/label_requests.h"

namespace halfspace {

/// A label that has its place.
struct LabelOnPage {
  LabelText text;
  LabelPainter::Formula formula;
  PlacedLabel place;
};

/// Sets labels and places them, from frame to frame. Empty ones, and those without a place, are left out.
/// Requires ids that stand once.
class LabelPage {
public:
  [[nodiscard]] std::vector<LabelOnPage> place(const std::vector<LabelText> &texts,
                                               const LabelObstacles &obstacles, const LabelPainter &painter,
                                               const View &view);

private:
  LabelLayout m_layout;
};

/// The leader from a label's anchor to the label; nothing for one that stands beside it.
[[nodiscard]] std::optional<LabelObstacles::Segment> leaderOf(const PlacedLabel &label);

} // namespace halfspace
