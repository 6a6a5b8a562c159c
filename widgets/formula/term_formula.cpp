#include "widgets/formula/term_formula.h"

#include "lessons/language.h"
#include "lessons/scene/provenance.h"
#include "lessons/term/prime.h"
#include "lessons/term/term_shape.h"
#include "lessons/term/term_writer.h"
#include "lessons/term/written.h"
#include "lessons/text.h"

#include <algorithm>
#include <string_view>

namespace halfspace {
namespace {

using math::AtomClass;
using math::Row;

constexpr char32_t minus = 0x2212;
constexpr char32_t primeCharacter = 0x2032;
constexpr char32_t centredDot = 0x22C5;
constexpr char32_t perpendicular = 0x22A5;
constexpr char32_t infinity = 0x221E;
/// Of parentheses around small fractions, in em: as tall as those that stretch are there.
constexpr double fenceOfFractions = 1.1;
/// TeX's thin space, in em.
constexpr double thinSpace = 3 / 18.0;

bool areDigits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

Row subscript(const std::string &text) {
  if (areDigits(text))
    return math::number(text);
  const Character first = firstCharacter(text);
  return math::row(first.length == text.size() ? math::letter(first.code) : math::words(text));
}

/// Digits with the decimal mark; it is no punctuation, behind which a space would stand.
Row decimalOf(const std::string &digits) {
  const char decimalMark = language().decimalMark;
  const auto point = digits.find('.');
  if (decimalMark == '.' || point == std::string::npos)
    return math::number(digits);
  return math::row(math::number(digits.substr(0, point)),
                   math::symbol(static_cast<unsigned char>(decimalMark), AtomClass::Ord),
                   math::number(digits.substr(point + 1)));
}

char32_t signOf(Relation relation) {
  switch (relation) {
  case Relation::Equal:
    return '=';
  case Relation::Approximately:
    return 0x2248;
  case Relation::Less:
    return '<';
  case Relation::Greater:
    return '>';
  case Relation::Unequal:
    break;
  }
  return 0x2260;
}

Row leftOut(const math::Room &room) { return {math::tagged(math::LeftOut{}, Row{math::Node{room}})}; }

class FormulaNotation : public Notation<Row> {
public:
  /// The numbers that can be traced are tagged and put behind `numbers`, unless that is null.
  explicit FormulaNotation(Fractions fractions = Fractions::Stacked, std::vector<Term> *numbers = nullptr,
                           const math::Room &roomOfBlank = {})
      : m_fractions(fractions), m_numbers(numbers), m_roomOfBlank(roomOfBlank) {}

