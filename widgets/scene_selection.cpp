#include "widgets/scene_selection.h"

#include <algorithm>
#include <utility>

namespace halfspace {

bool SceneSelection::contains(const std::string &id) const {
  return std::find(m_ids.begin(), m_ids.end(), id) != m_ids.end();
}

void SceneSelection::set(std::vector<std::string> ids) {
  if (ids == m_ids)
    return;
  m_ids = std::move(ids);
  emit changed();
}

void SceneSelection::toggle(const std::string &id) {
  std::vector<std::string> others = m_ids;
  if (std::erase(others, id) == 0)
    others.push_back(id);
  set(std::move(others));
}

} // namespace halfspace
