#include "lessons/files/held_signals.h"

#include <atomic>

namespace halfspace {
namespace {

std::atomic_flag isHeld = ATOMIC_FLAG_INIT;

/// The signal that came meanwhile, the last of several; 0 for none. All that a handler may touch.
volatile std::sig_atomic_t waiting = 0;

extern "C" void noteWaiting(int signal) { waiting = signal; }

} // namespace

HeldSignals::HeldSignals() : m_isHolding(!isHeld.test_and_set()) {
  if (!m_isHolding)
    return;
  waiting = 0;
  struct sigaction noting {};
  noting.sa_handler = noteWaiting;
  noting.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < held.size(); ++i) {
    ::sigaction(held[i], nullptr, &m_before[i]);
    if (m_before[i].sa_handler != SIG_IGN) // as nohup asks for
      ::sigaction(held[i], &noting, nullptr);
  }
}

HeldSignals::~HeldSignals() {
  if (!m_isHolding)
    return;
  for (std::size_t i = 0; i < held.size(); ++i) {
    struct sigaction now {};
    ::sigaction(held[i], nullptr, &now);
    if (now.sa_handler == noteWaiting) // whoever set another one meanwhile knows what it is to be from now on
      ::sigaction(held[i], &m_before[i], nullptr);
  }
  const int signal = waiting;
  waiting = 0;
  isHeld.clear();
  if (signal != 0)
    ::raise(signal);
}

bool HeldSignals::isOneWaiting() { return waiting != 0; }

} // namespace halfspace
