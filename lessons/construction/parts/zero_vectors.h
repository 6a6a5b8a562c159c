// What is said of vectors without a direction, alike in all constructions: zero is perpendicular to nothing.
#pragma once

#include "lessons/construction/naming.h"

#include <string>

namespace halfspace {

/// Of the cross product of a triangle's sides u and v.
[[nodiscard]] std::string crossProductWords(const Term &normal);

/// Of u⊥ and v⊥, which are zero where there is no triangle; else what `otherwise` says.
[[nodiscard]] std::string perpWords(const Term &perp, std::string otherwise);

/// Why the product of a ray with an edge is 0 that says nothing of where they lie: one of them has no
/// direction. Empty where both have one.
[[nodiscard]] std::string withoutDirectionWords(const Term &ray, const Term &edge);

} // namespace halfspace
