// Conditions as lessons write them, and values by name.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// Reads `side = negative and t < 0`. Relations: = != < <= > >=. A problem has only its sentence.
[[nodiscard]] Result<Conditions> parseConditions(std::string_view text);

/// As they are read: `side = negative and t < 0`.
[[nodiscard]] std::string toText(const Conditions &conditions);

/// The value that goes by a name: `distance.f` of the entry `distance`, or `f` where only one construction
/// has an f among its values; `perp.uu` inside a group, `foot.z` of a vector. `case` is the last
/// construction's, and `distance.case` that of an entry. Nothing for a value that the case does not have. A
/// number of a list and a case have no name that a learner reads.
[[nodiscard]] std::optional<NamedValue> findNamedValue(const Evaluation &evaluation, std::string_view name);
[[nodiscard]] std::optional<Value> findValue(const Evaluation &evaluation, std::string_view name);

/// x, y, z or a digit, as the place in a list; nothing for other names.
[[nodiscard]] std::optional<std::size_t> componentIndex(std::string_view name);

} // namespace halfspace
