// The language that users are addressed in: set once, before anything is written for them. Sentences and
// numbers follow it wherever they are written.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace halfspace {

/// Gives the translation of an English sentence, or the sentence itself.
using Catalogue = std::function<std::string(const char *english)>;

struct Language {
  Catalogue catalogue{};  ///< none: English
  char decimalMark = '.'; ///< or a comma; lists are then parted by semicolons
};

void setLanguage(Language language);

/// English until another is set.
[[nodiscard]] const Language &language();

/// The digits of a decimal, whose point becomes the language's mark: 3.14 or 3,14.
[[nodiscard]] std::string withDecimalMark(std::string decimal);

/// What parts the entries of a list: a comma, or a semicolon where the comma is a decimal mark.
[[nodiscard]] char listSeparator();

} // namespace halfspace
