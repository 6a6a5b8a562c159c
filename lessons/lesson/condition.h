// Conditions as lessons write them, and values by name.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// Reads `side = negative and t < 0`. Relations: = != < <= > >=. A problem has only its sentence.
[[nodiscard]] Result<std::vector<Condition>> parseConditions(std::string_view text);

/// The value that goes by a name: `t`, `perp.uu` inside a group, `foot.z` of a vector, or `case`. Nothing for
/// a value that the case does not have.
[[nodiscard]] std::optional<Value> findValue(const Outcome &outcome, std::string_view name);

/// Whether the text is shaped like a value's name: letters, digits, `_`, `-`, parts joined by dots.
[[nodiscard]] bool isValueName(std::string_view text);

} // namespace halfspace
