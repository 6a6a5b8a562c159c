#include "lessons/term/latex.h"

#include "lessons/language.h"
#include "lessons/term/greek.h"
#include "lessons/term/prime.h"
#include "lessons/term/term_shape.h"
#include "lessons/term/term_writer.h"
#include "lessons/term/written.h"
#include "lessons/text.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace halfspace {
namespace {

std::string letterLatex(const std::string &letter) {
  const GreekLetter *greek = greekLetter(letter);
  return greek ? "\\" + std::string(greek->latex) : letter;
}

std::string wordLatex(const std::string &word) {
  constexpr std::array<std::string_view, 3> known{"cos", "sin", "tan"};
  const bool isKnown = std::find(known.begin(), known.end(), word) != known.end();
  if (isKnown)
    return "\\" + word;
  const std::string escaped = replacedAll(replacedAll(word, "_", "\\_"), "-", "\\mbox{-}");
  return "\\operatorname{" + escaped + "}";
}

class LatexNotation : public Notation<std::string> {
public:
  explicit LatexNotation(Fractions fractions) : m_fractions(fractions) {}

  [[nodiscard]] std::string row(std::vector<std::string> parts) const override {
    std::string text;
    for (const std::string &part : parts)
      append(text, part);
    return text;
  }

  [[nodiscard]] std::string digits(const std::string &decimal) const override {
    return latexDecimal(letterLatex(decimal));
  }

  [[nodiscard]] std::string symbol(const Symbol &symbol) const override { return latexOf(symbol); }

  [[nodiscard]] std::string sign(TermSign sign) const override {
    switch (sign) {
    case TermSign::Plus:
      return " + ";
    case TermSign::Minus:
      return " - ";
    case TermSign::Negative:
      return "-";
    case TermSign::Dot:
    case TermSign::Times:
      return "\\cdot ";
    case TermSign::Cross:
      return "\\times ";
    case TermSign::Permuted:
      return " * ";
    case TermSign::Joint:
      return "";
    case TermSign::Gap:
      break;
    }
    return "\\,";
  }

  [[nodiscard]] std::string relation(Relation relation) const override {
    switch (relation) {
    case Relation::Equal:
      return " = ";
    case Relation::Approximately:
      return " \\approx ";
    case Relation::Less:
      return " < ";
    case Relation::Greater:
      return " > ";
    case Relation::Unequal:
      break;
    }
    return " \\neq ";
  }

  [[nodiscard]] std::string parenthesized(std::string inside, const Term &term) const override {
    return isTall(term) ? "\\left(" + inside + "\\right)" : "(" + inside + ")";
  }

  [[nodiscard]] std::string fraction(std::string top, std::string bottom, FractionLook look) const override {
    return isFlat() || look.flat ? top + "/" + bottom
                                 : (look.small ? "\\tfrac{" : "\\frac{") + top + "}{" + bottom + "}";
  }

  [[nodiscard]] std::string root(std::string square) const override { return "\\sqrt{" + square + "}"; }
  [[nodiscard]] std::string norm(std::string vector) const override {
    return row({"\\lvert", std::move(vector), "\\rvert"});
  }

  [[nodiscard]] std::string power(std::string base, std::string exponent) const override {
    return base + (exponent.size() == 1 ? "^" + exponent : "^{" + exponent + "}");
  }

  [[nodiscard]] std::string list(std::vector<std::string> entries) const override {
    std::string text;
    for (const std::string &entry : entries)
      text += (text.empty() ? "" : listSeparator() + std::string("\\,")) + entry;
    return "\\left(" + text + "\\right)";
  }

  [[nodiscard]] std::string matrix(std::vector<std::string> entries, std::size_t columns,
                                   bool isDeterminant) const override {
    const std::string kind = isDeterminant ? "vmatrix" : "pmatrix";
    std::string rows;
    for (std::size_t i = 0; i < entries.size(); ++i)
      rows += (i == 0 ? "" : i % columns == 0 ? " \\\\ " : " & ") + entries[i];
    return "\\begin{" + kind + "}" + rows + "\\end{" + kind + "}";
  }

  [[nodiscard]] std::string applied(std::string function, std::string argument,
                                    bool inParentheses) const override {
    return inParentheses ? function + "(" + argument + ")" : row({std::move(function), std::move(argument)});
  }

  [[nodiscard]] bool isFlat() const override { return m_fractions == Fractions::Flat; }
  [[nodiscard]] bool hasBareRoots() const override { return false; }

private:
  /// A letter behind a command would become part of its name.
  static void append(std::string &text, const std::string &next) {
    const auto lastOther = std::find_if_not(text.rbegin(), text.rend(), isLetter);
    const bool endsInCommand = lastOther != text.rbegin() && lastOther != text.rend() && *lastOther == '\\';
    text += (endsInCommand && !next.empty() && isLetter(next.front()) ? " " : "") + next;
  }

  Fractions m_fractions;
};

/// Digits and a letter as they are, and words upright.
std::string subscriptLatex(const std::string &text) {
  const bool isWord =
      text.size() > characterLength(text) && text.find_first_not_of("0123456789") != std::string::npos;
  return isWord ? "\\text{" + text + "}" : text;
}

/// What stands in a subscript: the symbol's own, and whose it is.
std::string indexLatex(const Symbol &symbol) {
  std::string own = subscriptLatex(symbol.subscript);
  if (symbol.owner.empty())
    return own;
  return own + (own.empty() ? "" : ",") + latexOf(symbolOf(symbol.owner));
}

} // namespace

std::string latexOf(const Symbol &symbol) {
  std::string text = symbol.isWord ? wordLatex(symbol.letter) : letterLatex(withoutPrime(symbol.letter));
  if (symbol.isVector)
    text = "\\vec " + text;
  if (isPrimed(symbol.letter))
    text += "'";
  if (const std::string index = indexLatex(symbol); !index.empty())
    text += index.size() == 1 ? "_" + index : "_{" + index + "}";
  return symbol.isPerp ? text + "^{\\perp}" : text;
}

std::string latexOf(const Term &term, Fractions fractions) {
  return TermWriter(LatexNotation(fractions)).write(term);
}

std::string latexDecimal(const std::string &decimal) {
  const auto point = decimal.find('.');
  return point == std::string::npos || language().decimalMark == '.'
             ? decimal
             : decimal.substr(0, point) + "{,}" + decimal.substr(point + 1);
}

std::string relatedLatex(const Term &value, Fractions fractions) {
  return (showsRounded(value) ? " \\approx " : " = ") + latexOf(value, fractions);
}

std::string degreesLatex(const WrittenNumber &degrees) {
  return (degrees.exact ? "= " : "\\approx ") + latexOf(degrees.term) + "^{\\circ}";
}

std::string latexOf(const Chain &chain, Fractions fractions) {
  return TermWriter(LatexNotation(fractions)).write(chain);
}

std::string latexOf(const Chain &chain, std::size_t begin, std::size_t end, Fractions fractions) {
  return TermWriter(LatexNotation(fractions)).write(chain, begin, end);
}

} // namespace halfspace
