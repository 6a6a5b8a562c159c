// Which part of which view becomes a figure.
#pragma once

#include "widgets/picture/view.h"

#include <functional>
#include <optional>

namespace halfspace {

struct Framing {
  View view;
  PixelBox page; ///< the part of the view that is kept, on whole pixels
};

/// The whole of a view.
[[nodiscard]] Framing wholeOf(const View &view);

/// What is drawn on a view, as large as it fits on a page that is as wide as the view, and no higher than
/// `highestPage` times that. The view does not grow beyond `longestSide` for it, in pixels. `drawnOn` says
/// what that is on a view of another size: labels do not grow with it. Where nothing is drawn, the whole of
/// it.
[[nodiscard]] Framing croppedTo(const View &view, int longestSide,
                                const std::function<std::optional<PixelBox>(const View &)> &drawnOn);

/// A figure beside text is not higher than so many times its width.
inline constexpr double highestPage = 4.0 / 3;

} // namespace halfspace
