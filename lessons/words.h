// Sentences for users, in their language.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfspace {

/// Texts for places in sentences, by the places' names.
using WordValues = std::vector<std::pair<std::string, std::string>>;

/// The sentence in the user's language with each `{name}` replaced by its text:
/// words("{t} is negative", {{"t", "t = −1"}}).
[[nodiscard]] std::string words(const char *english,
                                std::initializer_list<std::pair<std::string_view, std::string>> values = {});

/// The same with places that many sentences have, as {n} for the letter of a normal. A value goes before a
/// common one.
[[nodiscard]] std::string words(const char *english, const WordValues &common,
                                std::initializer_list<std::pair<std::string_view, std::string>> values = {});

} // namespace halfspace
