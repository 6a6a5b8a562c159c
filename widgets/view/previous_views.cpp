#include "widgets/view/previous_views.h"

namespace halfspace {

namespace {

constexpr std::size_t mostViews = 50;

} // namespace

void PreviousViews::remember(const Camera &camera) {
  m_isZooming = false;
  if (m_views.size() == mostViews)
    m_views.erase(m_views.begin());
  m_views.push_back(camera);
  emit changed();
}

void PreviousViews::rememberZoomed(const Camera &camera) {
  if (!m_isZooming)
    remember(camera);
  m_isZooming = true;
}

void PreviousViews::forget() {
  m_isZooming = false;
  m_views.clear();
  emit changed();
}

std::optional<Camera> PreviousViews::takeLast() {
  if (m_views.empty())
    return std::nullopt;
  const Camera last = m_views.back();
  m_isZooming = false;
  m_views.pop_back();
  emit changed();
  return last;
}

} // namespace halfspace
