// What the pieces of a term look like in a notation.
#pragma once

#include "lessons/term/chain.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace halfspace {

/// Signs and gaps between the parts of a term.
/// `Dot` is that of vectors, `Times` that of numbers. Other products have no sign: their factors stand with a
/// gap between them, or joined.
enum class TermSign : std::uint8_t { Plus, Minus, Negative, Dot, Times, Cross, Permuted, Gap, Joint };

/// Makes a `Text` of each piece: a string, or a node of another tree. `TermWriter` asks for them, and knows
/// which parts stand in parentheses.
template <class Text> class Notation {
public:
  virtual ~Notation() = default;

  /// How a fraction stands where it stands.
  struct FractionLook {
    bool small = false;    ///< in a row of numbers, where a tall one would tear the line apart
    bool compound = false; ///< more than a number or a name above or below
    bool nested = false;   ///< itself above or below a bar
    bool flat = false;     ///< of digits and alone there: with a slash, as bars above bars are hard to read
  };

  [[nodiscard]] virtual Text row(std::vector<Text> parts) const = 0;
  [[nodiscard]] virtual Text digits(const std::string &decimal) const = 0;
  [[nodiscard]] virtual Text symbol(const Symbol &symbol) const = 0;
  [[nodiscard]] virtual Text sign(TermSign sign) const = 0;
  [[nodiscard]] virtual Text relation(Relation relation) const = 0;
  /// `term` is what stands inside.
  [[nodiscard]] virtual Text parenthesized(Text inside, const Term &term) const = 0;
  [[nodiscard]] virtual Text fraction(Text top, Text bottom, FractionLook look) const = 0;
  [[nodiscard]] virtual Text root(Text square) const = 0;
  [[nodiscard]] virtual Text norm(Text vector) const = 0;
  /// `term` is what stands between the bars.
  [[nodiscard]] virtual Text normOf(Text inside, const Term & /*term*/) const {
    return norm(std::move(inside));
  }
  [[nodiscard]] virtual Text power(Text base, Text exponent) const = 0;
  [[nodiscard]] virtual Text list(std::vector<Text> entries) const = 0;
  /// The same of entries that are no taller than letters.
  [[nodiscard]] virtual Text flatList(std::vector<Text> entries) const { return list(std::move(entries)); }
  /// The same of whole numbers and fractions of such.
  [[nodiscard]] virtual Text numberList(std::vector<Text> entries) const { return list(std::move(entries)); }
  [[nodiscard]] virtual Text matrix(std::vector<Text> entries, std::size_t columns,
                                    bool isDeterminant) const = 0;
  /// A term that is raised to a power, where it needs parentheses.
  [[nodiscard]] virtual Text parenthesizedBase(Text inside, const Term &term) const {
    return parenthesized(std::move(inside), term);
  }
  /// f(Q), or cos θ for a word before a name.
  [[nodiscard]] virtual Text applied(Text function, Text argument, bool inParentheses) const = 0;
  /// A term that has a mark or is a number that can be traced. Notations without a hand pass it through.
  [[nodiscard]] virtual Text touchable(const Term &, Text text) const { return text; }
  /// Whether a fraction is written in the line, with a slash, so that it needs parentheses as a product does.
  [[nodiscard]] virtual bool isFlat() const = 0;
  /// Whether no line tells where a root ends, so that it needs parentheses likewise.
  [[nodiscard]] virtual bool hasBareRoots() const { return isFlat(); }

  /// What stands for a term that is left out.
  [[nodiscard]] virtual Text blank() const { return symbol(letter("?")); }

protected:
  Notation() = default;
  Notation(const Notation &) = default;
  Notation &operator=(const Notation &) = default;
};

} // namespace halfspace
