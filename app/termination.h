// The operating system's wish that the program ends.
#pragma once

#include <functional>
#include <memory>

namespace halfspace {

/// While it lives, SIGTERM, SIGINT and SIGHUP do not end the program at once: `end` is called from the event
/// loop instead, with the signal's number. One at a time; requires the application object.
class Termination {
public:
  using End = std::function<void(int signal)>;

  /// Where the event loop does not come to it within `patience` milliseconds, as during a frame that takes
  /// long, `endWhileBusy` is called instead, from a thread of its own.
  Termination(End end, End endWhileBusy, int patience = usualPatience);
  /// Longer than a frame of a scene that one can work with.
  static constexpr int usualPatience = 2000;
  ~Termination();
  Termination(const Termination &) = delete;
  Termination &operator=(const Termination &) = delete;

private:
  class Impl;
  std::unique_ptr<Impl> m_impl;
};

/// The exit status of a program that a signal ended, as shells count it.
[[nodiscard]] inline int statusAfterSignal(int signal) { return 128 + signal; }

} // namespace halfspace
