// Where the handles of a view are seen.
#pragma once

#include "widgets/view/scene_view.h"

#include <cmath>

namespace halfspace {

/// The pixel of the widget (not of the device) at which a handle is drawn, if it is in view.
inline std::optional<QPoint> handlePosition(SceneView &view, const std::string &handleId) {
  const Handle *handle = view.handles().selection().find(handleId);
  const auto projected =
      handle ? view.viewpoint().camera().project(shownPlace(*handle), view.screen().size()) : std::nullopt;
  if (!projected)
    return {};
  const double ratio = view.devicePixelRatioF();
  const QPoint position(static_cast<int>(std::lround(projected->x / ratio)),
                        static_cast<int>(std::lround(projected->y / ratio)));
  return view.rect().contains(position) ? std::optional(position) : std::nullopt;
}

} // namespace halfspace
