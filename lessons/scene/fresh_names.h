// Names for what is to come into a scene.
#pragma once

#include "lessons/scene/scene.h"

#include <unordered_set>

namespace halfspace {

struct Construction;

/// Whether objects of a kind usually have names that begin with a letter.
[[nodiscard]] bool isUsualLetter(const Kind &kind, char letter);

/// Names that no entry of a scene has, and no object that a construction makes there, which would no longer
/// be found by its own name alone. None of them means something else in typed lines: x, y, z and t do.
class FreshNames {
public:
  explicit FreshNames(const Scene &scene);

  /// For an object, by the letters that its kind usually has: points A, B, C …, planes E, F, …
  [[nodiscard]] std::string ofKind(const Kind &kind) const;
  /// For the use of a construction, by what that is called: d, d1, d2 … for distances.
  [[nodiscard]] std::string ofUse(const Construction &construction) const;

private:
  [[nodiscard]] bool isFree(const std::string &name) const;
  /// One of the letters that is free, or the first number behind `numbered` with which it is.
  [[nodiscard]] std::string firstFree(std::string_view letters, char numbered) const;

  std::unordered_set<std::string> m_written;   ///< the entries' names, as they are written
  std::unordered_set<std::string_view> m_made; ///< what constructions of the scene call what they make
};

} // namespace halfspace
