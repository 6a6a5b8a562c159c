// From a lesson to Explore.
#pragma once

#include "widgets/session_model.h"

namespace halfspace {

/// Opens Explore with a scene, seen as the present one is seen. The lesson stays as it is, and what was in
/// Explore before comes back with Undo.
void goOnInExplore(SessionModel &model, const Scene &scene);

} // namespace halfspace
