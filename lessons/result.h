// What a reader answers when it cannot read: a sentence for the user, and where to look.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace halfspace {

struct Problem {
  std::string sentence; ///< what is wrong and what to do, for a person
  std::string file;     ///< empty when it was no file
  int line = 0;         ///< counted from 1; 0 when no line can be told
  std::string field;    ///< the part of the file, as `scene[1].n`; may be empty

  /// `file:line: field: sentence`, leaving out what is not known.
  [[nodiscard]] std::string text() const {
    std::string place = file;
    if (line > 0)
      place += ":" + std::to_string(line);
    if (!field.empty())
      place += (place.empty() ? "" : ": ") + field;
    return place.empty() ? sentence : place + ": " + sentence;
  }
};

/// A value or the problem that kept it from being made.
template <class T> class [[nodiscard]] Result {
public:
  Result(T value) : m_content(std::move(value)) {}           // NOLINT(google-explicit-constructor)
  Result(Problem problem) : m_content(std::move(problem)) {} // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return std::holds_alternative<T>(m_content); }
  [[nodiscard]] T &operator*() { return std::get<T>(m_content); }
  [[nodiscard]] const T &operator*() const { return std::get<T>(m_content); }
  [[nodiscard]] T *operator->() { return &std::get<T>(m_content); }
  [[nodiscard]] const T *operator->() const { return &std::get<T>(m_content); }
  [[nodiscard]] const Problem &problem() const { return std::get<Problem>(m_content); }

private:
  std::variant<T, Problem> m_content;
};

} // namespace halfspace
