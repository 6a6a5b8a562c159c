#include "lessons/term/spoken.h"

#include "lessons/language.h"
#include "lessons/term/greek.h"
#include "lessons/term/prime.h"
#include "lessons/term/term_writer.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

/// The names of Greek letters, and of letters that would not be heard.
std::string letterName(const std::string &letter) {
  const GreekLetter *greek = greekLetter(letter);
  return greek ? words(greek->name) : letter;
}

/// What an abbreviated word stands for.
std::string wordName(const std::string &word) {
  if (word == "cos")
    return words("cosine");
  return word == "dist" ? words("distance") : word;
}

class SpokenWriter : public TermWriter<std::string> {
public:
protected:
  std::string row(std::vector<std::string> parts) override {
    std::string text;
    for (const std::string &part : parts)
      text += (text.empty() || part.empty() ? "" : " ") + part;
    return text;
  }

  std::string digits(const std::string &decimal) override { return withDecimalMark(letterName(decimal)); }

  std::string symbol(const Symbol &symbol) override {
    const std::string letter =
        symbol.isWord ? wordName(symbol.letter) : letterName(withoutPrime(symbol.letter));
    const std::string owner =
        symbol.owner.empty() ? "" : words("of {object}", {{"object", this->symbol(symbolOf(symbol.owner))}});
    return row({letter, isPrimed(symbol.letter) ? words("prime") : "", symbol.subscript, owner,
                symbol.isPerp ? words("perp") : ""});
  }

  std::string sign(TermSign sign) override {
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

  std::string relation(Relation relation) override {
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

  std::string parenthesized(std::string inside, const Term &term) override {
    if (term->kind == TermKind::Number && shown(term)->kind == TermKind::Negation)
      return inside; // a minus is heard as that of the number
    return parenthesizedBase(std::move(inside), term);
  }

  /// Minus three squared would be another number.
  std::string parenthesizedBase(std::string inside, const Term &) override {
    return row({words("open parenthesis"), std::move(inside), words("close parenthesis")});
  }

  std::string fraction(std::string top, std::string bottom, FractionLook look) override {
    std::string text = row({std::move(top), words("over"), std::move(bottom)});
    return look.compound || look.nested
               ? row({words("the fraction"), std::move(text), words("end of fraction")})
               : text;
  }

  std::string root(std::string square) override {
    return row({words("the square root of"), std::move(square), words("end of root")});
  }
  std::string norm(std::string vector) override { return row({words("the length of"), std::move(vector)}); }

  /// The length of n plus w might be that of the sum.
  std::string normOf(std::string inside, const Term &term) override {
    const bool isNumber = term->value && !term->value->isList;
    std::string text =
        isNumber ? row({words("the magnitude of"), std::move(inside)}) : norm(std::move(inside));
    if (!isCompound(term))
      return text;
    return row({std::move(text), isNumber ? words("end of magnitude") : words("end of length")});
  }

  std::string power(std::string base, std::string exponent) override {
    return exponent == "2" ? row({std::move(base), words("squared")})
                           : row({std::move(base), words("to the power"), std::move(exponent)});
  }

  std::string list(std::vector<std::string> entries) override {
    std::string text = entries.size() == 3 ? words("the triple") : words("the list");
    for (std::size_t i = 0; i < entries.size(); ++i)
      text += (i == 0 ? " " : ", ") + entries[i];
    return text + ",";
  }

  std::string matrix(std::vector<std::string> entries, std::size_t columns, bool isDeterminant) override {
    const bool areColumns = isDeterminant && columns > 1 && entries.size() == columns;
    std::string text = isDeterminant ? words("the determinant") : words("the matrix");
    for (std::size_t i = 0; i < entries.size(); ++i)
      text += (i % columns != 0 ? ", " : ", " + (areColumns ? words("columns") : words("row")) + " ") +
              entries[i];
    return text + ",";
  }

  std::string applied(std::string function, std::string argument, bool) override {
    return row({std::move(function), words("of"), std::move(argument)});
  }

  [[nodiscard]] bool isFlat() const override { return false; }

private:
};

} // namespace

std::string spoken(const Term &term) { return SpokenWriter().write(term); }

std::string spoken(const Chain &chain) { return SpokenWriter().write(chain); }

} // namespace halfspace