  [[nodiscard]] Row row(std::vector<Row> parts) const override {
    Row all;
    for (Row &part : parts)
      all.insert(all.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
    return all;
  }

  [[nodiscard]] Row digits(const std::string &decimal) const override {
    return areDigits(decimal.substr(0, 1)) ? decimalOf(decimal) : math::row(math::symbol(infinity));
  }

  [[nodiscard]] Row symbol(const Symbol &symbol) const override {
    Row base{symbol.isWord ? math::function(symbol.letter)
                           : math::letter(firstCharacter(symbol.letter).code)};
    if (symbol.isVector)
      base = {math::vector(std::move(base))};
    Row below = symbol.subscript.empty() ? Row() : subscript(symbol.subscript);
    if (!symbol.owner.empty()) {
      if (!below.empty())
        below.push_back(math::symbol(',', AtomClass::Ord));
      const Row owner = this->symbol(symbolOf(symbol.owner));
      below.insert(below.end(), owner.begin(), owner.end());
    }
    Row above = symbol.isPerp ? math::row(math::symbol(perpendicular)) : Row();
    if (isPrimed(symbol.letter))
      above.insert(above.begin(), math::symbol(primeCharacter));
    return below.empty() && above.empty()
               ? base
               : math::row(math::scripts(std::move(base), std::move(above), std::move(below)));
  }

  [[nodiscard]] Row sign(TermSign sign) const override {
    switch (sign) {
    case TermSign::Plus:
      return {math::symbol('+', AtomClass::Bin)};
    case TermSign::Minus:
    case TermSign::Negative:
      return {math::symbol(minus, AtomClass::Bin)};
    case TermSign::Dot:
    case TermSign::Times:
      return {math::symbol(centredDot, AtomClass::Bin)};
    case TermSign::Cross:
      return {math::symbol(0xD7, AtomClass::Bin)};
    case TermSign::Permuted:
      return {math::symbol(0x2217, AtomClass::Bin)};
    case TermSign::Gap:
      return {math::space(thinSpace)};
    case TermSign::Joint:
      break;
    }
    return {};
  }

  [[nodiscard]] Row relation(Relation relation) const override {
    return {math::symbol(signOf(relation), AtomClass::Rel)};
  }

  [[nodiscard]] Row parenthesized(Row inside, const Term &term) const override {
    if (isTall(term))
      return math::row(math::fenced('(', std::move(inside), ')'));
    return math::row(math::symbol('(', AtomClass::Open), std::move(inside),
                     math::symbol(')', AtomClass::Close));
  }

  [[nodiscard]] Row fraction(Row top, Row bottom, FractionLook look) const override {
    if (look.flat || m_fractions == Fractions::Flat)
      return math::row(std::move(top), math::symbol('/'), std::move(bottom));
    return math::row(math::fraction(std::move(top), std::move(bottom),
                                    look.small ? std::optional(math::Style::Text) : std::nullopt));
  }

  [[nodiscard]] Row root(Row square) const override { return math::row(math::root(std::move(square))); }

  [[nodiscard]] Row norm(Row vector) const override {
    return math::row(math::symbol('|', AtomClass::Open), std::move(vector),
                     math::symbol('|', AtomClass::Close));
  }

  [[nodiscard]] Row normOf(Row inside, const Term &term) const override {
    return isTall(term) ? math::row(math::fenced('|', std::move(inside), '|')) : norm(std::move(inside));
  }

  [[nodiscard]] Row power(Row base, Row exponent) const override {
    return math::row(math::scripts(std::move(base), std::move(exponent), {}));
  }

  [[nodiscard]] Row list(std::vector<Row> entries) const override {
    return math::row(math::fenced('(', separated(std::move(entries)), ')'));
  }

  // With parentheses between which a line can be broken.

  [[nodiscard]] Row flatList(std::vector<Row> entries) const override {
    return between(math::symbol('(', AtomClass::Open), std::move(entries),
                   math::symbol(')', AtomClass::Close));
  }

  [[nodiscard]] Row numberList(std::vector<Row> entries) const override {
    if (isFlat()) // which are no higher than other numbers
      return flatList(std::move(entries));
    return between(math::Node{math::TallFence{'(', fenceOfFractions}, AtomClass::Open}, std::move(entries),
                   math::Node{math::TallFence{')', fenceOfFractions}, AtomClass::Close});
  }

  [[nodiscard]] Row matrix(std::vector<Row> entries, std::size_t columns, bool isDeterminant) const override {
    std::vector<std::vector<Row>> rows;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (i % columns == 0)
        rows.emplace_back();
      rows.back().push_back(std::move(entries[i]));
    }
    return math::row(isDeterminant ? math::matrix('|', std::move(rows), '|')
                                   : math::matrix('(', std::move(rows), ')'));
  }

  [[nodiscard]] Row applied(Row function, Row argument, bool inParentheses) const override {
    return inParentheses ? math::row(std::move(function), math::symbol('(', AtomClass::Open),
                                     std::move(argument), math::symbol(')', AtomClass::Close))
                         : math::row(std::move(function), std::move(argument));
  }

  [[nodiscard]] Row touchable(const Term &term, Row text) const override {
    if (m_numbers && isTraceable(term)) {
      text = math::row(math::tagged(m_numbers->size(), std::move(text)));
      m_numbers->push_back(term);
    }
    if (!term->mark.empty())
      text = math::row(math::tagged(term->mark, std::move(text)));
    return text;
  }

