// Formulas as they are typed, read and written.
#pragma once

#include "lessons/formula/formula.h"

namespace halfspace {

/// shortest(v), the one function that formulas have.
inline constexpr std::string_view shortestWord = "shortest";

/// Whether something goes by a name.
using IsName = std::function<bool(std::string_view name)>;

/// Reads formulas out of a text, one after the other, and says where it stands. Once something cannot be read
/// all that follows is nothing, and the fault is told.
///
/// Numbers are 3, −10/3, 3 1/3 and 1.5, with the decimal mark that is said; names begin with a letter, and go
/// on with letters, digits and _; E.n is the n of E, Q.x a component. 2k and (1/2) n are products, `*`
/// likewise; u · v and u × v are those of vectors, k² and k^2 powers. (1, 2k, 3) are three numbers, with
/// semicolons between them where the comma is the decimal mark.
class FormulaReader {
public:
  /// The text must outlive it. A hyphen belongs to a name where `isName` knows one with it, else it is a
  /// minus.
  explicit FormulaReader(std::string_view text, char decimalMark = '.', IsName isName = {});

  /// A whole formula: as much as there is of sums and products.
  Formula sum();
  /// A name with its dots, or a word with hyphens; empty where none stands here.
  std::string_view takeName();
  std::string_view takeWord();
  /// Whether this sign stands here, behind spaces; it is taken then.
  bool take(std::string_view sign);
  [[nodiscard]] bool isAtEnd();
  /// The byte that is read next, behind spaces.
  [[nodiscard]] std::size_t at();
  void goTo(std::size_t at) { m_at = at; }
  /// What separates entries of a list: ; or ,
  bool takeSeparator();

  void fail(const std::string &sentence, std::size_t at);
  [[nodiscard]] const std::optional<FormulaFault> &fault() const { return m_fault; }

private:
  Formula product();
  Formula signedFactor();
  Formula factor();
  Formula simple();
  Formula bracketed();
  Formula number();
  [[nodiscard]] bool beginsFactor();
  [[nodiscard]] std::size_t endOfName(std::size_t begin) const;
  [[nodiscard]] std::string_view digitsAt(std::size_t at) const;
  Formula failed(const std::string &sentence, std::size_t at);

  std::string_view m_text;
  char m_decimalMark;
  IsName m_isName;
  std::size_t m_at = 0;
  int m_depth = 0;
  std::optional<FormulaFault> m_fault;
};

/// All of a text is a formula; or what is wrong in it.
[[nodiscard]] std::variant<Formula, FormulaFault> readFormula(std::string_view text, char decimalMark = '.',
                                                              const IsName &isName = {});

/// The formula as `readFormula` reads it: with no more parentheses than it takes.
[[nodiscard]] std::string toText(const Formula &formula, char decimalMark = '.');

} // namespace halfspace
