// What is said of tokens that cannot stand where they stand.
#pragma once

#include "widgets/formula/token_stream.h"

#include <string_view>

namespace halfspace::math {

/// Throws ReadError: the token cannot stand here.
[[noreturn]] void failStray(const Token &token);

/// Throws ReadError: what is next cannot end what began at `column` with `opener`, and lacks `closer`.
[[noreturn]] void failUnclosed(TokenStream &tokens, std::size_t column, std::string_view opener,
                               std::string_view closer);

} // namespace halfspace::math
