// What a change of a view's size does to its camera.
#pragma once

#include "widgets/picture/camera.h"

#include <optional>

namespace halfspace {

/// Keeps what is between the left and the right side of a view there while its size changes. Until another
/// camera is brought, each change begins where the first one did, so that a view that gets its size back has
/// its camera back.
class ResizedCamera {
public:
  /// The view has another size, and its camera is one that was made for that.
  void setSize(PixelSize size) { m_size = size; }
  /// The camera for a view that has another size; the same camera for the same size. The first size of a view
  /// follows upon a square.
  [[nodiscard]] Camera resized(const Camera &camera, PixelSize now);

private:
  struct Change {
    Camera before;
    PixelSize size; ///< before
    Camera after;
  };

  PixelSize m_size;
  std::optional<Change> m_newest;
};

} // namespace halfspace
