#include "lessons/term/spoken.h"

#include "lessons/language.h"
#include "lessons/term/greek.h"
#include "lessons/term/prime.h"
#include "lessons/term/term_shape.h"
#include "lessons/term/term_writer.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

/// The names of Greek letters, and of letters that would not be heard.
std::string letterName(const std::string &letter) {
  const GreekLetter *greek = greekLetter(letter);
  return greek ? words(greek->name.english) : letter;
}

/// What an abbreviated word stands for.
std::string wordName(const std::string &word) {
  if (word == "cos")
    return words("cosine");
  if (word == "max")
    return words("the largest");
  if (word == "min")
    return words("the smallest");
  return word == "dist" ? words("distance") : word;
}

class SpokenNotation : public Notation<std::string> {
public:
  [[nodiscard]] std::string row(std::vector<std::string> parts) const override {
    std::string text;
    for (const std::string &part : parts)
      text += (text.empty() || part.empty() ? "" : " ") + part;
    return text;
  }

  [[nodiscard]] std::string digits(const std::string &decimal) const override {
    return withDecimalMark(letterName(decimal));
  }

  [[nodiscard]] std::string symbol(const Symbol &symbol) const override {
    const std::string letter =
        symbol.isWord ? wordName(symbol.letter) : letterName(withoutPrime(symbol.letter));
    const std::string owner =
        symbol.owner.empty() ? "" : words("of {object}", {{"object", this->symbol(symbolOf(symbol.owner))}});
    return row({letter, isPrimed(symbol.letter) ? words("prime") : "", symbol.subscript, owner,
                symbol.isPerp ? words("perp") : ""});
  }

  [[nodiscard]] std::string sign(TermSign sign) const override {
    switch (sign) {
    case TermSign::Plus:
      return words("plus");
    case TermSign::Minus:
    case TermSign::Negative:
      return words("minus");
    case TermSign::Dot:
      return words("dot");
    case TermSign::Cross:
      return words("cross");
    case TermSign::Permuted:
      return words("permuted product with");
    case TermSign::Times:
    case TermSign::Gap:
    case TermSign::Joint:
      break;
    }
    return words("times");
  }

  [[nodiscard]] std::string relation(Relation relation) const override {
    switch (relation) {
    case Relation::Equal:
      return words("equals");
    case Relation::Approximately:
      return words("is about");
    case Relation::Less:
      return words("is less than");
    case Relation::Greater:
      return words("is greater than");
    case Relation::Unequal:
      break;
    }
    return words("is not equal to");
  }

  [[nodiscard]] std::string parenthesized(std::string inside, const Term &term) const override {
    if (term->kind == TermKind::Number && shown(term)->kind == TermKind::Negation)
      return inside; // a minus is heard as that of the number
    return parenthesizedBase(std::move(inside), term);
  }

  /// Minus three squared would be another number.
  [[nodiscard]] std::string parenthesizedBase(std::string inside, const Term &) const override {
    return row({words("open parenthesis"), std::move(inside), words("close parenthesis")});
  }

  [[nodiscard]] std::string fraction(std::string top, std::string bottom, FractionLook look) const override {
    std::string text = row({std::move(top), words("over"), std::move(bottom)});
    return look.compound || look.nested
               ? row({words("the fraction"), std::move(text), words("end of fraction")})
               : text;
  }

  [[nodiscard]] std::string root(std::string square) const override {
    return row({words("the square root of"), std::move(square), words("end of root")});
  }
  [[nodiscard]] std::string norm(std::string vector) const override {
    return row({words("the length of"), std::move(vector)});
  }

  /// The length of n plus w might be that of the sum.
  [[nodiscard]] std::string normOf(std::string inside, const Term &term) const override {
    const bool isNumber = term->value && !term->value->isList;
    std::string text =
        isNumber ? row({words("the magnitude of"), std::move(inside)}) : norm(std::move(inside));
    if (!isCompound(term))
      return text;
    return row({std::move(text), isNumber ? words("end of magnitude") : words("end of length")});
  }

  [[nodiscard]] std::string power(std::string base, std::string exponent) const override {
    return exponent == "2" ? row({std::move(base), words("squared")})
                           : row({std::move(base), words("to the power"), std::move(exponent)});
  }

  [[nodiscard]] std::string list(std::vector<std::string> entries) const override {
    if (entries.size() == 1) // a function's argument in parentheses, as in floor(p), is a list of one
      return entries.front();
    std::string text = entries.size() == 3 ? words("the triple") : words("the list");
    for (std::size_t i = 0; i < entries.size(); ++i)
      text += (i == 0 ? " " : ", ") + entries[i];
    return text + ",";
  }

  [[nodiscard]] std::string matrix(std::vector<std::string> entries, std::size_t columns,
                                   bool isDeterminant) const override {
    const bool areColumns = isDeterminant && columns > 1 && entries.size() == columns;
    std::string text = isDeterminant ? words("the determinant") : words("the matrix");
    for (std::size_t i = 0; i < entries.size(); ++i)
      text += (i % columns != 0 ? ", " : ", " + (areColumns ? words("columns") : words("row")) + " ") +
              entries[i];
    return text + ",";
  }

  [[nodiscard]] std::string applied(std::string function, std::string argument, bool) const override {
    return row({std::move(function), words("of"), std::move(argument)});
  }

  [[nodiscard]] bool isFlat() const override { return false; }
};

} // namespace

std::string spoken(const Term &term) { return TermWriter(SpokenNotation()).write(term); }

std::string spoken(const Chain &chain) { return TermWriter(SpokenNotation()).write(chain); }

} // namespace halfspace
