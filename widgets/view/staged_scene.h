// The scene of a session as a view has it.
#pragma once

#include "widgets/picture/stage.h"
#include "widgets/session_model.h"

namespace halfspace {

/// The session's scene, with its bound objects where they are, in units of a stage.
[[nodiscard]] inline PlacedScene stagedScene(const SessionModel &model, const Stage &stage) {
  return toStage({model.session().scene, model.evaluation()}, stage);
}

} // namespace halfspace
