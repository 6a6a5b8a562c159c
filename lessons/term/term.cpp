#include "lessons/term/term.h"

#include "lessons/term/greek.h"
#include "lessons/term/operate.h"
#include "lessons/term/term_shape.h"
#include "lessons/term/written.h"
#include "lessons/text.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace halfspace {
namespace {

Term made(TermKind kind, std::vector<Term> parts, std::size_t columns = 0) {
  const auto node = std::make_shared<TermNode>();
  node->kind = kind;
  node->value = operate(kind, parts, columns);
  node->parts = std::move(parts);
  node->columns = columns;
  return Term(node);
}

/// A term and one more: a + b + c is one sum.
std::vector<Term> flat(TermKind kind, Term term, Term next) {
  const bool isOfKind = term->kind == kind && term->mark.empty();
  std::vector<Term> parts;
  parts.reserve(1 + (isOfKind ? term->parts.size() : 1));
  if (isOfKind)
    parts.assign(term->parts.begin(), term->parts.end());
  else
    parts.push_back(std::move(term));
  parts.push_back(std::move(next));
  return parts;
}

/// A number with other digits.
Term rewritten(const Term &number, WrittenNumber digits) {
  const auto node = std::make_shared<TermNode>(*number);
  node->parts = {std::move(digits.term)};
  node->isRounded = !digits.exact;
  return Term(node);
}

/// The entries of a list, their numbers all fractions or all decimals.
std::vector<Term> writtenAlike(std::vector<Term> entries) {
  std::vector<Term *> terms;
  std::vector<Real> numbers;
  for (Term &entry : entries)
    if (entry->kind == TermKind::Number) {
      terms.push_back(&entry);
      numbers.push_back(*numberOf(entry));
    }
  std::vector<WrittenNumber> digits = halfspace::writtenAlike(numbers);
  for (std::size_t i = 0; i < terms.size(); ++i)
    *terms[i] = rewritten(*terms[i], std::move(digits[i]));
  return entries;
}

/// The term without the minus sign that it is written with in front; null where it has none.
std::optional<Term> withoutSign(const Term &term) {
  const Term &looked = shown(term);
  if (looked->kind == TermKind::Negation)
    return looked->parts[0];
  if (looked->kind != TermKind::Quotient)
    return {};
  const auto top = withoutSign(looked->parts[0]);
  return top ? std::optional(*top / looked->parts[1]) : std::nullopt;
}

void collectNames(const Term &term, std::vector<Term> &names) {
  if (term->kind == TermKind::Name || term->kind == TermKind::Applied) {
    if (std::none_of(names.begin(), names.end(), [&](const Term &each) { return readAlike(each, term); }))
      names.push_back(term);
    return;
  }
  for (const Term &part : term->parts)
    collectNames(part, names);
}

} // namespace

Symbol letter(std::string letter, std::string subscript) {
  return {.letter = std::move(letter), .subscript = std::move(subscript)};
}
Symbol vectorLetter(std::string letter, std::string subscript) {
  return {.letter = std::move(letter), .subscript = std::move(subscript), .isVector = true};
}
Symbol perpLetter(std::string letter) {
  return {.letter = std::move(letter), .isVector = true, .isPerp = true};
}
Symbol word(std::string word) { return {.letter = std::move(word), .isWord = true}; }

std::string_view spelledLetter(std::string_view name) {
  const GreekLetter *greek =
      greekWhere([name](const GreekLetter &each) { return each.isSpelled && each.name.english == name; });
  return greek ? greek->letter : name;
}

std::string writtenName(std::string_view name) {
  const auto line = name.find('_');
  const std::string_view letters = name.substr(0, line);
  const std::string_view index = line == std::string_view::npos ? "" : name.substr(line + 1);
  const bool isIndexed = !index.empty() && index.find_first_not_of("0123456789") == std::string_view::npos &&
                         std::all_of(letters.begin(), letters.end(), isLetter);
  return std::string(isIndexed ? letters : name) + std::string(isIndexed ? index : "");
}

Symbol symbolOf(std::string_view entry) {
  const std::string name = writtenName(entry);
  const auto lastOther = name.find_last_not_of("0123456789");
  const bool isPlain = lastOther != std::string_view::npos && isLetter(name[lastOther]);
  const std::string letters(name.substr(0, isPlain ? lastOther + 1 : name.size()));
  const std::string_view spelled = spelledLetter(letters);
  Symbol symbol = letters.size() > 1 && spelled == letters ? word(letters) : letter(std::string(spelled));
  symbol.subscript = name.substr(letters.size());
  return symbol;
}

Term::Term(int number) : Term(Surd(number)) {}
Term::Term(const Rational &number) : Term(Surd(number)) {}
Term::Term(const Surd &number) : Term(halfspace::number(number)) {}

Term Term::marked(std::string mark) const {
  const auto node = std::make_shared<TermNode>(*m_node);
  node->mark = std::move(mark);
  return Term(node);
}

Term Term::standingFor(Term meaning) const {
  const auto node = std::make_shared<TermNode>(*m_node);
  node->origin = std::move(meaning);
  return Term(node);
}

