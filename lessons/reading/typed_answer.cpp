#include "lessons/reading/typed_answer.h"

#include "lessons/reading/typed_number.h"
#include "lessons/text.h"

#include <algorithm>
#include <array>
#include <string>

namespace halfspace {
namespace {

/// Stands for a root's sign among the letters.
constexpr char rootSign = '\x01';

/// One character for each sign of an answer.
std::string condensed(std::string_view typed) {
  std::string text = plainSigns(typed);
  const std::array<std::pair<std::string_view, std::string_view>, 6> signs{
      {{" ", ""}, {"·", "*"}, {"⋅", "*"}, {"×", "*"}, {"√", "\x01"}, {"sqrt", "\x01"}}};
  for (const auto &[from, to] : signs)
    text = replacedAll(std::move(text), from, to);
  return text;
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Reads sums and products of numbers, roots and letters.
class AnswerReader {
public:
  explicit AnswerReader(std::string_view text) : m_text(text) {}

  std::optional<Polynomial> read() {
    Polynomial value = sum();
    return m_failed || m_at != m_text.size() ? std::nullopt : std::optional(std::move(value));
  }

private:
  bool take(char c) {
    if (m_at == m_text.size() || m_text[m_at] != c)
      return false;
    ++m_at;
    return true;
  }

  Polynomial fail() {
    m_failed = true;
    m_at = m_text.size(); // nothing behind what cannot be read
    return {};
  }

  Polynomial sum() {
    Polynomial total = product();
    while (m_at < m_text.size()) {
      if (take('+'))
        total = total + product();
      else if (take('-'))
        total = total - product();
      else
        break;
    }
    return total;
  }

  Polynomial product() {
    Polynomial result = factor();
    while (m_at < m_text.size() && std::string_view("+-)").find(m_text[m_at]) == std::string_view::npos) {
      const bool divides = take('/');
      if (!divides)
        take('*');
      const Polynomial next = factor();
      const Real *divisor = next.number();
      const auto inverse = divides && divisor ? quotient(Real(1), *divisor) : std::nullopt;
      if (divides && !inverse)
        return fail();
      result = result * (divides ? Polynomial(*inverse) : next);
      if (result.summands().size() > mostSummands)
        return fail();
    }
    return result;
  }

  Polynomial factor() {
    if (take('-'))
      return -factor();
    if (take('+'))
      return factor();
    if (take('('))
      return bracketed();
    if (take(rootSign))
      return root();
    if (m_at < m_text.size() && isLetter(m_text[m_at]))
      return Polynomial::unknown(std::string(1, m_text[m_at++]));
    return number();
  }

  /// What follows an open bracket.
  Polynomial bracketed() {
    Polynomial inside = sum();
    return take(')') ? inside : fail();
  }

  /// What follows a root's sign.
  Polynomial root() {
    const Polynomial square = take('(') ? bracketed() : number();
    const Real *under = square.number();
    const auto root = under ? squareRoot(*under) : std::nullopt;
    return root ? Polynomial(*root) : fail();
  }

  Polynomial number() {
    const auto end = std::min(m_text.find_first_not_of("0123456789.", m_at), m_text.size());
    const auto value = parseRational(plainSpelling(m_text.substr(m_at, end - m_at)));
    m_at = end;
    return value ? Polynomial(Real(*value)) : fail();
  }

  std::string_view m_text;
  std::size_t m_at = 0;
  bool m_failed = false;
};

/// 10 3: a mixed number without its fraction, or a slip.
bool hasNumbersApart(std::string_view text) {
  for (std::size_t space = text.find(' '); space != std::string_view::npos;
       space = text.find(' ', space + 1)) {
    const std::size_t next = text.find_first_not_of(' ', space);
    if (space > 0 && isDigit(text[space - 1]) && next != std::string_view::npos && isDigit(text[next]))
      return true;
  }
  return false;
}

std::optional<Polynomial> readSide(std::string_view text) {
  if (hasNumbersApart(text))
    return {};
  const std::string signs = condensed(text);
  const auto value = AnswerReader(signs).read();
  return value && isExact(*value) ? value : std::nullopt;
}

/// Half a unit in the last place of a decimal; nothing for what is no decimal, or too short to be rounded.
std::optional<Rational> roundingOf(const std::string &text) {
  const auto point = text.find('.');
  const bool isDecimal =
      text.find_first_not_of("0123456789.", text.starts_with('-') ? 1 : 0) == std::string::npos;
  if (point == std::string::npos || !isDecimal)
    return {};
  const auto first = text.find_first_of("123456789");
  const auto digits = first == std::string::npos ? 0 : text.size() - first - (first < point ? 1 : 0);
  if (digits < fewestDigits)
    return {};
  const auto places = static_cast<int>(text.size() - point - 1);
  return powerOfTen(-places) / 2;
}

std::optional<TypedEntry> readEntry(std::string_view piece) {
  if (const auto mixed = parseMixed(piece))
    return TypedEntry{Real(*mixed)};
  const auto value = readSide(piece);
  return value ? std::optional(TypedEntry{*value, roundingOf(condensed(piece))}) : std::nullopt;
}

/// The pieces of a list, without its parentheses.
std::vector<std::string_view> piecesOf(std::string_view text) {
  text = trimmed(text);
  const char separator = text.find(';') == std::string_view::npos ? ',' : ';';
  if (text.find(separator) != std::string_view::npos && text.starts_with('(') && text.ends_with(')'))
    text = text.substr(1, text.size() - 2);
  std::vector<std::string_view> pieces;
  for (auto end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
    pieces.push_back(trimmed(text.substr(0, end)));
    text.remove_prefix(end + 1);
  }
  pieces.push_back(trimmed(text));
  return pieces;
}

/// Where bounds leave it open both agree in far more digits than anybody types.
bool mayBeEqual(const Polynomial &typed, const Polynomial &number) {
  return areEqual(typed, number).value_or(true);
}

std::optional<TypedAnswer> readEquation(std::string_view text, std::size_t sign) {
  const auto left = readSide(text.substr(0, sign));
  const auto right = readSide(text.substr(sign + 1));
  return left && right ? std::optional(TypedAnswer{{{*left - *right}}, false, true}) : std::nullopt;
}

bool roundsTo(const TypedEntry &typed, const Polynomial &number) {
  const Real *rounded = typed.value.number();
  const Real *exact = number.number();
  if (!typed.rounding || !rounded || !exact)
    return false;
  const Real apart = *exact - *rounded;
  return sign(apart + Real(*typed.rounding)).value_or(-1) >= 0 &&
         sign(apart - Real(*typed.rounding)).value_or(1) <= 0;
}

/// Points for decimal marks: those that a digit follows, for in `1, 2` one parts two numbers.
std::string withPoints(std::string_view typed, char decimalMark) {
  std::string text(typed);
  for (std::size_t i = 0; i + 1 < text.size(); ++i)
    if (text[i] == decimalMark && isDigit(text[i + 1]))
      text[i] = '.';
  return text;
}

std::optional<TypedAnswer> readList(const std::vector<std::string_view> &pieces) {
  TypedAnswer answer;
  for (const std::string_view piece : pieces) {
    const auto entry = readEntry(piece);
    if (!entry)
      return {};
    answer.entries.push_back(*entry);
  }
  answer.isList = answer.entries.size() > 1;
  return answer;
}

/// The numbers between spaces, without the parentheses around all; none where something else stands there.
std::vector<std::string_view> numbersBetweenSpaces(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('(') && text.ends_with(')'))
    text = trimmed(text.substr(1, text.size() - 2));
  std::vector<std::string_view> pieces;
  while (!text.empty()) {
    const std::string_view piece = text.substr(0, text.find(' '));
    if (!parseRational(plainSpelling(piece)))
      return {};
    pieces.push_back(piece);
    text = trimmed(text.substr(piece.size()));
  }
  return pieces;
}

std::optional<TypedAnswer> readPlain(std::string_view text) {
  if (const auto sign = text.find('='); sign != std::string_view::npos)
    return readEquation(text, sign);
  return readList(piecesOf(text));
}

} // namespace

TermValue TypedAnswer::value() const {
  if (!isList)
    return entries.front().value;
  std::vector<Polynomial> values;
  for (const TypedEntry &entry : entries)
    values.push_back(entry.value);
  return TermValue::list(std::move(values));
}

bool TypedAnswer::means(const TermValue &value) const {
  return isList == value.isList &&
         std::equal(entries.begin(), entries.end(), value.entries.begin(), value.entries.end(),
                    [](const TypedEntry &typed, const Polynomial &entry) {
                      return mayBeEqual(typed.value, entry) || roundsTo(typed, entry);
                    });
}

bool TypedAnswer::meansEquation(const TermValue &left) const {
  const Polynomial &typed = entries.front().value;
  const Polynomial &meant = left.entries.front();
  if (isList || left.isList || !typed.hasUnknowns() || !meant.hasUnknowns())
    return false;
  // Multiples of each other: crosswise, their leading factors make them equal.
  return areEqual(typed * meant.summands().front().factor, meant * typed.summands().front().factor) == true;
}

std::optional<TypedAnswer> readAnswer(std::string_view text, char decimalMark, std::size_t numbersAskedFor) {
  if (text.size() > longestAnswer)
    return {};
  const std::string pointed = withPoints(text, decimalMark);
  if (numbersAskedFor > 1)
    if (const auto apart = numbersBetweenSpaces(pointed); apart.size() == numbersAskedFor)
      return readList(apart);
  if (decimalMark != '.')
    if (auto answer = readPlain(pointed))
      return answer;
  return readPlain(text); // (1,2,3) is a list whatever the mark
}

} // namespace halfspace
