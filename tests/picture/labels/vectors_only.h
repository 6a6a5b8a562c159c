// Labels set without a screen.
#pragma once

#include "tests/formula/laid_out.h"
#include "widgets/formula/set_formula.h"
#include "widgets/picture/labels/label_picture.h"

namespace halfspace {

/// Sets labels; nothing is painted.
inline LabelPainter vectorsOnly() {
  return {[](const std::string &latex) {
            return std::make_shared<const math::Layout>(math::setLatex(latex, math::fonts()).layout);
          },
          {}};
}

} // namespace halfspace
