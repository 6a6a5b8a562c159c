#include "widgets/picture/hand/label_hand.h"

#include <algorithm>

namespace halfspace {
namespace {

bool isIn(const PixelBox &box, glm::dvec2 pixel) {
  return pixel.x >= box.low.x && pixel.y >= box.low.y && pixel.x < box.high.x && pixel.y < box.high.y;
}

/// The spot at which a label fills a box. It leads to the side that faces the anchor, so that a label that
/// grows does not grow over its mark.
LabelSpot spotOf(const PixelBox &box, glm::dvec2 anchor, double em) {
  const double height = (box.low.y + box.high.y) / 2;
  LabelSpot spot{{(box.low.x + box.high.x) / 2, height}, LabelSpot::Side::Middle};
  if (box.low.x >= anchor.x)
    spot = {{box.low.x, height}, LabelSpot::Side::Left};
  else if (box.high.x <= anchor.x)
    spot = {{box.high.x, height}, LabelSpot::Side::Right};
  spot.offset = (spot.offset - anchor) / em;
  return settled(spot);
}

} // namespace

const Shape *labelUnder(glm::dvec2 pixel, const ShapeList &picture) {
  const std::vector<Shape> &shapes = *picture.layer(Layer::Labels);
  const auto found = std::find_if(shapes.begin(), shapes.end(), [&](const Shape &shape) {
    const auto *label = std::get_if<LabelShape>(&shape.form);
    return label && !shape.mark.empty() && isIn(label->box, pixel);
  });
  return found == shapes.end() ? nullptr : &*found;
}

std::optional<HeldLabel> takeLabel(const ShapeList &picture, glm::dvec2 pixel) {
  const Shape *shape = labelUnder(pixel, picture);
  const auto *label = shape ? std::get_if<LabelShape>(&shape->form) : nullptr;
  if (!label || !label->anchor)
    return {};
  return HeldLabel{shape->mark, label->box, *label->anchor, label->style.pixelSize, pixel};
}

ChangeLabel moveLabel(const HeldLabel &held, glm::dvec2 pixel) {
  const glm::dvec2 way = pixel - held.grip;
  const PixelBox box{held.box.low + way, held.box.high + way};
  return {held.mark, LabelByHand{spotOf(box, held.anchor, held.em)}};
}

ChangeLabel hideLabel(const Scene &scene, const std::string &mark, bool isHidden) {
  const auto known = scene.labels.find(mark);
  LabelByHand label = known == scene.labels.end() ? LabelByHand() : known->second;
  label.isHidden = isHidden;
  return {mark, label};
}

ChangeLabel putLabelBack(const std::string &mark) { return {mark, std::nullopt}; }

} // namespace halfspace
