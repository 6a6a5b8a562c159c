// What all notations have in common: which parts stand in parentheses, where a sign is part of a sum, what
// stands between factors.
#pragma once

#include "lessons/term/notation.h"
#include "lessons/term/term_shape.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace halfspace {

/// Walks through a term and puts together what a notation makes of its pieces.
template <class Text> class TermWriter {
public:
  /// The notation must outlive it.
  explicit TermWriter(const Notation<Text> &notation) : m_notation(notation) {}

  [[nodiscard]] Text write(const Term &term) {
    return isLeftOut(term) ? m_notation.blank() : m_notation.touchable(term, unmarked(term));
  }

  /// From now on a blank stands for this very term wherever it is a part of what is written.
  void leaveOut(const Term &term) { m_leftOut = &*term; }

  /// The sides with the relations between them.
  [[nodiscard]] Text write(const Chain &chain) { return write(chain, 0, chain.sides().size()); }

  /// The sides from `begin` on, each but the chain's first with the relation before it.
  [[nodiscard]] Text write(const Chain &chain, std::size_t begin, std::size_t end) {
    const std::vector<Relation> relations = chain.relations();
    std::vector<Text> texts;
    for (std::size_t i = begin; i < end; ++i) {
      if (i > 0)
        texts.push_back(m_notation.relation(relations[i - 1]));
      texts.push_back(write(chain.sides()[i]));
    }
    return m_notation.row(std::move(texts));
  }

private:
  /// How tightly a term holds together: what holds less than its place asks for stands in parentheses.
  enum class Binding : std::uint8_t { Sum, Negation, VectorProduct, Product, Fraction, Power, Atom };

  [[nodiscard]] Binding bindingOf(const Term &term) const {
    if (isLeftOut(term))
      return Binding::Atom;
    switch (shown(term)->kind) {
    case TermKind::Sum:
      return Binding::Sum;
    case TermKind::Negation:
      return Binding::Negation;
    case TermKind::Dot:
    case TermKind::Cross:
    case TermKind::Permuted:
      return Binding::VectorProduct;
    case TermKind::Product:
      return Binding::Product;
    case TermKind::Quotient:
      return !m_notation.isFlat()                    ? Binding::Atom
             : isNegativeAtom(shown(term)->parts[0]) ? Binding::Negation
                                                     : Binding::Fraction;
    case TermKind::Root:
      return m_notation.hasBareRoots() ? Binding::Fraction : Binding::Atom;
    case TermKind::Applied:
      return isWordBeforeName(term) ? Binding::Fraction : Binding::Atom;
    case TermKind::Power:
      return Binding::Power;
    default:
      return Binding::Atom;
    }
  }

  /// −3 or −x, which may stand above a slash as it is.
  [[nodiscard]] bool isNegativeAtom(const Term &term) const {
    const Term &looked = shown(term);
    return looked->kind == TermKind::Negation && bindingOf(looked->parts[0]) >= Binding::Power;
  }

  [[nodiscard]] bool isLeftOut(const Term &term) const { return &*term == m_leftOut; }

  [[nodiscard]] Text held(const Term &term, Binding least) {
    Text text = write(term);
    return bindingOf(term) < least ? m_notation.parenthesized(std::move(text), term) : std::move(text);
  }

  [[nodiscard]] Text unmarked(const Term &term) {
    const Term &looked = shown(term);
    const auto &parts = looked->parts;
    switch (looked->kind) {
    case TermKind::Digits:
      return m_notation.digits(looked->digits);
    case TermKind::Number: // shown as its digits
      break;
    case TermKind::Name:
    case TermKind::Unknown:
      return m_notation.symbol(looked->symbol);
    case TermKind::Applied:
      return m_notation.applied(m_notation.symbol(looked->symbol), write(parts[0]),
                                !isWordBeforeName(looked) && !isOfList(looked));
    case TermKind::Negation:
      return m_notation.row({m_notation.sign(TermSign::Negative), held(parts[0], Binding::VectorProduct)});
    case TermKind::Sum:
      return sum(parts);
    case TermKind::Product:
      return product(parts);
    case TermKind::Dot:
      return m_notation.row({held(parts[0], Binding::Product), m_notation.sign(TermSign::Dot),
                             held(parts[1], Binding::Fraction)});
    case TermKind::Cross:
      return m_notation.row({held(parts[0], Binding::Product), m_notation.sign(TermSign::Cross),
                             held(parts[1], Binding::Fraction)});
    case TermKind::Permuted:
      return m_notation.row({m_notation.list({write(parts[0]), write(parts[1])}),
                             m_notation.sign(TermSign::Permuted),
                             m_notation.list({write(parts[2]), write(parts[3])})});
    case TermKind::Quotient:
      return quotient(looked);
    case TermKind::Power:
      return m_notation.power(base(parts[0]), write(parts[1]));
    case TermKind::Root:
      return m_notation.root(held(parts[0], m_notation.hasBareRoots() ? Binding::Atom : Binding::Sum));
    case TermKind::Norm:
      return m_notation.normOf(write(parts[0]), parts[0]);
    case TermKind::List:
      return listOf(parts);
    case TermKind::Matrix:
    case TermKind::Determinant:
      return m_notation.matrix(small(parts), looked->columns, looked->kind == TermKind::Determinant);
    }
    return m_notation.row({});
  }

  [[nodiscard]] Text listOf(const std::vector<Term> &entries) {
    if (std::none_of(entries.begin(), entries.end(), isTall))
      return m_notation.flatList(small(entries));
    return std::all_of(entries.begin(), entries.end(), isAsHighAsNumbers)
               ? m_notation.numberList(small(entries))
               : m_notation.list(small(entries));
  }

  [[nodiscard]] Text sum(const std::vector<Term> &summands) {
    // Beside small coefficients a tall constant would look more important than they.
    const bool smallBefore = std::exchange(m_small, m_small || hasUnknown(summands));
    std::vector<Text> texts{held(summands.front(), Binding::Negation)};
    for (auto summand = summands.begin() + 1; summand != summands.end(); ++summand) {
      const Term &looked = shown(*summand);
      const bool negative = looked->kind == TermKind::Negation && !isLeftOut(*summand);
      texts.push_back(m_notation.sign(negative ? TermSign::Minus : TermSign::Plus));
      // The sign of a negative number is the sum's, but the number is still one to be touched.
      texts.push_back(negative
                          ? m_notation.touchable(*summand, held(looked->parts[0], Binding::VectorProduct))
                          : held(*summand, Binding::VectorProduct));
    }
    m_small = smallBefore;
    return m_notation.row(std::move(texts));
  }

  [[nodiscard]] Text product(const std::vector<Term> &factors) {
    std::vector<Text> texts;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const Term &factor = factors[i];
      const bool isLast = i + 1 == factors.size();
      const bool dotted = !isLast && standDotted(factor, factors[i + 1]);
      const bool isCoefficient = !isLast && factors[i + 1]->kind == TermKind::Unknown;
      if (isCoefficient && isRoundedOne(factor))
        continue;
      const bool smallBefore = std::exchange(m_small, m_small || isCoefficient);
      texts.push_back(held(factor, leastInProduct(factors, i, isLast || dotted)));
      m_small = smallBefore;
      if (dotted)
        texts.push_back(m_notation.sign(TermSign::Times));
      else if (!isLast && !(isNumeral(factor) && isCoefficient))
        texts.push_back(
            m_notation.sign(standApart(factor, factors[i + 1]) ? TermSign::Gap : TermSign::Joint));
    }
    return m_notation.row(std::move(texts));
  }

  /// (1/3)x, because 1/3x would be read as 1/(3x); 2(3t), because 23t is another number.
  [[nodiscard]] Binding leastInProduct(const std::vector<Term> &factors, std::size_t index,
                                       bool endsThere) const {
    const bool isFraction =
        bindingOf(factors[index]) == Binding::Fraction || endsInRoot(shown(factors[index]));
    const bool digitsMeet =
        index > 0 && isNumeral(factors[index - 1]) && factors[index]->kind == TermKind::Product;
    return (isFraction && !endsThere) || digitsMeet ? Binding::Power : Binding::Product;
  }

  [[nodiscard]] bool endsInRoot(const Term &term) const {
    return m_notation.hasBareRoots() && term->kind == TermKind::Product &&
           term->parts.back()->kind == TermKind::Root;
  }

  /// t r and (1/2) v, but 2n, 3x, 4(x − 1).
  [[nodiscard]] bool standApart(const Term &left, const Term &right) const {
    if (right->kind == TermKind::List || bindingOf(right) < Binding::Product)
      return false; // it opens with a parenthesis
    return !isNumeral(left) || (right->kind == TermKind::Name && !isInteger(left));
  }

  [[nodiscard]] Text quotient(const Term &term) {
    const Term &top = term->parts[0];
    const Term &bottom = term->parts[1];
    const bool isFlatHere = std::exchange(m_flat, false);
    const typename Notation<Text>::FractionLook look{m_small, isCompound(top) || isCompound(bottom),
                                                     m_inFraction, isFlatHere};
    const bool smallBefore = std::exchange(m_small, true);
    const bool inFractionBefore = std::exchange(m_inFraction, true);
    const Binding leastAbove = !m_notation.isFlat()  ? Binding::Sum
                               : isNegativeAtom(top) ? Binding::Negation
                               : isOfRoots(top)      ? Binding::Product
                                                     : Binding::Power;
    Text topText = besideBar(top, leastAbove);
    Text bottomText = besideBar(bottom, m_notation.isFlat() ? Binding::Power : Binding::Sum);
    m_small = smallBefore;
    m_inFraction = inFractionBefore;
    return m_notation.fraction(std::move(topText), std::move(bottomText), look);
  }

  [[nodiscard]] Text besideBar(const Term &term, Binding least) {
    m_flat = isWrittenInDigits(term);
    Text text = held(term, least);
    m_flat = false;
    return text;
  }

  /// In parentheses wherever the exponent would stick to a part of it only.
  [[nodiscard]] Text base(const Term &term) {
    switch (shown(term)->kind) {
    case TermKind::Digits:
    case TermKind::Name:
    case TermKind::Unknown:
    case TermKind::List:
    case TermKind::Norm:
      return write(term);
    default:
      return bindingOf(term) == Binding::Atom && term->kind == TermKind::Applied
                 ? write(term)
                 : m_notation.parenthesizedBase(write(term), term);
    }
  }

  [[nodiscard]] std::vector<Text> small(const std::vector<Term> &entries) {
    const bool smallBefore = std::exchange(m_small, true);
    std::vector<Text> texts;
    texts.reserve(entries.size());
    for (const Term &entry : entries)
      texts.push_back(write(entry));
    m_small = smallBefore;
    return texts;
  }

  const Notation<Text> &m_notation;
  bool m_small = false; ///< where tall pieces would tear the line apart
  const TermNode *m_leftOut = nullptr;
  bool m_inFraction = false;
  bool m_flat = false; ///< the fraction that comes next
};

} // namespace halfspace
