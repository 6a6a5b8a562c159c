#include "widgets/view/view_screen.h"

#include <algorithm>
#include <cmath>

namespace halfspace {

PixelSize ViewScreen::size() const {
  const double ratio = m_widget.devicePixelRatioF();
  return {std::max(1, static_cast<int>(std::lround(m_widget.width() * ratio))),
          std::max(1, static_cast<int>(std::lround(m_widget.height() * ratio)))};
}

glm::dvec2 ViewScreen::pixelAt(const QPointF &place) const {
  return glm::dvec2(place.x(), place.y()) * m_widget.devicePixelRatioF();
}

PixelBox ViewScreen::boxOf(const QRect &part) const {
  return {pixelAt(part.topLeft()), pixelAt(part.bottomRight() + QPoint(1, 1))};
}

} // namespace halfspace
