// The operating system's wish that the program ends.
#pragma once

#include <functional>
#include <memory>

namespace halfspace {

/// While it lives, SIGTERM, SIGINT and SIGHUP do not end the program at once: `end` is called from the event
/// loop instead, with the signal's number. One at a time; requires the application object.
class Termination {
public:
  explicit Termination(std::function<void(int)> end);
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
