// Formulas as values: a term is a tree of numbers, names and operations, and comes to a number or a vector.
#pragma once

#include "lessons/term/term_value.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfspace {

/// How a name is spelled, whatever the notation.
struct Symbol {
  std::string letter{};    ///< one letter, in UTF-8: P, λ, v′ with its prime; or a word, as `dist`
  std::string subscript{}; ///< digits or letters; empty for none
  /// The name of the object that it belongs to, where several objects have the same letter: n of E and n of
  /// F. It stands in the subscript, behind what is there already.
  std::string owner{};
  bool isVector = false; ///< with an arrow above
  bool isPerp = false;   ///< with a ⊥ behind
  bool isWord = false;   ///< more than a letter: set upright, as `cos`
  bool operator==(const Symbol &) const = default;
};

[[nodiscard]] Symbol letter(std::string letter, std::string subscript = {});
[[nodiscard]] Symbol vectorLetter(std::string letter, std::string subscript = {});
/// u⊥
[[nodiscard]] Symbol perpLetter(std::string letter);
[[nodiscard]] Symbol word(std::string word);
/// The Greek letter that a name spells out, as files write it: λ for lambda; other names are themselves.
[[nodiscard]] std::string_view spelledLetter(std::string_view name);
/// `P12` for P_12, which is written in the same way; other names are themselves.
[[nodiscard]] std::string writtenName(std::string_view name);
/// A name as it is spelled: `P12` and `P_12` are P with the index 12; a word, or another name with - or _,
/// stands upright.
[[nodiscard]] Symbol symbolOf(std::string_view name);

/// The coordinate of the scene that a number or a vector is.
struct CoordinateSource {
  std::string object;           ///< its name in the scene
  std::size_t coordinate;       ///< its place among the object's coordinates
  std::optional<int> component; ///< 0, 1, 2; nothing for the whole point or vector
  bool operator==(const CoordinateSource &) const = default;
};

enum class TermKind : std::uint8_t {
  Digits,  ///< an unsigned number as it is written: only in what `written` makes of a number
  Number,  ///< an exact value
  Name,    ///< a symbol that stands for a value
  Unknown, ///< a symbol that stands for any number: the t of an equation
  Applied, ///< f(Q), cos θ: a symbol with the term that it is taken of
  Negation,
  Sum,     ///< of two and more; a difference is a sum with a negation
  Product, ///< of two and more numbers, one of which may be a vector
  Dot,
  Cross,
  Quotient,    ///< of a number or a vector by a number
  Power,       ///< with a whole exponent, its second part
  Root,        ///< the square root
  Norm,        ///< of a vector, or the magnitude of a number
  List,        ///< coordinates of a point or a vector, and other rows of numbers
  Matrix,      ///< `columns` numbers a row
  Determinant, ///< of as many rows as columns, or of one row of vectors: its columns
  Permuted, ///< of two lines by direction and moment: d₁·m₂ + d₂·m₁, its four parts in the order d₁ m₁ d₂ m₂
};

struct TermNode;

/// A term; cheap to copy, never changed. The operators build terms as the notes write them.
class Term {
public:
  /// Numbers that stand in a formula: the 2 of 2n.
  Term(int number);             // NOLINT(google-explicit-constructor): every number is a term
  Term(const Rational &number); // NOLINT(google-explicit-constructor)
  Term(const Surd &number);     // NOLINT(google-explicit-constructor)
  explicit Term(std::shared_ptr<const TermNode> node) : m_node(std::move(node)) {}

  [[nodiscard]] const TermNode &operator*() const { return *m_node; }
  [[nodiscard]] const TermNode *operator->() const { return m_node.get(); }

  /// The same term as part of the figure: the id of the mark that it is.
  [[nodiscard]] Term marked(std::string mark) const;
  /// The same name with what it stands for, where no worked line says that.
  [[nodiscard]] Term standingFor(Term meaning) const;

private:
  std::shared_ptr<const TermNode> m_node;
};

struct TermNode {
  TermKind kind = TermKind::Number;
  /// What it is made of. Of a number: the term of digits that is written for it.
  std::vector<Term> parts{};
  /// What it comes to; nothing where it divides by zero, takes the root of a negative number, or mixes
  /// numbers and vectors.
  std::optional<TermValue> value{};
  Symbol symbol{};                          ///< of Name, Unknown, Applied
  std::string digits{};                     ///< of Digits
  bool isRounded = false;                   ///< of Number: its digits are not all there are
  std::size_t columns = 0;                  ///< of Matrix, Determinant
  std::string mark{};                       ///< the figure's mark that the term is; empty for none
  std::optional<CoordinateSource> source{}; ///< of Number, Name: the coordinate that it is
  /// Of Number, List: what was calculated to get here; of a name: what it stands for.
  std::optional<Term> origin{};
};

/// A number, and what was calculated to get it.
[[nodiscard]] Term number(const Real &value, std::optional<Term> origin = {},
                          std::optional<CoordinateSource> source = {});
/// A name and what it stands for: nothing where that is no number, as with an angle.
[[nodiscard]] Term name(Symbol symbol, std::optional<TermValue> value);
/// A name of one of the scene's coordinates.
[[nodiscard]] Term given(Symbol symbol, const Vec3<Rational> &value, std::string object,
                         std::size_t coordinate);
[[nodiscard]] Term unknown(std::string letter);
/// f(Q), with its value.
[[nodiscard]] Term applied(Symbol function, Term argument, TermValue value);

[[nodiscard]] Term dot(Term a, Term b);
[[nodiscard]] Term cross(Term a, Term b);
[[nodiscard]] Term power(Term base, int exponent);
[[nodiscard]] Term root(Term square);
[[nodiscard]] Term norm(Term vector);
/// Its numbers are written alike: all fractions, or all decimals.
[[nodiscard]] Term list(std::vector<Term> entries);
/// 0 without summands.
[[nodiscard]] Term sum(std::vector<Term> summands);
/// 1 without factors.
[[nodiscard]] Term product(std::vector<Term> factors);
/// Requires as many rows as columns, at least one; or one row of vectors, which are the columns.
[[nodiscard]] Term determinant(std::size_t columns, std::vector<Term> entries);
/// Requires whole rows, at least one, of at least one column.
[[nodiscard]] Term matrix(std::size_t columns, std::vector<Term> entries);
/// The permuted inner product of two lines with directions d and moments m.
[[nodiscard]] Term permuted(Term d1, Term m1, Term d2, Term m2);

[[nodiscard]] Term operator-(Term term);
[[nodiscard]] Term operator+(Term a, Term b);
[[nodiscard]] Term operator-(Term a, Term b);
[[nodiscard]] Term operator*(Term a, Term b);
[[nodiscard]] Term operator/(Term a, Term b);

/// The same operation on other parts, which are no part of the figure.
[[nodiscard]] Term withParts(const Term &term, std::vector<Term> parts);

/// The number that the term comes to, where it is one without unknowns; null elsewhere.
[[nodiscard]] const Real *numberOf(const Term &term);

/// The names and applications in the term, each once, in the order of reading; not those that an application
/// is taken of.
[[nodiscard]] std::vector<Term> namesIn(const Term &term);

/// Whether one can stand for the other wherever they are written: they read alike, are the same marks and
/// coordinates, and their numbers come from terms that read alike. Never where a number is rounded: another
/// may be behind the same digits.
[[nodiscard]] bool areInterchangeable(const Term &a, const Term &b);

/// Whether both terms look the same on the page. The sign of a fraction's numerator is that of the fraction.
[[nodiscard]] bool readAlike(const Term &a, const Term &b);

} // namespace halfspace
