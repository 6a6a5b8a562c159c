#include "lessons/lesson/new_numbers/sphere_numbers.h"

#include "geometry/surd.h"

namespace halfspace {

void SphereNumbers::draw(SphereObject &sphere) {
  const ExactVec3 reach = m_dice.shortNormal();
  sphere = {m_dice.position(), Surd::root(dot(reach, reach)).rationalPart()};
  m_sphere = sphere;
  m_isRich = true;
}

void SphereNumbers::drawAt(const Net &plane, SphereObject &sphere) {
  const Surd length = Surd::root(dot(plane.normal, plane.normal));
  if (!length.isRational())
    return draw(sphere);
  sphere.center = pointOf(plane, m_dice);
  sphere.center += plane.normal * Rational(m_dice.between(-1, 1));
  sphere.radius = m_dice.between(1, largestShortNumber);
  if (m_dice.once(3)) // where the centre is so far from the plane, it touches
    sphere.radius = length.rationalPart();
  m_sphere = sphere;
  m_isRich = false;
}

ExactVec3 SphereNumbers::reach() {
  const Rational &radius = m_sphere->radius;
  ExactVec3 reach{};
  if (!m_isRich) {
    reach[m_dice.between(0, 2)] = radius * m_dice.sign();
    return reach;
  }
  do
    reach = m_dice.shortNormal();
  while (dot(reach, reach) != radius * radius);
  return reach;
}

LineObject SphereNumbers::lineThrough() {
  const ExactVec3 first = reach();
  LineObject line{m_sphere->center + first, reach() - first};
  if (isZero(line.direction))
    line.direction = first;
  if (!m_dice.once(3))
    return line;
  const ExactVec3 across = stepAlong(first, 0, 1);
  line.direction = isZero(across) ? stepAlong(first, 0, 2) : across;
  line.point = m_sphere->center + first * Rational(m_dice.between(1, 2));
  return line;
}

ExactVec3 SphereNumbers::pointOnIt() {
  if (SphereObject hidden; !hasSphere())
    draw(hidden);
  return m_sphere->center + reach();
}

} // namespace halfspace
