// The colours of marked terms.
#pragma once

#include "widgets/colors.h"
#include "widgets/session_model.h"
#include "widgets/typeset/math_picture.h"

namespace halfspace {

/// The ink of each mark of the model's figure; terms without a mark have the theme's. The model must outlive
/// it.
[[nodiscard]] inline MathPicture::InkOf markInk(const SessionModel &model, const Theme &theme) {
  return [&model, theme](const QString &markId) {
    const Mark *mark = findMark(model.figure(), markId.toStdString());
    return toQColor(mark ? theme.inkOf(baseOf(*mark).subject) : theme.ink);
  };
}

} // namespace halfspace
