#include "lessons/construction/explanation.h"

#include <algorithm>

namespace halfspace {

void Explanation::add(std::string id, std::function<WorkingLine()> make) {
  m_lines.emplace_back([id, make = std::move(make)] {
    WorkingLine made = make();
    made.id = id;
    return made;
  });
  m_ids.push_back(std::move(id));
}

bool Explanation::has(std::string_view id) const {
  return std::find(m_ids.begin(), m_ids.end(), id) != m_ids.end();
}

const WorkingLine *Explanation::find(std::string_view id) const {
  const auto found = std::find(m_ids.begin(), m_ids.end(), id);
  return found == m_ids.end() ? nullptr : &*m_lines[static_cast<std::size_t>(found - m_ids.begin())];
}

} // namespace halfspace
