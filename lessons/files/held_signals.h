// Signals that would end the program, held back for a moment.
#pragma once

#include <array>
#include <csignal>

namespace halfspace {

/// While it lives, SIGINT, SIGTERM and SIGHUP wait; then they do what they would have done. All threads hold
/// them, so this is no mask of one. One at a time: others that live meanwhile hold nothing.
class HeldSignals {
public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals &) = delete;
  HeldSignals &operator=(const HeldSignals &) = delete;

  /// Whether one has come and waits.
  [[nodiscard]] static bool isOneWaiting();

private:
  static constexpr std::array held{SIGINT, SIGTERM, SIGHUP};
  bool m_isHolding = false;
  std::array<struct sigaction, held.size()> m_before{};
};

} // namespace halfspace
