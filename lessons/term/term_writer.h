// What all notations have in common: which parts stand in parentheses, where a sign is part of a sum, what
// stands between factors.
#pragma once

#include "lessons/term/chain.h"
#include "lessons/term/written.h"

#include <algorithm>

#include <utility>
#include <vector>

namespace halfspace {

/// Signs and gaps between the parts of a term.
/// `Dot` is that of vectors, `Times` that of numbers. Other products have no sign: their factors stand with a
/// gap between them, or joined.
enum class TermSign : std::uint8_t { Plus, Minus, Negative, Dot, Times, Cross, Permuted, Gap, Joint };

/// Walks through a term; a notation says what its pieces look like. `Text` is what it makes of them: a
/// string, or a node of another tree.
template <class Text> class TermWriter {
public:
  virtual ~TermWriter() = default;

  [[nodiscard]] Text write(const Term &term) {
    return isLeftOut(term) ? blank() : touchable(term, unmarked(term));
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
        texts.push_back(relation(relations[i - 1]));
      texts.push_back(write(chain.sides()[i]));
    }
    return row(std::move(texts));
  }

protected:
  TermWriter() = default;
  TermWriter(const TermWriter &) = default;
  TermWriter &operator=(const TermWriter &) = default;

  struct FractionLook {
    bool small = false;    ///< in a row of numbers, where a tall one would tear the line apart
    bool compound = false; ///< more than a number or a name above or below
    bool nested = false;   ///< itself above or below a bar
    bool flat = false;     ///< of digits and alone there: with a slash, as bars above bars are hard to read
  };

  [[nodiscard]] virtual Text row(std::vector<Text> parts) = 0;
  [[nodiscard]] virtual Text digits(const std::string &decimal) = 0;
  [[nodiscard]] virtual Text symbol(const Symbol &symbol) = 0;
  [[nodiscard]] virtual Text sign(TermSign sign) = 0;
  [[nodiscard]] virtual Text relation(Relation relation) = 0;
  /// `term` is what stands inside.
  [[nodiscard]] virtual Text parenthesized(Text inside, const Term &term) = 0;
  [[nodiscard]] virtual Text fraction(Text top, Text bottom, FractionLook look) = 0;
  [[nodiscard]] virtual Text root(Text square) = 0;
  [[nodiscard]] virtual Text norm(Text vector) = 0;
  /// `term` is what stands between the bars.
  [[nodiscard]] virtual Text normOf(Text inside, const Term & /*term*/) { return norm(std::move(inside)); }
  [[nodiscard]] virtual Text power(Text base, Text exponent) = 0;
  [[nodiscard]] virtual Text list(std::vector<Text> entries) = 0;
  /// The same of entries that are no taller than letters.
  [[nodiscard]] virtual Text flatList(std::vector<Text> entries) { return list(std::move(entries)); }
  /// The same of whole numbers and fractions of such.
  [[nodiscard]] virtual Text numberList(std::vector<Text> entries) { return list(std::move(entries)); }
  [[nodiscard]] virtual Text matrix(std::vector<Text> entries, std::size_t columns, bool isDeterminant) = 0;
  /// A term that is raised to a power, where it needs parentheses.
  [[nodiscard]] virtual Text parenthesizedBase(Text inside, const Term &term) {
    return parenthesized(std::move(inside), term);
  }
  /// f(Q), or cos θ for a word before a name.
  [[nodiscard]] virtual Text applied(Text function, Text argument, bool inParentheses) = 0;
  /// A term that has a mark or is a number that can be traced. Notations without a hand pass it through.
  [[nodiscard]] virtual Text touchable(const Term &, Text text) { return text; }
  /// Whether a fraction is written in the line, with a slash, so that it needs parentheses as a product does.
  [[nodiscard]] virtual bool isFlat() const = 0;
  /// Whether no line tells where a root ends, so that it needs parentheses likewise.
  [[nodiscard]] virtual bool hasBareRoots() const { return isFlat(); }

  /// What stands for a term that is left out.
  [[nodiscard]] virtual Text blank() { return symbol(letter("?")); }

  /// A number as the term of digits that is written for it.
  [[nodiscard]] static const Term &shown(const Term &term) {
    return term->kind == TermKind::Number ? term->parts[0] : term;
  }

  /// Whether it is more than a number or a name, with or without a minus.
  [[nodiscard]] static bool isCompound(const Term &term) {
    const Term &looked = shown(term);
    if (looked->kind == TermKind::Negation)
      return isCompound(looked->parts[0]);
    return looked->kind != TermKind::Digits && looked->kind != TermKind::Name &&
           looked->kind != TermKind::Unknown;
  }

