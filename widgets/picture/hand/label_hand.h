// A hand that moves labels, whoever shows the picture.
#pragma once

#include "lessons/scene/edit.h"
#include "widgets/picture/shapes/shape_list.h"

#include <optional>
#include <string>

namespace halfspace {

/// The label of a mark as it was taken hold of. In pixels of the picture.
struct HeldLabel {
  std::string mark;
  PixelBox box;        ///< where it stood
  glm::dvec2 anchor{}; ///< of its mark
  double em = 0;       ///< the size of its type
  glm::dvec2 grip{};   ///< the pixel at which it is held
};

/// The label of a mark that lies under a pixel of a picture (the first of several), or null.
[[nodiscard]] const Shape *labelUnder(glm::dvec2 pixel, const ShapeList &picture);

/// The label under a pixel, held there; nothing where there is none that a hand can move.
[[nodiscard]] std::optional<HeldLabel> takeLabel(const ShapeList &picture, glm::dvec2 pixel);

/// What a hand that has gone to a pixel has done: the label went with it.
[[nodiscard]] ChangeLabel moveLabel(const HeldLabel &held, glm::dvec2 pixel);
/// Hides the label of a mark, or shows it again, where it would stand.
[[nodiscard]] ChangeLabel hideLabel(const Scene &scene, const std::string &mark, bool isHidden);
/// Leaves the label of a mark to the program again.
[[nodiscard]] ChangeLabel putLabelBack(const std::string &mark);

} // namespace halfspace
