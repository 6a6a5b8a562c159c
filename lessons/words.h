// Sentences for users, with a place to plug in translations.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfspace {

/// Gives the translation of an English sentence, or the sentence itself.
using Catalogue = std::function<std::string(const char *english)>;

/// Plugs in the translations; until then all is English.
void setCatalogue(Catalogue catalogue);

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
