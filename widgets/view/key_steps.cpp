#include "widgets/view/key_steps.h"

#include <cmath>

namespace halfspace {
namespace {

/// One of the axes x, y, z (0, 1, 2) and which way along it.
struct AxisStep {
  int axis;
  int sign;
};

int signOf(double value) { return value < 0 ? -1 : 1; }

std::optional<AxisStep> axisStep(int key, const Camera &camera) {
  const Place right = camera.right();
  const Place ahead = camera.viewDirection();
  const int across = std::abs(right.x) > std::abs(right.y) ? 0 : 1;
  const int away = 1 - across;
  switch (key) {
  case Qt::Key_Right:
    return AxisStep{across, signOf(right[across])};
  case Qt::Key_Left:
    return AxisStep{across, -signOf(right[across])};
  case Qt::Key_Up:
    return AxisStep{away, signOf(ahead[away])};
  case Qt::Key_Down:
    return AxisStep{away, -signOf(ahead[away])};
  case Qt::Key_PageUp:
    return AxisStep{2, 1};
  case Qt::Key_PageDown:
    return AxisStep{2, -1};
  default:
    return {};
  }
}

Rational modifiedStep(const Rational &step, Qt::KeyboardModifiers modifiers) {
  if (modifiers & Qt::ShiftModifier)
    return step / 10;
  return modifiers & Qt::ControlModifier ? Rational(step * 10) : step;
}

} // namespace

int verticalKey(int key) {
  return key == Qt::Key_Up ? Qt::Key_PageUp : key == Qt::Key_Down ? Qt::Key_PageDown : key;
}

std::optional<ExactVec3> steppedPlace(const Handle &handle, int key, Qt::KeyboardModifiers modifiers,
                                      const Rational &step, const Camera &camera) {
  const auto direction = axisStep(key, camera);
  if (!direction)
    return {};
  const Rational way = modifiedStep(step, modifiers) * direction->sign;
  ExactVec3 place = handle.at;
  if (handle.hasAxis())
    place += handle.axis * way;
  else
    place[direction->axis] += way;
  return place;
}

} // namespace halfspace
