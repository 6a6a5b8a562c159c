// Values that are made when somebody looks at them.
#pragma once

#include <functional>
#include <optional>
#include <utility>

namespace halfspace {

/// A value that is made when it is first looked at, and kept. What it is made from must live until then. Not
/// for several threads.
template <class T> class Lazy {
public:
  explicit Lazy(std::function<T()> make) : m_make(std::move(make)) {}

  [[nodiscard]] const T &operator*() const {
    if (!m_value) {
      m_value = m_make();
      m_make = nullptr;
    }
    return *m_value;
  }
  [[nodiscard]] const T *operator->() const { return &**this; }
  /// Whether somebody has looked at it.
  [[nodiscard]] bool isMade() const { return m_value.has_value(); }

private:
  mutable std::function<T()> m_make;
  mutable std::optional<T> m_value;
};

} // namespace halfspace
