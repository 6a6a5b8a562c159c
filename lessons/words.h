// Sentences for users, with a place to plug in translations.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace halfspace {

/// Gives the translation of an English sentence, or the sentence itself.
using Catalogue = std::function<std::string(const char *english)>;

/// Plugs in the translations; until then all is English.
void setCatalogue(Catalogue catalogue);

/// The sentence in the user's language with each `{name}` replaced by its text:
/// words("{t} is negative", {{"t", "t = −1"}}).
[[nodiscard]] std::string words(const char *english,
                                std::initializer_list<std::pair<std::string_view, std::string>> values = {});

} // namespace halfspace
