#include "lessons/lesson/new_numbers/lighting.h"

namespace halfspace {
namespace {

/// Light gets so many chances to come to the plane in short steps; most need a few.
constexpr int mostAttempts = 100;

// What is left to chance.
constexpr int levelOnceIn = 6; ///< neighbours
constexpr int freeOnceIn = 6;  ///< scenes

/// How high a lamp is over the plane, in lengths of the normal.
constexpr int lampHeight = 3;

} // namespace

Lighting::Lighting(Dice &dice) : m_dice(dice), m_side(dice.sign()), m_isFree(dice.once(freeOnceIn)) {}

void Lighting::draw(VectorObject &light) {
  const ExactVec3 &normal = m_plane->normal;
  const auto isWhole = [&] { return abs(dot(normal, light.vector)) == dot(normal, normal); };
  light.start = m_dice.position();
  light.vector = m_dice.direction(longestStep);
  for (int attempt = 0; attempt < mostAttempts && !isWhole(); ++attempt)
    light.vector = m_dice.direction(longestStep);
}

void Lighting::draw(PointObject &point) {
  const ExactVec3 foot = m_keptPoints == 0 ? m_plane->at : pointOf(*m_plane, m_dice);
  m_height = drawHeight();
  point.at = foot + m_plane->normal * Rational(m_side * m_height);
}

void Lighting::keepPoint() {
  ++m_keptPoints;
  m_keptHeight = m_height;
}

int Lighting::drawHeight() {
  if (m_isFree)
    return m_dice.between(0, lampHeight);
  if (m_keptPoints == 0)
    return lampHeight;
  const bool isFirst = m_keptPoints == 1;
  return isFirst || m_dice.once(levelOnceIn) ? m_dice.between(1, lampHeight - 1) : lampHeight - m_keptHeight;
}

} // namespace halfspace