Term number(const Real &value, std::optional<Term> origin, std::optional<CoordinateSource> source) {
  WrittenNumber digits = written(value);
  const auto node = std::make_shared<TermNode>();
  node->parts.push_back(std::move(digits.term));
  node->isRounded = !digits.exact;
  node->value = value;
  node->origin = std::move(origin);
  node->source = std::move(source);
  return Term(node);
}

Term name(Symbol symbol, std::optional<TermValue> value) {
  const auto node = std::make_shared<TermNode>();
  node->kind = TermKind::Name;
  node->symbol = std::move(symbol);
  node->value = std::move(value);
  return Term(node);
}

Term given(Symbol symbol, const Vec3<Rational> &value, std::string object, std::size_t coordinate) {
  const auto node = std::make_shared<TermNode>(*name(std::move(symbol), value));
  node->source = CoordinateSource{std::move(object), coordinate, std::nullopt};
  return Term(node);
}

Term unknown(std::string letter) {
  const auto node = std::make_shared<TermNode>();
  node->kind = TermKind::Unknown;
  node->value = Polynomial::unknown(letter);
  node->symbol = halfspace::letter(std::move(letter));
  return Term(node);
}

Term applied(Symbol function, Term argument, TermValue value) {
  const auto node = std::make_shared<TermNode>();
  node->kind = TermKind::Applied;
  node->symbol = std::move(function);
  node->parts.push_back(std::move(argument));
  node->value = std::move(value);
  return Term(node);
}

Term dot(Term a, Term b) { return made(TermKind::Dot, {std::move(a), std::move(b)}); }
Term cross(Term a, Term b) { return made(TermKind::Cross, {std::move(a), std::move(b)}); }
Term power(Term base, int exponent) { return made(TermKind::Power, {std::move(base), exponent}); }
Term root(Term square) { return made(TermKind::Root, {std::move(square)}); }
Term norm(Term vector) { return made(TermKind::Norm, {std::move(vector)}); }
Term list(std::vector<Term> entries) { return made(TermKind::List, writtenAlike(std::move(entries))); }
Term sum(std::vector<Term> summands) {
  return summands.empty() ? Term(0) : made(TermKind::Sum, std::move(summands));
}
Term product(std::vector<Term> factors) {
  return factors.empty() ? Term(1) : made(TermKind::Product, std::move(factors));
}

Term determinant(std::size_t columns, std::vector<Term> entries) {
  assert(columns > 0 && (entries.size() == columns * columns || entries.size() == columns));
  return made(TermKind::Determinant, std::move(entries), columns);
}
Term matrix(std::size_t columns, std::vector<Term> entries) {
  assert(columns > 0 && !entries.empty() && entries.size() % columns == 0);
  return made(TermKind::Matrix, std::move(entries), columns);
}
Term permuted(Term d1, Term m1, Term d2, Term m2) {
  return made(TermKind::Permuted, {std::move(d1), std::move(m1), std::move(d2), std::move(m2)});
}

Term operator-(Term term) { return made(TermKind::Negation, {std::move(term)}); }

Term operator+(Term a, Term b) { return sum(flat(TermKind::Sum, std::move(a), std::move(b))); }

Term operator-(Term a, Term b) { return std::move(a) + -std::move(b); }

Term operator*(Term a, Term b) { return product(flat(TermKind::Product, std::move(a), std::move(b))); }

Term operator/(Term a, Term b) { return made(TermKind::Quotient, {std::move(a), std::move(b)}); }

Term withParts(const Term &term, std::vector<Term> parts) {
  if (term->kind == TermKind::List)
    return list(std::move(parts));
  return made(term->kind, std::move(parts), term->columns);
}

const Real *numberOf(const Term &term) { return term->value ? term->value->number() : nullptr; }

std::vector<Term> namesIn(const Term &term) {
  std::vector<Term> names;
  collectNames(term, names);
  return names;
}

bool areInterchangeable(const Term &a, const Term &b) {
  if (&*a == &*b)
    return true;
  const bool haveAlikeOrigins = a->origin && b->origin ? readAlike(*a->origin, *b->origin)
                                                       : a->origin.has_value() == b->origin.has_value();
  return haveAlikeOrigins && a->kind == b->kind && a->digits == b->digits && a->symbol == b->symbol &&
         a->columns == b->columns && !a->isRounded && !b->isRounded && a->mark == b->mark &&
         a->source == b->source &&
         std::equal(a->parts.begin(), a->parts.end(), b->parts.begin(), b->parts.end(), areInterchangeable);
}

bool readAlike(const Term &a, const Term &b) {
  const auto magnitudeOfA = withoutSign(a);
  const auto magnitudeOfB = withoutSign(b);
  if (magnitudeOfA || magnitudeOfB)
    return magnitudeOfA && magnitudeOfB && readAlike(*magnitudeOfA, *magnitudeOfB);
  const Term &left = shown(a);
  const Term &right = shown(b);
  return left->kind == right->kind && left->digits == right->digits && left->symbol == right->symbol &&
         left->columns == right->columns &&
         std::equal(left->parts.begin(), left->parts.end(), right->parts.begin(), right->parts.end(),
                    readAlike);
}

} // namespace halfspace
