#include "tests/lessons/construction/claims/four_points.h"

namespace halfspace::test::claims {

Claims circumsphere_points() { return sphereThroughClaims(); }

} // namespace halfspace::test::claims
