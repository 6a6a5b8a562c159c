// A language for the length of a test.
#pragma once

#include "lessons/language.h"

namespace halfspace::test {

/// Users are addressed in this language while it lives, and in English again when it ends.
struct SpokenToIn {
  explicit SpokenToIn(Language language) { setLanguage(std::move(language)); }
  ~SpokenToIn() { setLanguage({}); }
  SpokenToIn(const SpokenToIn &) = delete;
  SpokenToIn &operator=(const SpokenToIn &) = delete;
};

/// English sentences with the numbers of a language that has a decimal comma.
inline Language withDecimalComma() { return {{}, ','}; }

} // namespace halfspace::test
