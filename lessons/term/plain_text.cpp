#include "lessons/term/plain_text.h"

#include "lessons/language.h"
#include "lessons/term/term_writer.h"
#include "lessons/text.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace halfspace {
namespace {

constexpr std::array<std::string_view, 10> raisedDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
constexpr std::array<std::string_view, 10> loweredDigits{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};

bool areDigits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

std::string inForm(const std::array<std::string_view, 10> &forms, std::string_view digits) {
  std::string text;
  for (const char digit : digits)
    text += forms.at(static_cast<std::size_t>(digit - '0'));
  return text;
}

constexpr std::string_view minus = "−";

class PlainNotation : public Notation<std::string> {
public:
  [[nodiscard]] std::string row(std::vector<std::string> parts) const override {
    std::string text;
    for (const std::string &part : parts)
      text += part;
    return text;
  }

  [[nodiscard]] std::string digits(const std::string &decimal) const override {
    return withDecimalMark(decimal);
  }

  [[nodiscard]] std::string symbol(const Symbol &symbol) const override { return plainText(symbol); }

  [[nodiscard]] std::string sign(TermSign sign) const override {
    switch (sign) {
    case TermSign::Plus:
      return " + ";
    case TermSign::Minus:
      return " − ";
    case TermSign::Negative:
      return std::string(minus);
    case TermSign::Dot:
    case TermSign::Times:
      return "·";
    case TermSign::Cross:
      return "×";
    case TermSign::Permuted:
      return " ∗ ";
    case TermSign::Joint:
      return "";
    case TermSign::Gap:
      break;
    }
    return " ";
  }

  [[nodiscard]] std::string relation(Relation relation) const override {
    switch (relation) {
    case Relation::Equal:
      return " = ";
    case Relation::Approximately:
      return " ≈ ";
    case Relation::Less:
      return " < ";
    case Relation::Greater:
      return " > ";
    case Relation::Unequal:
      break;
    }
    return " ≠ ";
  }

  [[nodiscard]] std::string parenthesized(std::string inside, const Term &) const override {
    return "(" + inside + ")";
  }
  [[nodiscard]] std::string fraction(std::string top, std::string bottom, FractionLook) const override {
    return top + "/" + bottom;
  }
  [[nodiscard]] std::string root(std::string square) const override { return "√" + square; }
  [[nodiscard]] std::string norm(std::string vector) const override { return "|" + vector + "|"; }

  [[nodiscard]] std::string power(std::string base, std::string exponent) const override {
    const bool negative = exponent.starts_with(minus);
    const std::string_view magnitude = std::string_view(exponent).substr(negative ? minus.size() : 0);
    return areDigits(magnitude) ? base + (negative ? "⁻" : "") + inForm(raisedDigits, magnitude)
                                : base + "^(" + exponent + ")";
  }

  [[nodiscard]] std::string list(std::vector<std::string> entries) const override {
    return "(" + joined(entries, listSeparator() + std::string(" ")) + ")";
  }

  [[nodiscard]] std::string matrix(std::vector<std::string> entries, std::size_t columns,
                                   bool isDeterminant) const override {
    std::string rows;
    for (std::size_t i = 0; i < entries.size(); ++i)
      rows += (i == 0 ? "" : i % columns == 0 ? "; " : " ") + entries[i];
    return isDeterminant ? "det[" + rows + "]" : "[" + rows + "]";
  }

  [[nodiscard]] std::string applied(std::string function, std::string argument,
                                    bool inParentheses) const override {
    if (inParentheses)
      return function + "(" + argument + ")";
    return function + (argument.starts_with("(") ? "" : " ") + argument;
  }

  [[nodiscard]] bool isFlat() const override { return true; }

private:
  static std::string joined(const std::vector<std::string> &parts, std::string_view separator) {
    std::string text;
    for (const std::string &part : parts)
      text += (text.empty() ? "" : std::string(separator)) + part;
    return text;
  }
};

} // namespace

std::string plainText(const Symbol &symbol) {
  std::string text = symbol.letter;
  if (areDigits(symbol.subscript))
    text += inForm(loweredDigits, symbol.subscript);
  else if (!symbol.subscript.empty())
    text += "_" + symbol.subscript;
  if (!symbol.owner.empty())
    text += "_" + plainText(symbolOf(symbol.owner));
  return symbol.isPerp ? text + "⊥" : text;
}

std::string relatedText(const Term &value) {
  return (showsRounded(value) ? " ≈ " : " = ") + plainText(value);
}

std::string relatedText(const WrittenNumber &number) {
  return (number.exact ? " = " : " ≈ ") + plainText(number.term);
}

std::string plainText(const Term &term) { return TermWriter(PlainNotation()).write(term); }

std::string plainText(const Chain &chain) { return TermWriter(PlainNotation()).write(chain); }

std::string plainText(const Chain &chain, std::size_t begin, std::size_t end) {
  return TermWriter(PlainNotation()).write(chain, begin, end);
}

std::string plainTextWithout(const Term &part, const Chain &chain) {
  const PlainNotation notation;
  TermWriter writer(notation);
  writer.leaveOut(part);
  return writer.write(chain);
}

bool isBehindMinus(const Term &part, const Chain &chain) {
  const std::string text = plainTextWithout(part, chain);
  const std::string_view before = std::string_view(text).substr(0, text.find(PlainNotation().blank()));
  return trimmed(before).ends_with(minus);
}

} // namespace halfspace
