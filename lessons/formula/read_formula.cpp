#include "lessons/formula/read_formula.h"

#include "lessons/reading/typed_number.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>
#include <utility>

namespace halfspace {
namespace {

constexpr std::array minusSigns{"-", "−", "–"};
constexpr std::array slashes{"/", "÷", "⁄"};
constexpr std::array dots{"·", "⋅"};
constexpr std::array powersOfTwoAndThree{std::pair("²", 2), std::pair("³", 3)};
constexpr std::array<std::string_view, 3> components{"x", "y", "z"};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

Formula made(FormulaKind kind, std::vector<Formula> parts, std::size_t at) {
  return {kind, {}, {}, std::move(parts), at};
}

/// A fraction of two numbers is a number itself.
Formula quotient(Formula above, Formula below, std::size_t at) {
  if (isPlainNumber(above) && isPlainNumber(below) && below.number != 0)
    return {FormulaKind::Number, above.number / below.number, {}, {}, at};
  return made(FormulaKind::Quotient, {std::move(above), std::move(below)}, at);
}

/// How many numbers a formula multiplies with one another at most: so many times as long as theirs its value
/// may be.
int weightOf(const Formula &formula) {
  if (formula.kind == FormulaKind::Power)
    return weightOf(formula.parts[0]) * static_cast<int>(formula.parts[1].number.words()->numerator);
  int weight = formula.parts.empty() ? 1 : 0;
  for (const Formula &part : formula.parts)
    weight += weightOf(part);
  return weight;
}

template <std::size_t count>
bool takeAny(FormulaReader &reader, const std::array<const char *, count> &signs) {
  return std::any_of(signs.begin(), signs.end(), [&](const char *sign) { return reader.take(sign); });
}

} // namespace

FormulaReader::FormulaReader(std::string_view text, char decimalMark, IsName isName)
    : m_text(text), m_decimalMark(decimalMark), m_isName(std::move(isName)) {
  if (text.size() > longestFormula)
    fail(words("This is too long."), longestFormula);
}

void FormulaReader::fail(const std::string &sentence, std::size_t at) {
  if (!m_fault)
    m_fault = FormulaFault{sentence, at};
  m_at = m_text.size();
}

Formula FormulaReader::failed(const std::string &sentence, std::size_t at) {
  fail(sentence, at);
  return {};
}

std::size_t FormulaReader::at() {
  while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\t'))
    ++m_at;
  return m_at;
}

bool FormulaReader::isAtEnd() { return at() == m_text.size(); }

bool FormulaReader::take(std::string_view sign) {
  if (!m_text.substr(at()).starts_with(sign))
    return false;
  m_at += sign.size();
  return true;
}

bool FormulaReader::takeSeparator() { return take(";") || take(","); }

/// Behind a name without hyphens that begins here.
std::size_t FormulaReader::endOfName(std::size_t begin) const {
  const auto isPart = [](char c) { return isLetter(c) || isDigit(c) || c == '_'; };
  std::size_t end = begin;
  while (end < m_text.size() && isLetter(m_text[end])) {
    while (end < m_text.size() && isPart(m_text[end]))
      ++end;
    if (end + 1 >= m_text.size() || m_text[end] != '.' || !isLetter(m_text[end + 1]))
      break;
    ++end;
  }
  return end;
}

std::string_view FormulaReader::takeName() {
  const std::size_t begin = at();
  m_at = endOfName(begin);
  for (std::size_t end = m_at; m_isName && end > begin && end + 1 < m_text.size() && m_text[end] == '-';) {
    const std::size_t next = end + 1;
    end = isDigit(m_text[next]) ? next + digitsAt(next).size() : endOfName(next);
    if (end == next)
      break;
    if (end + 1 < m_text.size() && m_text[end] == '.' && isLetter(m_text[end + 1]))
      end = endOfName(end + 1);
    if (m_isName(m_text.substr(begin, end - begin)))
      m_at = end;
  }
  return m_text.substr(begin, m_at - begin);
}

std::string_view FormulaReader::takeWord() {
  const std::size_t begin = at();
  while (m_at < m_text.size() &&
         (isLetter(m_text[m_at]) ||
          (m_at > begin && (isDigit(m_text[m_at]) || m_text[m_at] == '-' || m_text[m_at] == '_'))))
    ++m_at;
  return m_text.substr(begin, m_at - begin);
}

Formula FormulaReader::sum() {
  if (++m_depth > deepestFormula)
    return failed(words("This is nested too deep."), at());
  const std::size_t begin = at();
  Formula total = product();
  while (!m_fault) {
    if (take("+"))
      total = made(FormulaKind::Sum, {std::move(total), product()}, begin);
    else if (takeAny(*this, minusSigns))
      total = made(FormulaKind::Difference, {std::move(total), product()}, begin);
    else
      break;
  }
  --m_depth;
  return total;
}

bool FormulaReader::beginsFactor() {
  const char next = isAtEnd() ? '\0' : m_text[m_at];
  return isLetter(next) || isDigit(next) || next == '(';
}

Formula FormulaReader::product() {
  const std::size_t begin = at();
  Formula result = signedFactor();
  while (!m_fault) {
    const std::size_t next = at();
    if (takeAny(*this, slashes))
      result = quotient(std::move(result), signedFactor(), begin);
    else if (takeAny(*this, dots))
      result = made(FormulaKind::Dot, {std::move(result), signedFactor()}, begin);
    else if (take("×"))
      result = made(FormulaKind::Cross, {std::move(result), signedFactor()}, begin);
    else if (take("*"))
      result = made(FormulaKind::Product, {std::move(result), signedFactor()}, begin);
    else if (!beginsFactor())
      break;
    else if (isDigit(m_text[next]))
      return failed(words("A sign is missing before this number."), next);
    else
      result = made(FormulaKind::Product, {std::move(result), factor()}, begin);
  }
  return result;
}

Formula FormulaReader::signedFactor() {
  const std::size_t begin = at();
  if (takeAny(*this, minusSigns)) {
    if (++m_depth > deepestFormula)
      return failed(words("This is nested too deep."), begin);
    Formula inside = signedFactor();
    --m_depth;
    if (isPlainNumber(inside) && inside.number > 0)
      return {FormulaKind::Number, -inside.number, {}, {}, begin};
    return made(FormulaKind::Negative, {std::move(inside)}, begin);
  }
  take("+");
  return factor();
}

Formula FormulaReader::factor() {
  const std::size_t begin = at();
  Formula base = simple();
  const std::size_t sign = at();
  int exponent = -1;
  for (const auto &[raised, power] : powersOfTwoAndThree)
    if (exponent < 0 && take(raised))
      exponent = power;
  if (exponent < 0 && take("^")) {
    const std::string_view digits = digitsAt(at());
    if (digits.size() != 1 || digits.front() - '0' > highestPower)
      return failed(
          words("Here a whole number up to {most} is needed.", {{"most", std::to_string(highestPower)}}),
          sign);
    exponent = digits.front() - '0';
    m_at += 1;
  }
  const std::size_t next = at();
  if (exponent >= 0 && (take("^") || take("²") || take("³") || exponent * weightOf(base) > heaviestPower))
    return failed(words("This power is too high: write it in steps."), next);
  if (exponent < 0)
    return base;
  return made(FormulaKind::Power, {std::move(base), {FormulaKind::Number, exponent, {}, {}, begin}}, begin);
}

Formula FormulaReader::simple() {
  const std::size_t begin = at();
  if (take("("))
    return bracketed();
  if (isAtEnd())
    return failed(words("Something is missing at the end."), begin);
  if (isLetter(m_text[begin])) {
    const std::string_view name = takeName();
    const bool isFunction = name == shortestWord && !(m_isName && m_isName(name));
    if (isFunction && take("("))
      return made(FormulaKind::Shortest, {bracketed()}, begin);
    const auto dot = name.rfind('.');
    if (dot != std::string_view::npos)
      for (std::size_t axis = 0; axis < components.size(); ++axis)
        if (name.substr(dot + 1) == components[axis])
          return {FormulaKind::Component,
                  static_cast<int>(axis),
                  {},
                  {{FormulaKind::Name, {}, std::string(name.substr(0, dot)), {}, begin}},
                  begin};
    return {FormulaKind::Name, {}, std::string(name), {}, begin};
  }
  return number();
}

/// What follows an open bracket: a formula, or three.
Formula FormulaReader::bracketed() {
  const std::size_t begin = at() - 1;
  std::vector<Formula> parts{sum()};
  while (!m_fault && takeSeparator())
    parts.push_back(sum());
  const std::size_t end = at();
  if (!take(")"))
    return failed(words("A closing bracket is missing."), end);
  if (parts.size() == 1)
    return std::move(parts.front());
  if (parts.size() != 3)
    return failed(words("A point or a vector has three numbers."), begin);
  return made(FormulaKind::Triple, std::move(parts), begin);
}

std::string_view FormulaReader::digitsAt(std::size_t at) const {
  std::size_t end = at;
  while (end < m_text.size() && isDigit(m_text[end]))
    ++end;
  return m_text.substr(at, end - at);
}

Formula FormulaReader::number() {
  const std::size_t begin = at();
  const std::string_view whole = digitsAt(begin);
  if (whole.empty())
    return failed(words("This cannot be read."), begin);
  std::size_t end = begin + whole.size();
  if (end + 1 < m_text.size() && m_text[end] == m_decimalMark && isDigit(m_text[end + 1]))
    end += 1 + digitsAt(end + 1).size();
  else if (end < m_text.size() && m_text[end] == ' ') // 3 1/3
    if (const auto above = digitsAt(end + 1); !above.empty()) {
      const std::size_t slash = end + 1 + above.size();
      const auto below =
          slash < m_text.size() && m_text[slash] == '/' ? digitsAt(slash + 1) : std::string_view();
      if (!below.empty())
        end = slash + 1 + below.size();
    }
  const auto value = parseRational(plainSpelling(m_text.substr(begin, end - begin), m_decimalMark));
  if (!value)
    return failed(sentenceForNotRead(m_text.substr(begin, end - begin), m_decimalMark), begin);
  m_at = end;
  return {FormulaKind::Number, *value, {}, {}, begin};
}

namespace {

std::variant<Formula, FormulaFault> readWith(std::string_view text, char decimalMark, const IsName &isName) {
  FormulaReader reader(text, decimalMark, isName);
  Formula formula = reader.sum();
  if (!reader.isAtEnd())
    reader.fail(words("This cannot be read."), reader.at());
  if (reader.fault())
    return *reader.fault();
  return formula;
}

/// How strongly the outermost sign of a formula binds.
enum class Binding { Sum, Product, Sign, Power, Whole };

Binding bindingOf(const Formula &formula) {
  switch (formula.kind) {
  case FormulaKind::Sum:
  case FormulaKind::Difference:
    return Binding::Sum;
  case FormulaKind::Product:
  case FormulaKind::Quotient:
  case FormulaKind::Dot:
  case FormulaKind::Cross:
    return Binding::Product;
  case FormulaKind::Negative:
    return Binding::Sign;
  case FormulaKind::Power:
    return Binding::Power;
  case FormulaKind::Number:
    return !formula.number.isInteger() ? Binding::Product
           : formula.number.sign() < 0 ? Binding::Sign
                                       : Binding::Whole;
  default:
    return Binding::Whole;
  }
}

/// Puts the text of a formula together.
class FormulaText {
public:
  explicit FormulaText(char decimalMark) : m_separator(decimalMark == ',' ? "; " : ", ") {}

