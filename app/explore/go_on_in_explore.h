// From a lesson to Explore.
#pragma once

#include "widgets/session_model.h"

namespace halfspace {

class SessionFiles;

/// Opens Explore with a scene, seen as the present one is seen. The lesson stays as it is, and what was in
/// Explore before comes back with Undo; its file, if it has one, is not written over.
void goOnInExplore(SessionModel &model, SessionFiles &files, const Scene &scene);

} // namespace halfspace
