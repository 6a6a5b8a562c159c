// What is said of vectors without a direction, alike in all constructions: zero is perpendicular to nothing.
#pragma once

#include "lessons/construction/naming.h"
#include "lessons/construction/outcome.h"

#include <string>
#include <string_view>

namespace halfspace {

/// Cases: a plane without a normal, a ray without a direction, a line {v} without one.
[[nodiscard]] CaseWords zeroNormalWords(const Naming &naming);
[[nodiscard]] CaseWords zeroDirectionWords(const Naming &naming);
[[nodiscard]] CaseWords zeroLineWords(const Naming &naming, std::string_view caseName);

/// Of two lines {g} and {h}, one or both of which have no direction.
[[nodiscard]] CaseWords zeroLinesWords(const Naming &naming, std::string_view caseName, bool isFirstZero,
                                       bool isSecondZero);

/// Why a product is 0 that says nothing of where things lie: {n}, or {r}, is zero.
[[nodiscard]] std::string zeroWithoutPlane(const Naming &naming);
[[nodiscard]] std::string zeroWithoutRay(const Naming &naming);
/// The same of all products with the edges of a face.
[[nodiscard]] std::string allZeroWithoutRay(const Naming &naming);

/// Of the cross product of a triangle's sides u and v.
[[nodiscard]] std::string crossProductWords(const Term &normal);

/// Of u⊥ and v⊥, which are zero where there is no triangle; else what `otherwise` says.
[[nodiscard]] std::string perpWords(const Term &perp, std::string otherwise);

/// Why the product of a ray with an edge is 0 that says nothing of where they lie: one of them has no
/// direction. Empty where both have one.
[[nodiscard]] std::string withoutDirectionWords(const Term &ray, const Term &edge);

} // namespace halfspace
