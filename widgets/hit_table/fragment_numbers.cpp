#include "widgets/hit_table/fragment_numbers.h"

#include "lessons/term/plain_text.h"
#include "widgets/flight/short_decimal.h"
#include "widgets/formula/term_formula.h"

#include <algorithm>
#include <string_view>

namespace halfspace {
namespace {

/// So many letters stand exactly in a list: 0.6875, 12/175.
constexpr std::size_t longestExact = 6;

/// As wide as they get.
WrittenNumber widestNumber() { return written(Rational(-88, 875)); }

bool isLong(const WrittenNumber &number) {
  const std::string text = plainText(number.term);
  return !number.exact ||
         text.size() - (text.starts_with("−") ? std::string_view("−").size() : 0) > longestExact;
}

/// As it stands among words: a fraction has a slash, and its digits are as large as others.
math::Row formulaOfNumber(const WrittenNumber &number) { return formulaOf(number.term, Fractions::Flat); }

/// In a column whose head says that its numbers are rounded.
WrittenNumber roundedInColumn(const Rational &number) {
  const int places = abs(number) < 10 ? 2 : 1;
  return shortDecimal(number, places);
}

math::Row roundedHead(char32_t letter) {
  return math::row(math::letter(letter), math::symbol(U'≈', math::AtomClass::Rel));
}

/// The number of a row in a column; null where none is shown.
const Rational *numberIn(const FragmentRow &row, std::size_t column, LiveValues values) {
  if (!row.crossing.at || hidesNumbers(row, values))
    return nullptr;
  const Crossing::Parameters &at = *row.crossing.at;
  return std::array{&at.t, &at.s, &at.tTriangle}[column];
}

} // namespace

FragmentNumbers::FragmentNumbers(const Typesetter &typesetter)
    : m_typesetter(typesetter), m_heads{typesetter.picture(math::row(math::letter(U'λ'))),
                                        typesetter.picture(math::row(math::letter('s'))),
                                        typesetter.picture(math::row(math::letter('t')))},
      m_roundedHeads{typesetter.picture(roundedHead(U'λ')), typesetter.picture(roundedHead('s')),
                     typesetter.picture(roundedHead('t'))},
      m_unknown(typesetter.picture(math::row(math::symbol('?')))),
      m_none(typesetter.picture(math::row(math::symbol(U'–')))),
      m_widest(typesetter.picture(formulaOfNumber(widestNumber()))) {}

void FragmentNumbers::write(const FragmentRows &shown, LiveValues values) {
  m_rows.clear();
  for (const FragmentRow &row : shown.rows)
    m_rows.emplace_back().fill(placeholderOf(row, values));
  for (std::size_t column = 0; column < m_areRounded.size(); ++column)
    writeColumn(column, shown, values);
}

void FragmentNumbers::writeColumn(std::size_t column, const FragmentRows &shown, LiveValues values) {
  std::vector<Real> numbers;
  for (const FragmentRow &row : shown.rows)
    if (const Rational *number = numberIn(row, column, values))
      numbers.emplace_back(Surd(*number));
  const std::vector<WrittenNumber> alike = writtenAlike(numbers);
  const bool isRounded = std::any_of(alike.begin(), alike.end(), isLong);
  m_areRounded[column] = isRounded;
  auto next = alike.begin();
  for (std::size_t i = 0; i < shown.rows.size(); ++i)
    if (const Rational *number = numberIn(shown.rows[i], column, values)) {
      const WrittenNumber &exact = *next++;
      m_rows[i][column] = m_typesetter.picture(formulaOfNumber(isRounded ? roundedInColumn(*number) : exact));
    }
}

Typesetter::Picture FragmentNumbers::placeholderOf(const FragmentRow &row, LiveValues values) const {
  if (values == LiveValues::Hidden)
    return m_unknown;
  return row.standing == Standing::NotAsked ? nullptr : m_none;
}

const MathPicture &FragmentNumbers::head(std::size_t column) const {
  return *(m_areRounded.at(column) ? m_roundedHeads : m_heads).at(column);
}

} // namespace halfspace
