// Parts that are painted behind others.
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

namespace halfspace {

/// Moves more to the end of a list.
template <class Part, class More> void append(std::vector<Part> &parts, std::vector<More> more) {
  std::move(more.begin(), more.end(), std::back_inserter(parts));
}

} // namespace halfspace