  /// Whether parentheses around it should stretch.
  [[nodiscard]] static bool isTall(const Term &term) {
    const Term &looked = shown(term);
    switch (looked->kind) {
    case TermKind::Quotient:
    case TermKind::List:
    case TermKind::Root:
    case TermKind::Matrix:
    case TermKind::Determinant:
      return true;
    default:
      return std::any_of(looked->parts.begin(), looked->parts.end(), isTall);
    }
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
      return !isFlat()                               ? Binding::Atom
             : isNegativeAtom(shown(term)->parts[0]) ? Binding::Negation
                                                     : Binding::Fraction;
    case TermKind::Root:
      return hasBareRoots() ? Binding::Fraction : Binding::Atom;
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

  /// cos θ, where all that follows would seem to belong to the angle.
  [[nodiscard]] static bool isWordBeforeName(const Term &term) {
    return term->symbol.isWord && term->parts[0]->kind == TermKind::Name;
  }

  /// A number, or calculated from numbers alone without a vector.
  [[nodiscard]] static bool isNumeric(const Term &term) {
    switch (term->kind) {
    case TermKind::Number:
      return true;
    case TermKind::Power:
    case TermKind::Quotient:
      return std::all_of(term->parts.begin(), term->parts.end(), isNumeric);
    default:
      return false;
    }
  }

  [[nodiscard]] bool isLeftOut(const Term &term) const { return &*term == m_leftOut; }

  [[nodiscard]] Text held(const Term &term, Binding least) {
    Text text = write(term);
    return bindingOf(term) < least ? parenthesized(std::move(text), term) : std::move(text);
  }

  [[nodiscard]] Text unmarked(const Term &term) {
    const Term &looked = shown(term);
    const auto &parts = looked->parts;
    switch (looked->kind) {
    case TermKind::Digits:
      return digits(looked->digits);
    case TermKind::Number: // shown as its digits
      break;
    case TermKind::Name:
    case TermKind::Unknown:
      return symbol(looked->symbol);
    case TermKind::Applied:
      return applied(symbol(looked->symbol), write(parts[0]), !isWordBeforeName(looked));
    case TermKind::Negation:
      return row({sign(TermSign::Negative), held(parts[0], Binding::VectorProduct)});
    case TermKind::Sum:
      return sum(parts);
    case TermKind::Product:
      return product(parts);
    case TermKind::Dot:
      return row({held(parts[0], Binding::Product), sign(TermSign::Dot), held(parts[1], Binding::Fraction)});
    case TermKind::Cross:
      return row(
          {held(parts[0], Binding::Product), sign(TermSign::Cross), held(parts[1], Binding::Fraction)});
    case TermKind::Permuted:
      return row({list({write(parts[0]), write(parts[1])}), sign(TermSign::Permuted),
                  list({write(parts[2]), write(parts[3])})});
    case TermKind::Quotient:
      return quotient(looked);
    case TermKind::Power:
      return power(base(parts[0]), write(parts[1]));
    case TermKind::Root:
      return root(held(parts[0], hasBareRoots() ? Binding::Atom : Binding::Sum));
    case TermKind::Norm:
      return normOf(write(parts[0]), parts[0]);
    case TermKind::List:
      return listOf(parts);
    case TermKind::Matrix:
    case TermKind::Determinant:
      return matrix(small(parts), looked->columns, looked->kind == TermKind::Determinant);
    }
    return row({});
  }

  [[nodiscard]] Text listOf(const std::vector<Term> &entries) {
    if (std::none_of(entries.begin(), entries.end(), isTall))
      return flatList(small(entries));
    return std::all_of(entries.begin(), entries.end(), isAsHighAsNumbers) ? numberList(small(entries))
                                                                          : list(small(entries));
  }

  /// Whether nothing in it is higher than a fraction of digits: (−7/9)·(−2) − 28/9.
  [[nodiscard]] static bool isAsHighAsNumbers(const Term &term) {
    const Term &looked = shown(term);
    if (!isTall(looked) || isWrittenInDigits(looked))
      return true;
    switch (looked->kind) {
    case TermKind::Negation:
    case TermKind::Sum:
    case TermKind::Product:
    case TermKind::Dot:
    case TermKind::Cross:
      return std::all_of(looked->parts.begin(), looked->parts.end(), isAsHighAsNumbers);
    default:
      return false;
    }
  }

  /// 3, −10/3.
  [[nodiscard]] static bool isWrittenInDigits(const Term &term) {
    const Term &bare = shown(term)->kind == TermKind::Negation ? shown(term)->parts[0] : term;
    const auto isDigits = [](const Term &each) { return shown(each)->kind == TermKind::Digits; };
    return isDigits(bare) || (shown(bare)->kind == TermKind::Quotient &&
                              std::all_of(shown(bare)->parts.begin(), shown(bare)->parts.end(), isDigits));
  }

  [[nodiscard]] Text sum(const std::vector<Term> &summands) {
    // Beside small coefficients a tall constant would look more important than they.
    const bool smallBefore = std::exchange(m_small, m_small || hasUnknown(summands));
    std::vector<Text> texts{held(summands.front(), Binding::Negation)};
    for (auto summand = summands.begin() + 1; summand != summands.end(); ++summand) {
      const Term &looked = shown(*summand);
      const bool negative = looked->kind == TermKind::Negation && !isLeftOut(*summand);
      texts.push_back(sign(negative ? TermSign::Minus : TermSign::Plus));
      // The sign of a negative number is the sum's, but the number is still one to be touched.
      texts.push_back(negative ? touchable(*summand, held(looked->parts[0], Binding::VectorProduct))
                               : held(*summand, Binding::VectorProduct));
    }
    m_small = smallBefore;
    return row(std::move(texts));
  }

  /// Whether an unknown stands among the summands, alone or with a coefficient.
  [[nodiscard]] static bool hasUnknown(const std::vector<Term> &summands) {
    return std::any_of(summands.begin(), summands.end(), [](const Term &summand) {
      const Term &looked = shown(summand);
      const Term &bare = looked->kind == TermKind::Negation ? shown(looked->parts[0]) : looked;
      const Term &last = bare->kind == TermKind::Product ? bare->parts.back() : bare;
      return last->kind == TermKind::Unknown;
    });
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
        texts.push_back(sign(TermSign::Times));
      else if (!isLast && !(isNumeral(factor) && isCoefficient))
        texts.push_back(sign(standApart(factor, factors[i + 1]) ? TermSign::Gap : TermSign::Joint));
    }
    return row(std::move(texts));
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
    return hasBareRoots() && term->kind == TermKind::Product && term->parts.back()->kind == TermKind::Root;
  }

