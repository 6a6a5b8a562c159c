// The figures of an answer, written as JSON.
#pragma once

#include "geometry/surd.h"
#include "geometry/vector.h"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace halfspace {

/// Writes the fields of an answer's result one behind the other: each figure as the nearest double and
/// exactly.
class Answer {
public:
  /// Writes behind what `text` holds.
  explicit Answer(std::string &text) : m_text(text) {}

  void word(std::string_view name, std::string_view word);
  void truth(std::string_view name, bool value);
  void index(std::string_view name, std::size_t value);
  void indices(std::string_view name, std::span<const std::size_t> values);
  void number(std::string_view name, const Rational &value);
  void number(std::string_view name, const Surd &value);
  void numbers(std::string_view name, std::span<const Rational> values);
  void numbers(std::string_view name, std::span<const Surd> values);
  void vector(std::string_view name, const Vec3<Rational> &value);
  void vectors(std::string_view name, std::span<const std::array<Surd, 3>> values);
  /// A field that has fields of its own: those written until `endGroup`.
  void beginGroup(std::string_view name);
  void endGroup();

private:
  void name(std::string_view name);

  std::string &m_text;
  bool m_first = true;
};

/// The text as JSON writes it, in quotes.
void appendQuoted(std::string &json, std::string_view text);

} // namespace halfspace
