#include "tests/lessons/construction/precise.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace halfspace::test {
namespace {

/// One character for each command that means an operation; what is only there for the eye is taken away.
std::string condensed(const std::string &latex) {
  static const std::array<std::pair<std::string, std::string>, 18> replacements{{{"\\begin{vmatrix}", "|"},
                                                                                 {"\\end{vmatrix}", "!"},
                                                                                 {"\\\\ ", "@"},
                                                                                 {"\\left", ""},
                                                                                 {"\\right", ""},
                                                                                 {"\\bigl", ""},
                                                                                 {"\\bigr", ""},
                                                                                 {"\\,", ""},
                                                                                 {"\\ ", ""},
                                                                                 {"\\tfrac", "\\frac"},
                                                                                 {"\\lvert", "["},
                                                                                 {"\\rvert", "]"},
                                                                                 {"\\cdot", "*"},
                                                                                 {"\\times", "#"},
                                                                                 {"\\approx", "~"},
                                                                                 {"\\neq", "?"},
                                                                                 {",\\quad", ";"},
                                                                                 {" ", ""}}};
  std::string text = latex;
  for (const auto &[from, to] : replacements)
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  return text;
}

class Reader {
public:
  Reader(std::string text, const Names &names) : m_text(std::move(text)) {
    for (const auto &[name, value] : names)
      m_names.emplace_back(condensed(name), value->numbers);
    // `\vec n_{f}` before `\vec n`
    std::stable_sort(m_names.begin(), m_names.end(),
                     [](const auto &a, const auto &b) { return a.first.size() > b.first.size(); });
  }

  Numbers all() {
    Numbers value = sum();
    if (m_at != m_text.size())
      complain();
    return value;
  }

private:
  [[noreturn]] void complain() const {
    throw std::invalid_argument("no formula from “" + m_text.substr(m_at) + "” on: " + m_text);
  }
  bool take(std::string_view expected) {
    if (m_text.compare(m_at, expected.size(), expected) != 0)
      return false;
    m_at += expected.size();
    return true;
  }
  void require(std::string_view expected) {
    if (!take(expected))
      complain();
  }