  std::string of(const Formula &formula) const {
    const std::vector<Formula> &parts = formula.parts;
    switch (formula.kind) {
    case FormulaKind::Number:
      return toText(formula.number);
    case FormulaKind::Name:
      return formula.name;
    case FormulaKind::Component:
      return within(parts[0], Binding::Whole) + "." +
             std::string(components.at(static_cast<std::size_t>(formula.number.words()->numerator)));
    case FormulaKind::Triple:
      return "(" + of(parts[0]) + m_separator + of(parts[1]) + m_separator + of(parts[2]) + ")";
    case FormulaKind::Negative:
      return "-" + within(parts[0], Binding::Sign);
    case FormulaKind::Sum:
      return of(parts[0]) + " + " + within(parts[1], Binding::Product);
    case FormulaKind::Difference:
      return of(parts[0]) + " - " + within(parts[1], Binding::Product);
    case FormulaKind::Quotient:
      return within(parts[0], Binding::Product) + "/" + within(parts[1], Binding::Sign);
    case FormulaKind::Power:
      return within(parts[0], Binding::Whole) + "^" + of(parts[1]);
    case FormulaKind::Dot:
      return within(parts[0], Binding::Product) + " · " + within(parts[1], Binding::Sign);
    case FormulaKind::Cross:
      return within(parts[0], Binding::Product) + " × " + within(parts[1], Binding::Sign);
    case FormulaKind::Shortest:
      return std::string(shortestWord) + "(" + of(parts[0]) + ")";
    case FormulaKind::Product:
      break;
    }
    return product(parts[0], parts[1]);
  }

private:
  std::string within(const Formula &part, Binding least) const {
    return bindingOf(part) < least ? "(" + of(part) + ")" : of(part);
  }

  /// 2k, 2 (A + B), k*3: a sign stands where the second would be read as something else without it.
  std::string product(const Formula &first, const Formula &second) const {
    const std::string a = within(first, Binding::Product);
    const std::string b = within(second, Binding::Sign);
    const bool needsSign = !isLetter(b.front()) && b.front() != '(';
    const bool standsTogether =
        first.kind == FormulaKind::Number && first.number.isInteger() && isLetter(b.front());
    return a + (needsSign ? "*" : standsTogether ? "" : " ") + b;
  }

  std::string m_separator;
};

} // namespace

std::variant<Formula, FormulaFault> readFormula(std::string_view text, char decimalMark,
                                                const IsName &isName) {
  auto read = readWith(text, decimalMark, isName);
  if (decimalMark != '.' &&
      std::holds_alternative<FormulaFault>(read)) // (1,2,3) is a point whatever the mark
    if (auto other = readWith(text, '.', isName); std::holds_alternative<Formula>(other))
      return other;
  return read;
}

std::string toText(const Formula &formula, char decimalMark) { return FormulaText(decimalMark).of(formula); }

} // namespace halfspace
