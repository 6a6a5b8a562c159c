// Labels set without a screen.
#pragma once

#include "tests/picture/laid_out.h"
#include "widgets/picture/labels/label_picture.h"
#include "widgets/picture/math/set_formula.h"

namespace halfspace {

/// Sets labels; nothing is painted.
inline LabelPainter vectorsOnly() {
  return {[](const std::string &latex) {
            return std::make_shared<const math::Layout>(math::setLatex(latex, math::fonts()).layout);
          },
          {}};
}

} // namespace halfspace
