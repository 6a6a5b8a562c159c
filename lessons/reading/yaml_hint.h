// What is perhaps wrong in a text that cannot be read as YAML, in plain words.
#pragma once

#include <string>
#include <string_view>

namespace halfspace {

/// A guess, and the line of the text that it is about, counted from 1.
struct YamlHint {
  std::string sentence; ///< empty: nothing is guessed
  int line;
};

/// What to do about LaTeX in double quotes.
[[nodiscard]] std::string singleQuotesHint();

/// `reason` is the library's, or ours for what reads as YAML but was hardly meant; `line` is where the
/// reading stopped.
[[nodiscard]] YamlHint yamlHint(std::string_view text, std::string_view reason, int line);

} // namespace halfspace
