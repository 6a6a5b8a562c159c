// Labels set without a screen.
#pragma once

#include "tests/formula/laid_out.h"
#include "widgets/picture/labels/label_setter.h"

namespace halfspace {

inline LabelSetter vectorsOnly() { return labelSetter(math::fonts()); }

} // namespace halfspace
