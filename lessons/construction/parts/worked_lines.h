// Worked lines from chains of terms. Their ids are given by whoever adds them to an explanation.
#pragma once

#include "lessons/construction/naming.h"
#include "lessons/construction/working.h"
#include "lessons/term/chain.h"

namespace halfspace {

/// A line that is shown and not asked for.
[[nodiscard]] WorkingLine line(const Chain &chain, std::string sentence = {});
/// Statements beside each other: s = 1/4, t = 1/2.
[[nodiscard]] WorkingLine line(std::vector<Chain> chains, std::string sentence = {});

/// Terms beside each other, each with its result.
[[nodiscard]] WorkingLine resultsLine(const std::vector<Term> &terms, std::string sentence);

/// A line whose result a learner is to find: the last side, a number or a list of them, or an expression in
/// unknowns. `mistakes` say more than those that follow from the formula by themselves, and go before them.
[[nodiscard]] WorkingLine asked(const Chain &chain, std::string sentence = {},
                                std::vector<WrongTerm> mistakes = {});

/// A line `0 = …`, whose equation a learner is to find: any multiple of it will do.
[[nodiscard]] WorkingLine askedEquation(const Chain &chain, std::string sentence = {},
                                        std::vector<WrongTerm> mistakes = {});

/// The mistake of a parameter, (P₀ − Q)·n over r·n, with the wrong sign.
[[nodiscard]] WrongTerm wrongSignOf(const Term &parameter, const Naming &naming);

} // namespace halfspace