  [[nodiscard]] Row blank() const override { return leftOut(m_roomOfBlank); }

  [[nodiscard]] bool isFlat() const override { return m_fractions == Fractions::Flat; }

private:
  [[nodiscard]] Row separated(std::vector<Row> entries) const {
    Row content;
    for (Row &entry : entries)
      content = content.empty()
                    ? std::move(entry)
                    : math::row(std::move(content),
                                math::symbol(static_cast<unsigned char>(listSeparator()), AtomClass::Punct),
                                math::space(thinSpace), std::move(entry));
    return content;
  }

  [[nodiscard]] Row between(math::Node open, std::vector<Row> entries, math::Node close) const {
    return math::row(std::move(open), separated(std::move(entries)), std::move(close));
  }

  Fractions m_fractions;
  std::vector<Term> *m_numbers;
  math::Room m_roomOfBlank;
};

Row written(const std::vector<ChainPart> &parts, TermWriter<Row> writer) {
  Row row;
  for (const ChainPart &part : parts) {
    if (!row.empty())
      row = math::row(std::move(row), math::symbol(',', AtomClass::Punct), math::space(1));
    row = math::row(std::move(row), writer.write(*part.chain, part.begin, part.end));
  }
  return row;
}

} // namespace

math::Row formulaOf(const Term &term, Fractions fractions) {
  return TermWriter(FormulaNotation(fractions)).write(term);
}

math::Row relatedFormula(const Term &value, Fractions fractions) {
  const Relation relation = showsRounded(value) ? Relation::Approximately : Relation::Equal;
  return math::row(math::symbol(signOf(relation), AtomClass::Rel), formulaOf(value, fractions));
}

math::Row formulaOf(const LiveNumber &number) {
  const math::Node about = math::symbol(signOf(Relation::Approximately), AtomClass::Rel);
  Row row = formulaOf(number.term, Fractions::Flat);
  if (showsRounded(number.term))
    row.insert(row.begin(), about);
  return number.size ? math::row(std::move(row), about, formulaOf(*number.size, Fractions::Flat)) : row;
}

math::Row formulaOf(const Symbol &symbol) {
  return TermWriter(FormulaNotation()).write(name(symbol, std::nullopt));
}

TraceableFormula formulaOf(const WorkingLine &line, LinePiece piece) {
  TraceableFormula formula;
  const FormulaNotation notation(Fractions::Stacked, &formula.numbers);
  formula.row = written(partsOf(line, piece), TermWriter(notation));
  return formula;
}

TraceableFormula formulaOf(const WorkingLine &line, LinePiece piece, const Gap &gap, const math::Room &room) {
  if (gap.isResult && piece != LinePiece::Symbols)
    return {piece == LinePiece::Result ? math::row(math::symbol('=', AtomClass::Rel), leftOut(room)) : Row()};
  TraceableFormula formula;
  const FormulaNotation notation(Fractions::Stacked, &formula.numbers, room);
  TermWriter writer(notation);
  writer.leaveOut(gap.hidden);
  formula.row = written(partsOf(line, piece), writer);
  return formula;
}

math::Row formulaOf(const std::vector<Chain> &statements) {
  std::vector<ChainPart> parts;
  parts.reserve(statements.size());
  for (const Chain &chain : statements)
    parts.push_back({&chain, 0, chain.sides().size()});
  return formulaOf(parts);
}

math::Row formulaOf(const std::vector<ChainPart> &parts) {
  return written(parts, TermWriter(FormulaNotation()));
}

math::Row waitingFormulaOf(const WorkingLine &line) {
  math::Row symbols = formulaOf(symbolsOf(line));
  if (!isOneExpression(line))
    return symbols;
  return math::row(std::move(symbols), math::symbol('=', AtomClass::Rel), math::symbol('?', AtomClass::Ord));
}

} // namespace halfspace
