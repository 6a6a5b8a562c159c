// Worked lines from chains of terms.
#pragma once

#include "lessons/term/chain.h"
#include "lessons/usual_mistakes.h"
#include "lessons/working.h"

namespace halfspace {

/// A line of one statement, or of several beside each other: s = 1/4, t = 1/2.
[[nodiscard]] WorkingLine line(std::string id, std::vector<Chain> chains, std::string sentence = {});

/// The line, whose result a learner is to find: the last side of its last chain, a number or a list of them.
/// `mistakes` say more than those that follow from the formula by themselves, and go before them.
[[nodiscard]] WorkingLine asked(WorkingLine line, const std::vector<WrongTerm> &mistakes = {});

/// The line, of which a learner is to find one number: `sought`, a name and how it is found. `form` is the
/// line's last side with that name in it.
[[nodiscard]] WorkingLine askedFor(const Chain &sought, const Term &form, WorkingLine line,
                                   const std::vector<WrongTerm> &mistakes = {});

/// The mistake of a parameter, (P₀ − Q)·n over r·n, with the wrong sign.
[[nodiscard]] WrongTerm wrongSignOf(const Term &parameter);

} // namespace halfspace
