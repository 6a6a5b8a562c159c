#include "tests/geometry/tree_search.h"
#include "tests/lessons/construction/torpedoes.h"

namespace halfspace {
namespace {

INSTANTIATE_TEST_SUITE_P(Tree, TorpedoesAtAMesh, testing::Values(std::pair(treeSearch, 125)));

} // namespace
} // namespace halfspace
