// Decimals of documents, where a double is exact enough.
#pragma once

#include "lessons/reading/document.h"

#include <string>

namespace halfspace {

/// The number that a node spells, as a coordinate is spelled and within the same limits; else 0, and a
/// problem with the field of this name.
[[nodiscard]] double readDecimal(const DocumentNode &node, const std::string &field, FieldReader &fields);

} // namespace halfspace
