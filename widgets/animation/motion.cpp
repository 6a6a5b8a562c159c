#include "widgets/animation/motion.h"

#include <algorithm>

namespace halfspace {

const MotionKind *findMotionKind(std::string_view name) {
  const auto &kinds = motionKinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const MotionKind &kind) { return kind.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

} // namespace halfspace
