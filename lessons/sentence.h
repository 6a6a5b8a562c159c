// Sentences and names that stand in tables: in English, until somebody reads them.
#pragma once

namespace halfspace {

struct Sentence {
  const char *english;
};
/// Hands it to the translators; whoever reads it puts it through `words`.
[[nodiscard]] constexpr Sentence says(const char *english) { return {english}; }

} // namespace halfspace
