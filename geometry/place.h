// Where a point lies in a body.
#pragma once

namespace halfspace {

/// On: on the body's surface.
enum class SolidPlace { Outside, On, Inside };

} // namespace halfspace
