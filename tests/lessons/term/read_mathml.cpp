#include "tests/lessons/term/read_mathml.h"

#include "lessons/text.h"

#include <boost/property_tree/xml_parser.hpp>

#include <array>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

namespace halfspace::test {
namespace {

using Tree = boost::property_tree::ptree;

constexpr std::array<std::string_view, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
constexpr std::array<std::string_view, 10> lowered{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};

std::string inForm(const std::array<std::string_view, 10> &forms, std::string digits) {
  for (std::size_t i = 0; i < forms.size(); ++i)
    digits = replacedAll(std::move(digits), std::to_string(i), forms.at(i));
  return replacedAll(std::move(digits), "−", "⁻");
}

bool areDigits(const std::string &text) { return text.find_first_not_of("0123456789") == std::string::npos; }

std::string plain(const std::string &name, const Tree &element);

/// The elements in another; attributes are none.
std::vector<std::pair<std::string, Tree>> childrenOf(const Tree &element) {
  std::vector<std::pair<std::string, Tree>> children;
  for (const auto &[name, child] : element)
    if (name != "<xmlattr>")
      children.emplace_back(name, child);
  return children;
}

std::string plainChildren(const Tree &element) {
  std::string text;
  for (const auto &[name, child] : childrenOf(element))
    text += plain(name, child);
  return text;
}

std::string rows(const Tree &table) {
  std::string text;
  for (const auto &[name, row] : childrenOf(table))
    text += (text.empty() ? "" : ";") + plainChildren(row);
  return text;
}

/// Three elements of which the second is a table, or a row as any other.
std::string row(const Tree &element) {
  const auto parts = childrenOf(element);
  if (parts.size() != 3 || parts[1].first != "mtable")
    return plainChildren(element);
  return (parts[0].second.data() == "|" ? "det[" : "[") + rows(parts[1].second) + "]";
}

std::string index(const std::string &name, const Tree &element) {
  if (name == "mrow") {
    std::string text;
    for (const auto &[part, child] : childrenOf(element))
      text += index(part, child);
    return text;
  }
  const std::string text = plain(name, element);
  return name == "mn" ? inForm(lowered, text) : "_" + text;
}

std::string exponent(const std::string &name, const Tree &element) {
  const std::string text = plain(name, element);
  if (name == "mo") // a prime, or ⊥
    return text;
  return areDigits(replacedAll(text, "−", "")) ? inForm(raised, text) : "^" + text;
}

std::string plain(const std::string &name, const Tree &element) {
  const auto children = childrenOf(element);
  const auto child = [&](std::size_t i) { return plain(children.at(i).first, children.at(i).second); };
  if (name == "mi" || name == "mn" || name == "mo")
    return element.data();
  if (name == "mfrac")
    return child(0) + "/" + child(1);
  if (name == "msqrt")
    return "√" + plainChildren(element);
  if (name == "mover")
    return child(0);
  if (name == "msub")
    return child(0) + index(children.at(1).first, children.at(1).second);
  if (name == "msup")
    return child(0) + exponent(children.at(1).first, children.at(1).second);
  return name == "mrow" ? row(element) : plainChildren(element);
}

} // namespace

std::string plainMathMl(const std::string &math) {
  Tree document;
  std::istringstream stream(math);
  boost::property_tree::read_xml(stream, document);
  return withoutGrouping(plainChildren(document));
}

std::string withoutGrouping(std::string text) {
  constexpr std::array<std::string_view, 5> left{" ", "(", ")", "\u2061", "\u2062"}; // and what nobody sees
  for (const std::string_view each : left)
    text = replacedAll(std::move(text), each, "");
  return text;
}

} // namespace halfspace::test
