// New numbers for a scene in light: a vector, or a lamp, that shines past points onto a plane.
#pragma once

#include "lessons/lesson/new_numbers/net.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/vector.h"

#include <optional>

namespace halfspace {

/// The first point is a lamp, and the others are between it and the plane, so that they throw shadows; now
/// and then all are at any height.
class Lighting {
public:
  explicit Lighting(Dice &dice);

  /// What the light shines onto: it must be known before anything is drawn.
  void shineOnto(const Net &plane) { m_plane = plane; }
  [[nodiscard]] bool hasPlane() const { return m_plane.has_value(); }

  /// A step leads as far along the normal as this is long, towards the points in light or away from them.
  void draw(VectorObject &light);
  void draw(PointObject &point);
  /// The point that was drawn last stays as it is.
  void keepPoint();

private:
  /// In lengths of the normal. Most neighbours differ: the midpoint of equal ones is a special case.
  [[nodiscard]] int drawHeight();

  Dice &m_dice;
  int m_side;    ///< of the plane, on which the points are
  bool m_isFree; ///< all points are at any height
  std::optional<Net> m_plane;
  int m_height = 0;     ///< of the point that was drawn last
  int m_keptPoints = 0; ///< so many points stay as they are
  int m_keptHeight = 0; ///< of the last of them
};

} // namespace halfspace
