// The ways to find a ray's first hit, each of which is held against the same laws.
#pragma once

#include "geometry/hit_search.h"

#include <gtest/gtest.h>

#include <memory>

namespace halfspace {

using MakeSearch = std::unique_ptr<HitSearch> (*)(const TriangleMesh &);

/// Its parameter makes a search of one kind ready.
class EverySearch : public testing::TestWithParam<MakeSearch> {};

} // namespace halfspace
