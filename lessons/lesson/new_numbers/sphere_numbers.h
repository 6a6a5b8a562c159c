// New numbers for spheres, and for what looks for whole points of them.
#pragma once

#include "lessons/lesson/new_numbers/net.h"
#include "lessons/object/kinds/sphere.h"

#include <optional>

namespace halfspace {

class SphereNumbers {
public:
  explicit SphereNumbers(Dice &dice) : m_dice(dice) {}

  [[nodiscard]] bool hasSphere() const { return m_sphere.has_value(); }
  /// Many whole points lie on it.
  void draw(SphereObject &sphere);
  /// The plane cuts the sphere, perhaps through its centre, touches it or passes by.
  void drawAt(const Net &plane, SphereObject &sphere);

  /// Through two whole points of the sphere that was drawn last; now and then so that it touches it, or
  /// passes by. Requires that there is one.
  [[nodiscard]] LineObject lineThrough();

  /// A whole point of that sphere, or of one that is drawn first.
  [[nodiscard]] ExactVec3 pointOnIt();

private:
  /// From the centre to one of its whole points.
  [[nodiscard]] ExactVec3 reach();

  Dice &m_dice;
  std::optional<SphereObject> m_sphere; ///< the last
  bool m_isRich = false; ///< many whole points lie on it; on others those straight along the axes
};

} // namespace halfspace
