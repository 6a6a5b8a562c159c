// What is true of objects without being meant: that three points lie on one line.
#pragma once

#include "lessons/scene/evaluation.h"

namespace halfspace {

/// Something that holds of objects as they are.
struct Discovery {
  std::string sentence;         ///< “A, B and C lie on one line.”
  std::vector<std::string> ids; ///< of the objects that it is about
  /// Whether it holds wherever the free objects are that these follow. It is tried at random places, so that
  /// yes can be wrong, though too seldom to be seen; no where the objects are there at too few of them.
  bool isAlways = false;
};

/// So many objects are looked at together.
inline constexpr std::size_t mostLookedAt = 4;

/// All that holds of the objects of these ids, `Q` or `distance.F`, and of nothing else: what always holds
/// first. Objects that are not there at present, that have no direction or normal where they need one, or
/// that stand behind the first `mostLookedAt`, are left out. All is decided with exact numbers.
[[nodiscard]] std::vector<Discovery> discoveriesOf(const Evaluation &evaluation,
                                                   const std::vector<std::string> &selected);

/// A discovery with how far it holds, in sentences.
[[nodiscard]] std::string wordsFor(const Discovery &discovery);

} // namespace halfspace
