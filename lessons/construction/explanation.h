// The worked lines of a construction, each made when somebody looks at it.
#pragma once

#include "lessons/construction/working.h"
#include "lessons/lazy.h"

#include <functional>

namespace halfspace {

class Explanation {
public:
  /// Goes on with a line, which gets the id. What `make` refers to must live as long as the explanation.
  void add(std::string id, std::function<WorkingLine()> make);

  /// The ids of the lines, in their order.
  [[nodiscard]] const std::vector<std::string> &ids() const { return m_ids; }
  /// Whether there is a line with this id; it is not made.
  [[nodiscard]] bool has(std::string_view id) const;
  /// The line with this id, or null.
  [[nodiscard]] const WorkingLine *find(std::string_view id) const;

private:
  std::vector<std::string> m_ids;
  std::vector<Lazy<WorkingLine>> m_lines; ///< in the order of the ids
};

} // namespace halfspace
