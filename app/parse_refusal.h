// What the library that reads the command line says, in the user's language.
#pragma once

#include <string>

namespace halfspace {

/// The library's English sentence about arguments, translated; one that is not known here stays as it is.
[[nodiscard]] std::string parseRefusal(const std::string &english);

} // namespace halfspace
