// The constructions, for tests that are made for each.
#pragma once

#include "lessons/construction/construction.h"

#include <string>
#include <vector>

namespace halfspace::test {

inline std::vector<std::string> constructionIds() {
  std::vector<std::string> ids;
  for (const Construction &construction : constructions())
    ids.emplace_back(construction.id);
  return ids;
}

} // namespace halfspace::test
