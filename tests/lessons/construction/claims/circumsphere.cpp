#include "tests/lessons/construction/claims/four_points.h"

namespace halfspace::test::claims {

Claims circumsphere() { return sphereThroughClaims(); }

} // namespace halfspace::test::claims
