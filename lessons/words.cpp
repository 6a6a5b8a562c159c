#include "lessons/words.h"

#include "lessons/language.h"

namespace halfspace {

std::string words(const char *english,
                  std::initializer_list<std::pair<std::string_view, std::string>> values) {
  return words(english, WordValues(), values);
}

std::string words(const char *english, const WordValues &common,
                  std::initializer_list<std::pair<std::string_view, std::string>> values) {
  const std::string sentence = language().catalogue ? language().catalogue(english) : english;
  const auto textFor = [&](std::string_view place) -> const std::string * {
    for (const auto &[name, text] : values)
      if (name == place)
        return &text;
    for (const auto &[name, text] : common)
      if (name == place)
        return &text;
    return nullptr;
  };
  std::string filled;
  // One pass, so that a brace in a value is never taken for a place to fill.
  for (std::size_t at = 0; at < sentence.size();) {
    const auto close = sentence[at] == '{' ? sentence.find('}', at) : std::string::npos;
    const std::string *text = close == std::string::npos
                                  ? nullptr
                                  : textFor(std::string_view(sentence).substr(at + 1, close - at - 1));
    if (text) {
      filled += *text;
      at = close + 1;
    } else {
      filled += sentence[at++];
    }
  }
  return filled;
}

} // namespace halfspace
