#include "app/parse_refusal.h"

#include "lessons/text.h"
#include "lessons/words.h"

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace halfspace {
namespace {

/// What stands in the places {…} of a pattern where a text is like it, with the places themselves. A text is
/// taken for the next place up to what follows that in the pattern.
std::optional<WordValues> valuesOf(std::string_view text, std::string_view pattern) {
  WordValues values;
  while (true) {
    const auto open = pattern.find('{');
    if (!text.starts_with(pattern.substr(0, open)))
      return {};
    if (open == std::string_view::npos)
      return text.size() == pattern.size() ? std::optional(values) : std::nullopt;
    const auto close = pattern.find('}', open);
    const std::string_view place = pattern.substr(open, close + 1 - open);
    text.remove_prefix(open);
    pattern.remove_prefix(close + 1);
    const std::string_view behind = pattern.substr(0, pattern.find('{'));
    const auto end = behind.empty() ? text.size() : text.find(behind);
    if (end == std::string_view::npos)
      return {};
    values.emplace_back(place, text.substr(0, end));
    text.remove_prefix(end);
  }
}

std::string filled(std::string sentence, const WordValues &values) {
  for (const auto &[place, text] : values)
    sentence = replacedAll(std::move(sentence), place, text);
  return sentence;
}

} // namespace

std::string parseRefusal(const std::string &english) {
  for (const auto &[pattern, sentence] :
       {std::pair("The following argument was not expected: {what}",
                  words("The following argument was not expected: {what}")),
        {"The following arguments were not expected: {what}",
         words("The following arguments were not expected: {what}")},
        {"{name} is required", words("{name} is required")},
        {"{name}: {count} required {what} missing", words("{name}: {count} required {what} missing")},
        {"Could not convert: {name} = {value}", words("Could not convert: {name} = {value}")},
        {"{name}: {value} not in {known}", words("{name}: {value} not in {known}")},
        {"{name} excludes {other}", words("{name} excludes {other}")}})
    if (const auto values = valuesOf(english, pattern))
      return filled(sentence, *values);
  return english;
}

} // namespace halfspace
