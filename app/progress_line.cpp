#include "app/progress_line.h"

#include "lessons/files/descriptor.h"
#include "lessons/text.h"

namespace halfspace {
namespace {

/// Faster than it can be read it need not be.
constexpr std::chrono::milliseconds betweenWords{100};

/// Back to the line's beginning, and nothing behind it, as terminals understand it.
constexpr const char *emptyLine = "\r\x1b[K";

} // namespace

ProgressLine::ProgressLine() : m_isSeen(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (m_hasSaid)
    static_cast<void>(writeAll(STDERR_FILENO, emptyLine));
}

void ProgressLine::say(const std::string &words) {
  const auto now = std::chrono::steady_clock::now();
  if (!m_isSeen || (m_hasSaid && now - m_saidLast < betweenWords))
    return;
  m_hasSaid = true;
  m_saidLast = now;
  static_cast<void>(writeAll(STDERR_FILENO, emptyLine + printable(words)));
}

} // namespace halfspace
