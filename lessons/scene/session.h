// The one owner of state: which lesson, which step, which scene.
#pragma once

#include "lessons/scene/camera_view.h"
#include "lessons/scene/edit.h"

namespace halfspace {

struct Session {
  std::string lesson; ///< the lesson's id
  int step = 0;       ///< the step shown, from 0
  Scene scene;
  std::optional<ChosenView> view{}; ///< nothing: as the lesson begins

  /// Who looks at the same from elsewhere has changed nothing.
  bool operator==(const Session &other) const {
    return lesson == other.lesson && step == other.step && scene == other.scene;
  }
};

/// The session after an edit of its scene; or why that is refused.
[[nodiscard]] inline Result<Session> apply(Session session, const Edit &edit) {
  auto scene = apply(std::move(session.scene), edit);
  if (!scene)
    return scene.problem();
  session.scene = std::move(*scene);
  return session;
}

} // namespace halfspace
