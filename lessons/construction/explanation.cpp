#include "lessons/construction/explanation.h"

#include <algorithm>

namespace halfspace {

void Explanation::add(std::string id, std::function<WorkingLine()> make) {
  Lazy<WorkingLine> line([id, make = std::move(make)] {
    WorkingLine made = make();
    made.id = id;
    return made;
  });
  m_lines.push_back({std::move(id), std::move(line)});
}

std::vector<std::string> Explanation::ids() const {
  std::vector<std::string> ids;
  ids.reserve(m_lines.size());
  for (const Line &line : m_lines)
    ids.push_back(line.id);
  return ids;
}

const WorkingLine *Explanation::find(std::string_view id) const {
  const auto found =
      std::find_if(m_lines.begin(), m_lines.end(), [&](const Line &each) { return each.id == id; });
  return found == m_lines.end() ? nullptr : &*found->line;
}

} // namespace halfspace
