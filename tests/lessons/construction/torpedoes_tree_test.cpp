#include "tests/lessons/construction/torpedoes.h"

#include "geometry/hit_finder.h"

namespace halfspace {
namespace {

INSTANTIATE_TEST_SUITE_P(Tree, TorpedoesAtAMesh,
                         testing::Values(std::pair<MakeSearch, int>(
                             [](const TriangleMesh &mesh) -> std::unique_ptr<HitSearch> {
                               return std::make_unique<HitFinder>(trianglesOf(mesh));
                             },
                             125)));

} // namespace
} // namespace halfspace
