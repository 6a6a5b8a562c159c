// The colours of marked terms.
#pragma once

#include "widgets/colors.h"
#include "widgets/session_model.h"
#include "widgets/typeset/math_picture.h"

namespace halfspace {

/// The ink of each mark that is drawn; terms of others have the theme's. So, while a question is open, none
/// gives the answer away by its colour. The model must outlive it.
[[nodiscard]] inline MathPicture::InkOf markInk(const SessionModel &model, const Theme &theme) {
  return [&model, theme](const QString &markId) {
    const Mark *mark = findMark(model.shown().figure, markId.toStdString());
    return toQColor(mark ? theme.inkOf(hueOf(baseOf(*mark))) : theme.ink);
  };
}

} // namespace halfspace
