#include "widgets/picture/labels/label_page.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace halfspace {
namespace {

/// Nothing that is to be read is drawn larger.
constexpr int largestLabelSide = 4096;

/// From an anchor to the middle of a label that is so large.
glm::dvec2 offsetOf(const LabelSpot &spot, double em, glm::dvec2 extent) {
  const glm::dvec2 toMiddle(extent.x / 2, 0);
  switch (spot.side) {
  case LabelSpot::Side::Left:
    return spot.offset * em + toMiddle;
  case LabelSpot::Side::Right:
    return spot.offset * em - toMiddle;
  case LabelSpot::Side::Middle:
    break;
  }
  return spot.offset * em;
}

LabelRequest requestFor(const WrittenLabel &text, glm::dvec2 extent) {
  LabelRequest request{text.id, extent, text.anchors, text.stand, text.owner, text.row};
  if (text.spot && text.own) {
    request.anchors = {*text.own};
    request.stand = LabelStand::ByHand;
    request.offset = offsetOf(*text.spot, text.style.pixelSize, extent);
  }
  return request;
}

} // namespace

LabelRoom roomOf(const math::Layout &formula, const LabelStyle &style) {
  const double em = style.pixelSize;
  const int margin = static_cast<int>(std::ceil(haloWidth * em)) + 1;
  const auto side = [&](double length) {
    return std::clamp(static_cast<int>(std::ceil(length * em)) + 1 + 2 * margin, 1, largestLabelSide);
  };
  return {side(formula.width), side(formula.ascent + formula.depth), margin,
          margin + static_cast<int>(std::ceil(formula.ascent * em))};
}

std::vector<LabelOnPage> LabelPage::place(const std::vector<WrittenLabel> &texts,
                                          const LabelObstacles &obstacles, const LabelSetter &set,
                                          const View &view) {
  std::vector<LabelRequest> requests;
  std::unordered_map<std::string, LabelOnPage> byId;
  for (const WrittenLabel &text : texts) {
    LabelFormula formula = set(text.latex);
    if (formula->glyphs.empty() && formula->rules.empty())
      continue;
    const LabelRoom room = roomOf(*formula, text.style);
    requests.push_back(requestFor(text, {room.width, room.height}));
    byId.insert_or_assign(text.id, LabelOnPage{text, std::move(formula), {}});
  }
  std::vector<LabelOnPage> page;
  for (const PlacedLabel &placed : m_layout.place(requests, obstacles, view.size, view.pixelRatio)) {
    LabelOnPage &label = byId.at(placed.id);
    label.place = placed;
    page.push_back(std::move(label));
  }
  return page;
}

std::optional<LabelObstacles::Segment> leaderOf(const PlacedLabel &label) {
  if (!label.needsLeader)
    return {};
  return leaderTo({label.topLeft, label.topLeft + label.extent}, label.anchor);
}

std::vector<Shape> shapesOf(const std::vector<LabelOnPage> &labels, Color leaders, double width) {
  std::vector<Shape> shapes;
  const auto markOf = [](const LabelOnPage &label) {
    return label.text.isMark ? label.text.id : std::string();
  };
  for (const LabelOnPage &label : labels)
    if (const auto leader = leaderOf(label.place))
      shapes.push_back({markOf(label), leaders, LeaderShape{leader->from, leader->to, width}});
  for (const LabelOnPage &label : labels) {
    const PixelBox box{label.place.topLeft, label.place.topLeft + label.place.extent};
    shapes.push_back({markOf(label), label.text.style.ink,
                      LabelShape{label.text.latex, label.formula, label.text.style, box, label.text.opacity,
                                 label.text.own ? std::optional(label.text.own->pixel) : std::nullopt}});
  }
  return shapes;
}

} // namespace halfspace
