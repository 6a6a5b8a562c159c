// The questions that can be asked, by name.
#pragma once

#include "eval/answer.h"
#include "eval/operands.h"

namespace halfspace {

/// Reads a question's operands and, if there is no fault in them, writes the fields of its result.
using Query = void (*)(Operands &operands, Answer &answer);

/// Nothing for a name that is no query's.
[[nodiscard]] Query findQuery(std::string_view name);

} // namespace halfspace
