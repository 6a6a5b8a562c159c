// A camera as lessons and sessions write it.
#pragma once

#include "lessons/reading/document.h"
#include "lessons/scene/camera_view.h"

namespace halfspace {

/// Reads `from`, `at` and `height` of a node into a view; what is not there stays as it was. `field` is the
/// node's name in problems.
void readCameraView(const DocumentNode &node, const std::string &field, FieldReader &fields,
                    CameraView &view);

} // namespace halfspace
