// Torpedoes, fired at a mesh of very many triangles by each way to search it.
#pragma once

#include "tests/geometry/every_search.h"

#include <utility>

namespace halfspace {

/// Its parameter is a search, and how many seeds there are time for.
class TorpedoesAtAMesh : public testing::TestWithParam<std::pair<SearchKind, int>> {};

} // namespace halfspace
