// What somebody meets who may not do everything.
#pragma once

#include <unistd.h>

namespace halfspace::test {

inline constexpr unsigned nobody = 65534;

/// Lays root's rights down for a while. Whoever is not root has none to lay down.
class AsNobody {
public:
  AsNobody() {
    if (m_isRoot)
      m_failed = setegid(nobody) != 0 || seteuid(nobody) != 0;
  }
  ~AsNobody() {
    if (m_isRoot)
      m_failed = seteuid(0) != 0 || setegid(0) != 0;
  }
  AsNobody(const AsNobody &) = delete;
  AsNobody &operator=(const AsNobody &) = delete;

  [[nodiscard]] bool failed() const { return m_failed; }

private:
  bool m_isRoot = geteuid() == 0;
  bool m_failed = false;
};

} // namespace halfspace::test
