// What operations come to.
#pragma once

#include "lessons/term/term.h"

namespace halfspace {

/// The operation's value on the values of its parts; nothing where it has none. Not for leaves.
[[nodiscard]] std::optional<TermValue> operate(TermKind kind, const std::vector<Term> &parts,
                                               std::size_t columns);

} // namespace halfspace
