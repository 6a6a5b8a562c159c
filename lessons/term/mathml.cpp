#include "lessons/term/mathml.h"

#include "lessons/language.h"
#include "lessons/term/prime.h"
#include "lessons/term/term_writer.h"
#include "lessons/xml_text.h"

#include <cstdint>
#include <string_view>

namespace halfspace {
namespace {

std::string operation(std::string_view sign) { return xmlElement("mo", escapedForXml(sign)); }

/// Whether terms that are marks of the figure carry their ids.
enum class MarkIds : std::uint8_t { Carried, LeftOut };

class MathMlNotation : public Notation<std::string> {
public:
  explicit MathMlNotation(MarkIds markIds) : m_markIds(markIds) {}

  [[nodiscard]] std::string row(std::vector<std::string> parts) const override {
    std::string content;
    for (const std::string &part : parts)
      content += part;
    return parts.size() == 1 ? content : xmlElement("mrow", content);
  }

  [[nodiscard]] std::string digits(const std::string &decimal) const override {
    return xmlElement("mn", escapedForXml(withDecimalMark(decimal)));
  }

  [[nodiscard]] std::string symbol(const Symbol &symbol) const override {
    std::string text = xmlElement("mi", escapedForXml(withoutPrime(symbol.letter)));
    if (symbol.isVector)
      text = "<mover accent=\"true\">" + text + operation("→") + "</mover>";
    if (isPrimed(symbol.letter))
      text = xmlElement("msup", text + operation(primeSign));
    std::string index = symbol.subscript.empty() ? "" : subscript(symbol.subscript);
    if (!symbol.owner.empty())
      index = xmlElement("mrow", index + this->symbol(symbolOf(symbol.owner)));
    if (!index.empty())
      text = xmlElement("msub", text + index);
    return symbol.isPerp ? xmlElement("msup", text + operation("⊥")) : text;
  }

  [[nodiscard]] std::string sign(TermSign sign) const override {
    switch (sign) {
    case TermSign::Plus:
      return operation("+");
    case TermSign::Minus:
      return operation("−");
    case TermSign::Negative:
      return "<mo form=\"prefix\">−</mo>";
    case TermSign::Dot:
    case TermSign::Times:
      return operation("·");
    case TermSign::Cross:
      return operation("×");
    case TermSign::Permuted:
      return operation("∗");
    case TermSign::Joint:
      return operation("\u2062"); // invisible times
    case TermSign::Gap:
      break;
    }
    return "<mspace width=\"0.17em\"/>";
  }

  [[nodiscard]] std::string relation(Relation relation) const override {
    switch (relation) {
    case Relation::Equal:
      return operation("=");
    case Relation::Approximately:
      return operation("≈");
    case Relation::Less:
      return operation("<");
    case Relation::Greater:
      return operation(">");
    case Relation::Unequal:
      break;
    }
    return operation("≠");
  }

  [[nodiscard]] std::string parenthesized(std::string inside, const Term &) const override {
    return fenced("(", inside, ")");
  }
  [[nodiscard]] std::string fraction(std::string top, std::string bottom, FractionLook look) const override {
    if (look.flat)
      return row({std::move(top), operation("/"), std::move(bottom)});
    const std::string fraction = xmlElement("mfrac", top + bottom);
    return look.small ? "<mstyle displaystyle=\"false\">" + fraction + "</mstyle>" : fraction;
  }
  [[nodiscard]] std::string root(std::string square) const override { return xmlElement("msqrt", square); }
  [[nodiscard]] std::string norm(std::string vector) const override { return fenced("|", vector, "|"); }
  [[nodiscard]] std::string power(std::string base, std::string exponent) const override {
    return xmlElement("msup", base + exponent);
  }

  [[nodiscard]] std::string list(std::vector<std::string> entries) const override {
    std::string content;
    for (const std::string &entry : entries)
      content += (content.empty() ? "" : operation(std::string(1, listSeparator()))) + entry;
    return fenced("(", content, ")");
  }

  [[nodiscard]] std::string matrix(std::vector<std::string> entries, std::size_t columns,
                                   bool isDeterminant) const override {
    std::string rows;
    for (std::size_t i = 0; i < entries.size(); i += columns) {
      std::string cells;
      for (std::size_t column = 0; column < columns; ++column)
        cells += xmlElement("mtd", entries[i + column]);
      rows += xmlElement("mtr", cells);
    }
    const std::string table = xmlElement("mtable", rows);
    return isDeterminant ? fenced("|", table, "|") : fenced("(", table, ")");
  }

  [[nodiscard]] std::string applied(std::string function, std::string argument,
                                    bool inParentheses) const override {
    return row({std::move(function), operation("\u2061"), // function application
                inParentheses ? fenced("(", argument, ")") : argument});
  }

  [[nodiscard]] std::string touchable(const Term &term, std::string text) const override {
    const bool carriesId = m_markIds == MarkIds::Carried && !term->mark.empty();
    return !carriesId ? text : "<mrow data-mark=\"" + escapedForXml(term->mark) + "\">" + text + "</mrow>";
  }

  [[nodiscard]] bool isFlat() const override { return false; }

private:
  static std::string subscript(const std::string &text) {
    const bool isNumber = text.find_first_not_of("0123456789") == std::string::npos;
    return xmlElement(isNumber ? "mn" : "mi", escapedForXml(text));
  }

  static std::string fenced(std::string_view open, const std::string &inside, std::string_view close) {
    return xmlElement("mrow", operation(open) + inside + operation(close));
  }

  MarkIds m_markIds;
};

/// `attributes`: each with a space before it.
std::string document(const std::string &content, std::string_view attributes = {}) {
  return "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"" + std::string(attributes) + ">" + content +
         "</math>";
}

template <class Terms> std::string withMarkIds(const Terms &terms) {
  return document(TermWriter(MathMlNotation(MarkIds::Carried)).write(terms));
}

} // namespace

std::string mathMl(const Term &term) { return withMarkIds(term); }

std::string mathMl(const Chain &chain) { return withMarkIds(chain); }

std::string mathMlRow(const Chain &chain, std::size_t begin, std::size_t end) {
  return TermWriter(MathMlNotation(MarkIds::LeftOut)).write(chain, begin, end);
}

std::string displayedMathMl(const std::vector<std::string> &rows) {
  // The gap is as wide as LaTeX's quad.
  const std::string separator = operation(",") + "<mspace width=\"1em\"/>";
  std::string content;
  for (const std::string &row : rows)
    content += (content.empty() ? "" : separator) + row;
  return document(content, " display=\"block\"");
}

} // namespace halfspace
