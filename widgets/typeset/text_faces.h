// The faces that the program carries with it for running words.
#pragma once

#include "widgets/formula/text_faces.h"

namespace halfspace {

/// For one thread at a time.
[[nodiscard]] math::TextFaces textFaces();

} // namespace halfspace
