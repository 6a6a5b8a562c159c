// The lines of a stream, in bounded memory.
#pragma once

#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace halfspace {

/// Takes a stream apart into lines, ended by \n or \r\n; the last needs no end, or only half of one: a \r.
/// Blank lines (spaces and tabs alone) are skipped, and so is a byte order mark before the first line.
class LineReader {
public:
  /// `beforeWaiting` is called whenever the stream may have to wait for more input.
  LineReader(std::istream &stream, std::function<void()> beforeWaiting)
      : m_stream(stream), m_beforeWaiting(std::move(beforeWaiting)) {}

  /// The next line without its end, until the next call; nothing at the end of the stream. Of a line longer
  /// than `maxLineLength` only so much comes that it is seen to be too long.
  [[nodiscard]] std::optional<std::string_view> next();

  /// Whether the stream ended because it could not be read.
  [[nodiscard]] bool failed() const { return m_failed; }

private:
  [[nodiscard]] bool readLine();
  [[nodiscard]] bool fill();
  void append(std::string_view part);

  std::istream &m_stream;
  std::function<void()> m_beforeWaiting;
  std::string m_buffer;   ///< what was read last
  std::size_t m_used = 0; ///< so much of the buffer is in lines already
  std::string m_line;
  bool m_firstLine = true;
  bool m_failed = false;
};

} // namespace halfspace
