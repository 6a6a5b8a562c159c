// The scene of a session as a view has it.
#pragma once

#include "widgets/picture/stage.h"
#include "widgets/session_model.h"

#include <utility>

namespace halfspace {

/// The session's scene, with its bound objects where they are, in units of a stage. What the step hides is
/// hidden there.
[[nodiscard]] inline PlacedScene stagedScene(const SessionModel &model, const Stage &stage) {
  PlacedScene placed(model.session().scene, model.evaluation());
  for (const std::string &name : model.step().hidden)
    if (const auto place = placed.scene.entries.placeOf(name))
      placed.scene.entries.change(*place, [](Entry &entry) { entry.isHidden = true; });
  return toStage(std::move(placed), stage);
}

} // namespace halfspace
