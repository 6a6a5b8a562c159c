// The words behind a typed line that say how its entry is drawn.
#pragma once

#include "lessons/scene/scene.h"

namespace halfspace {

/// All of them: colours, styles of lines, what labels say, `hidden`, `locked`.
[[nodiscard]] std::vector<std::string> lookWords();

/// Takes a word over into the look of an entry; false for one that is no such word.
bool setLook(Entry &entry, std::string_view word);

/// An entry that says nothing of its look.
[[nodiscard]] Entry withoutLook(Entry entry);

/// The words of an entry's look, in an order of their own.
[[nodiscard]] std::vector<std::string> lookWordsOf(const Entry &entry);

} // namespace halfspace
