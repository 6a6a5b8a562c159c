// Names of tests that are made for each of many things.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace halfspace::test {

/// After an id, without hyphens, which GoogleTest does not take: signed_distance.
inline std::string testName(const testing::TestParamInfo<std::string> &id) {
  std::string name = id.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

} // namespace halfspace::test
