// A thousand torpedoes, fired at a mesh of very many triangles by each way to search it.
#pragma once

#include "tests/geometry/every_search.h"

namespace halfspace {

class TorpedoesAtAMesh : public EverySearch {};

} // namespace halfspace
