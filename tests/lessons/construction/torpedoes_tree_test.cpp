#include "tests/lessons/construction/torpedoes.h"

#include "geometry/hit_finder.h"

namespace halfspace {
namespace {

INSTANTIATE_TEST_SUITE_P(Tree, TorpedoesAtAMesh, testing::Values([](const TriangleMesh &mesh) {
                           return std::unique_ptr<HitSearch>(std::make_unique<HitFinder>(trianglesOf(mesh)));
                         }));

} // namespace
} // namespace halfspace
