// How far a long command is, for whoever watches it at a terminal.
#pragma once

#include <chrono>
#include <string>

namespace halfspace {

/// One line on standard error, which is written over and over, and gone in the end. Where that is no terminal
/// nothing is said.
class ProgressLine {
public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine &) = delete;
  ProgressLine &operator=(const ProgressLine &) = delete;

  /// Says it unless it has said something a moment ago.
  void say(const std::string &words);

private:
  bool m_isSeen;
  bool m_hasSaid = false;
  std::chrono::steady_clock::time_point m_saidLast;
};

} // namespace halfspace
