// Terms as formulas to be laid out.
#pragma once

#include "lessons/term/chain.h"
#include "lessons/term/notation.h"
#include "widgets/picture/math/math_tree.h"

namespace halfspace {

/// A term that is a mark of the figure is tagged with the mark's id.
[[nodiscard]] math::Row formulaOf(const Term &term, Notation notation = {});
[[nodiscard]] math::Row formulaOf(const Chain &chain, Notation notation = {});
/// The sides from `begin` on, each but the chain's first with the relation before it.
[[nodiscard]] math::Row formulaOf(const Chain &chain, std::size_t begin, std::size_t end,
                                  Notation notation = {});

} // namespace halfspace
