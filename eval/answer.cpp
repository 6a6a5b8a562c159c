#include "eval/answer.h"

#include <charconv>
#include <cmath>

namespace halfspace {
namespace {

template <class Number> void appendNumber(std::string &text, Number value) {
  std::array<char, 32> digits; // more than the shortest spelling of any double or index has
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

template <class Number> void appendDouble(std::string &text, const Number &value) {
  const double nearest = toDouble(value);
  if (std::isfinite(nearest))
    appendNumber(text, nearest);
  else
    text += "null";
}

void appendExact(std::string &text, const Rational &value) {
  text += '"';
  text += toText(value);
  text += '"';
}

void appendExact(std::string &text, const Surd &value) {
  const auto exact = toText(value);
  if (!exact) {
    text += "null";
    return;
  }
  text += '"';
  text += *exact;
  text += '"';
}

/// Each value by `append`, with commas between.
template <class Values, class Append>
void appendList(std::string &text, const Values &values, Append append) {
  text += '[';
  bool first = true;
  for (const auto &value : values) {
    if (!first)
      text += ',';
    first = false;
    append(text, value);
  }
  text += ']';
}

/// A figure of one number.
template <class Number> void appendFigure(std::string &text, const Number &value) {
  text += "{\"value\":";
  appendDouble(text, value);
  text += ",\"exact\":";
  appendExact(text, value);
  text += '}';
}

/// A figure of a list of numbers.
template <class Number> void appendListFigure(std::string &text, std::span<const Number> values) {
  const auto exact = [](std::string &to, const Number &value) { appendExact(to, value); };
  text += "{\"value\":";
  appendList(text, values, appendDouble<Number>);
  text += ",\"exact\":";
  appendList(text, values, exact);
  text += '}';
}

} // namespace

void appendQuoted(std::string &json, std::string_view text) {
  constexpr std::string_view hexDigits = "0123456789abcdef";
  json += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      json += '\\';
      json += c;
    } else if (byte < 0x20) {
      json += "\\u00";
      json += hexDigits[byte / 16];
      json += hexDigits[byte % 16];
    } else {
      json += c;
    }
  }
  json += '"';
}

void Answer::name(std::string_view name) {
  if (!m_first)
    m_text += ',';
  m_first = false;
  m_text += '"';
  m_text += name;
  m_text += "\":";
}

void Answer::word(std::string_view name, std::string_view word) {
  this->name(name);
  appendQuoted(m_text, word);
}

void Answer::truth(std::string_view name, bool value) {
  this->name(name);
  m_text += value ? "true" : "false";
}

void Answer::index(std::string_view name, std::size_t value) {
  this->name(name);
  appendNumber(m_text, value);
}

void Answer::indices(std::string_view name, std::span<const std::size_t> values) {
  this->name(name);
  appendList(m_text, values, appendNumber<std::size_t>);
}

void Answer::number(std::string_view name, const Rational &value) {
  this->name(name);
  appendFigure(m_text, value);
}

void Answer::number(std::string_view name, const Surd &value) {
  this->name(name);
  appendFigure(m_text, value);
}

void Answer::numbers(std::string_view name, std::span<const Rational> values) {
  this->name(name);
  appendListFigure(m_text, values);
}

void Answer::numbers(std::string_view name, std::span<const Surd> values) {
  this->name(name);
  appendListFigure(m_text, values);
}

void Answer::vector(std::string_view name, const Vec3<Rational> &value) {
  numbers(name, std::array<Rational, 3>{value.x, value.y, value.z});
}

void Answer::vectors(std::string_view name, std::span<const std::array<Surd, 3>> values) {
  this->name(name);
  appendList(m_text, values, [](std::string &text, const std::array<Surd, 3> &value) {
    appendListFigure(text, std::span<const Surd>(value));
  });
}

void Answer::beginGroup(std::string_view name) {
  this->name(name);
  m_text += '{';
  m_first = true;
}

void Answer::endGroup() {
  m_text += '}';
  m_first = false;
}

} // namespace halfspace