  Numbers combine(const Numbers &a, const Numbers &b, int sign) const {
    if (a.size() != b.size())
      complain();
    Numbers result = a;
    for (std::size_t i = 0; i < a.size(); ++i)
      result[i] += sign * b[i];
    return result;
  }
  /// A dot product of two vectors, the permuted inner product of two lines, else a product.
  Numbers dotted(const Numbers &a, const Numbers &b) const {
    if (a.size() == 6 && b.size() == 6)
      return {a[0] * b[3] + a[1] * b[4] + a[2] * b[5] + a[3] * b[0] + a[4] * b[1] + a[5] * b[2]};
    if (a.size() == 3 && b.size() == 3)
      return {a[0] * b[0] + a[1] * b[1] + a[2] * b[2]};
    return scaled(a, b);
  }
  Numbers scaled(const Numbers &a, const Numbers &b) const {
    if (a.size() != 1 && b.size() != 1)
      complain();
    Numbers result = a.size() == 1 ? b : a;
    for (Precise &component : result)
      component *= a.size() == 1 ? a[0] : b[0];
    return result;
  }
  Numbers divided(const Numbers &a, const Numbers &b) const {
    if (b.size() != 1 || b[0] == 0)
      complain();
    return scaled({1 / b[0]}, a);
  }
  Numbers crossed(const Numbers &a, const Numbers &b) const {
    if (a.size() != 3 || b.size() != 3)
      complain();
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  Numbers sum() {
    Numbers value = take("-") ? scaled({Precise(-1)}, product()) : product();
    while (true)
      if (take("+"))
        value = combine(value, product(), 1);
      else if (take("-"))
        value = combine(value, product(), -1);
      else
        return value;
  }

  Numbers product() {
    Numbers value = power();
    while (m_at < m_text.size() && std::string_view("+-,)]}&@!").find(m_text[m_at]) == std::string_view::npos)
      if (take("*"))
        value = dotted(value, power());
      else if (take("#"))
        value = crossed(value, power());
      else if (take("/"))
        value = divided(value, power());
      else
        value = scaled(value, power());
    return value;
  }

  Numbers power() {
    Numbers value = primary();
    if (!take("^"))
      return value;
    const Numbers exponent = take("{") ? braced() : Numbers{digit()};
    // As in TeX: a second exponent would be an error.
    if (value.size() != 1 || exponent.size() != 1 || take("^"))
      complain();
    return {mp::pow(value[0], exponent[0])};
  }

  /// What follows an open brace.
  Numbers braced() {
    Numbers value = sum();
    require("}");
    return value;
  }

  /// As in TeX: without braces the exponent is one character.
  Precise digit() {
    if (m_at == m_text.size() || m_text[m_at] < '0' || m_text[m_at] > '9')
      complain();
    return m_text[m_at++] - '0';
  }

  Precise number() {
    const auto end = std::min(m_text.find_first_not_of("0123456789.", m_at), m_text.size());
    if (end == m_at)
      complain();
    const Precise value(m_text.substr(m_at, end - m_at));
    m_at = end;
    return value;
  }

  Numbers primary() {
    for (const auto &[name, value] : m_names)
      if (take(name))
        return value;
    if (take("\\frac{")) {
      const Numbers top = braced();
      require("{");
      const Numbers bottom = braced();
      if (m_text.compare(m_at, 1, "^") == 0)
        complain(); // the exponent would seem to stick to the numerator
      return divided(top, bottom);
    }
    if (take("{"))
      return braced();
    if (take("|"))
      return determinant();
    if (take("\\sqrt{"))
      return {mp::sqrt(braced().at(0))};
    if (take("[")) {
      const Numbers inside = sum();
      require("]");
      return {mp::sqrt(dotted(inside, inside)[0])};
    }
    for (const bool isLargest : {true, false})
      if (take(isLargest ? "\\operatorname{max}(" : "\\operatorname{min}(")) {
        const Numbers all = list();
        return {isLargest ? *std::max_element(all.begin(), all.end())
                          : *std::min_element(all.begin(), all.end())};
      }
    if (take("\\operatorname{floor}("))
      return {mp::floor(list().at(0))};
    return take("(") ? list() : Numbers{number()};
  }

  Numbers list() {
    Numbers values = sum();
    while (take(",")) {
      const Numbers next = sum();
      values.insert(values.end(), next.begin(), next.end());
    }
    require(")");
    return values;
  }

  /// Row by row up to its end; of vectors in one row as of the columns that they are, which comes to the same
  /// as rows.
  Numbers determinant() {
    Numbers entries = sum();
    std::size_t rows = 1;
    while (!take("!")) {
      if (take("@"))
        ++rows;
      else
        require("&");
      const Numbers next = sum();
      entries.insert(entries.end(), next.begin(), next.end());
    }
    const std::size_t size = entries.size() == 4 ? 2 : 3;
    if (entries.size() != size * size || (rows != size && rows != 1))
      complain();
    const auto at = [&](std::size_t row, std::size_t column) { return entries[row * size + column]; };
    if (size == 2)
      return {at(0, 0) * at(1, 1) - at(0, 1) * at(1, 0)};
    Precise sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      sum += at(0, i) * (at(1, (i + 1) % 3) * at(2, (i + 2) % 3) - at(1, (i + 2) % 3) * at(2, (i + 1) % 3));
    return {sum};
  }

  std::string m_text;
  std::size_t m_at = 0;
  std::vector<std::pair<std::string, Numbers>> m_names;
};

Precise precise(const Rational &number) {
  return Precise(toText(number.numerator())) / Precise(toText(number.denominator()));
}

} // namespace

Quantity quantity(Numbers numbers) {
  return std::make_shared<const Components>(Components{std::move(numbers)});
}

Quantity quantity(const Rational &number) { return quantity(Numbers{precise(number)}); }

Quantity quantity(const ExactVec3 &vector) {
  return quantity(Numbers{precise(vector.x), precise(vector.y), precise(vector.z)});
}

Quantity quantity(const Surd &number) {
  return quantity(Numbers{precise(number.rationalPart()) +
                          precise(number.rootFactor()) * mp::sqrt(precise(number.radicand()))});
}

Quantity quantityOverRoot(const Rational &number, const Rational &square) {
  return quantity(Numbers{precise(number) / mp::sqrt(precise(square))});
}

Quantity quantityOverRoot(const ExactVec3 &vector, const Rational &square) {
  return together({quantityOverRoot(vector.x, square), quantityOverRoot(vector.y, square),
                   quantityOverRoot(vector.z, square)});
}

Quantity together(const std::vector<Quantity> &quantities) {
  Numbers all;
  for (const Quantity &each : quantities)
    all.insert(all.end(), each->numbers.begin(), each->numbers.end());
  return quantity(std::move(all));
}

std::vector<std::vector<Side>> chainsOf(const std::string &latex) {
  std::vector<std::vector<Side>> chains{{Side{}}};
  for (const char c : condensed(latex))
    if (c == ';')
      chains.push_back({Side{}});
    else if (std::string_view("=~<>?").find(c) != std::string_view::npos)
      chains.back().push_back({c, ""});
    else
      chains.back().back().latex += c;
  return chains;
}

Numbers calculate(const std::string &latex, const Names &names) {
  return Reader(condensed(latex), names).all();
}

} // namespace halfspace::test
