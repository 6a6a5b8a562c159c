// The ways to find a ray's first hit, each of which is held against the same laws.
#pragma once

#include "geometry/search/hit_search.h"

#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <string>

namespace halfspace {

/// Tests are named after it.
struct SearchKind {
  std::string name; ///< of its class
  std::unique_ptr<HitSearch> (*make)(const TriangleMesh &);

  friend std::ostream &operator<<(std::ostream &out, const SearchKind &kind) { return out << kind.name; }
};

inline const SearchKind plainSearch{"PlainHitSearch",
                                    [](const TriangleMesh &mesh) -> std::unique_ptr<HitSearch> {
                                      return std::make_unique<PlainHitSearch>(mesh);
                                    }};

class EverySearch : public testing::TestWithParam<SearchKind> {};

} // namespace halfspace