  [[nodiscard]] static bool standDotted(const Term &left, const Term &right) {
    const bool powerOfTen = left->kind == TermKind::Digits && right->kind == TermKind::Power;
    return powerOfTen || (isNumeric(left) && isNumeric(right));
  }

  /// t r and (1/2) v, but 2n, 3x, 4(x − 1).
  [[nodiscard]] bool standApart(const Term &left, const Term &right) const {
    if (right->kind == TermKind::List || bindingOf(right) < Binding::Product)
      return false; // it opens with a parenthesis
    return !isNumeral(left) || (right->kind == TermKind::Name && !isInteger(left));
  }

  [[nodiscard]] static bool isInteger(const Term &number) {
    const Term &looked = shown(number);
    return looked->kind == TermKind::Digits && looked->digits.find('.') == std::string::npos;
  }

  /// A factor that is rounded to 1 says nothing before an unknown.
  [[nodiscard]] static bool isRoundedOne(const Term &factor) {
    const Term &looked = shown(factor);
    return looked->kind == TermKind::Digits && looked->digits == "1" && factor->isRounded;
  }

  [[nodiscard]] static bool isNumeral(const Term &term) {
    return term->kind == TermKind::Number || term->kind == TermKind::Digits;
  }

  [[nodiscard]] Text quotient(const Term &term) {
    const Term &top = term->parts[0];
    const Term &bottom = term->parts[1];
    const bool isFlatHere = std::exchange(m_flat, false);
    const FractionLook look{m_small, isCompound(top) || isCompound(bottom), m_inFraction, isFlatHere};
    const bool smallBefore = std::exchange(m_small, true);
    const bool inFractionBefore = std::exchange(m_inFraction, true);
    const Binding leastAbove = !isFlat()             ? Binding::Sum
                               : isNegativeAtom(top) ? Binding::Negation
                               : isOfRoots(top)      ? Binding::Product
                                                     : Binding::Power;
    Text topText = besideBar(top, leastAbove);
    Text bottomText = besideBar(bottom, isFlat() ? Binding::Power : Binding::Sum);
    m_small = smallBefore;
    m_inFraction = inFractionBefore;
    return fraction(std::move(topText), std::move(bottomText), look);
  }

  /// √5 or 4√5, which need no parentheses before a slash.
  [[nodiscard]] static bool isOfRoots(const Term &term) {
    const Term &looked = shown(term);
    const auto isDigitsOrRoot = [](const Term &each) {
      return shown(each)->kind == TermKind::Digits || shown(each)->kind == TermKind::Root;
    };
    return looked->kind == TermKind::Root ||
           (looked->kind == TermKind::Product &&
            std::all_of(looked->parts.begin(), looked->parts.end(), isDigitsOrRoot));
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
                 : parenthesizedBase(write(term), term);
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

  bool m_small = false;
  const TermNode *m_leftOut = nullptr;
  bool m_inFraction = false;
  bool m_flat = false; ///< the fraction that comes next
};

} // namespace halfspace
