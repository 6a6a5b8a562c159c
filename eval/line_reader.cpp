#include "eval/line_reader.h"

#include "eval/json_line.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

constexpr std::size_t bufferSize = std::size_t{1} << 16U;
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

} // namespace

std::optional<std::string_view> LineReader::next() {
  while (readLine()) {
    std::string_view line = m_line;
    if (std::exchange(m_firstLine, false) && line.starts_with(byteOrderMark))
      line.remove_prefix(byteOrderMark.size());
    // What was cut off a line that is too long may be more than blanks.
    if (line.size() > maxLineLength || line.find_first_not_of(" \t") != std::string_view::npos)
      return line;
  }
  return {};
}

/// Fills m_line with the next line; false at the end.
bool LineReader::readLine() {
  m_line.clear();
  bool begun = false;
  while (m_used < m_buffer.size() || fill()) {
    begun = true;
    const std::string_view rest = std::string_view(m_buffer).substr(m_used);
    const std::size_t end = rest.find('\n');
    append(rest.substr(0, end));
    m_used += end == std::string_view::npos ? rest.size() : end + 1;
    if (end != std::string_view::npos)
      break;
  }
  // At the end of the stream it is the front half of an end.
  if (m_line.ends_with('\r'))
    m_line.pop_back();
  return begun && !m_failed;
}

/// One byte more than a line may have tells that it has too many; a \r at its end and a mark at its front are
/// not counted.
void LineReader::append(std::string_view part) {
  constexpr std::size_t kept = maxLineLength + 2 + byteOrderMark.size();
  m_line += part.substr(0, kept - std::min(kept, m_line.size()));
}

/// Reads what the stream has ready, or waits for some; false at its end.
bool LineReader::fill() {
  if (m_failed)
    return false;
  try {
    std::streambuf &source = *m_stream.rdbuf();
    if (source.in_avail() <= 0) {
      m_beforeWaiting();
      if (source.sgetc() == std::char_traits<char>::eof())
        return false;
    }
    const auto ready = std::max<std::streamsize>(source.in_avail(), 1);
    m_buffer.resize(std::min(bufferSize, static_cast<std::size_t>(ready)));
    m_buffer.resize(static_cast<std::size_t>(
        source.sgetn(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()))));
    m_used = 0;
    return !m_buffer.empty();
  } catch (const std::ios_base::failure &) {
    // The standard library's way of saying that the operating system refuses, as for a folder.
    m_failed = true;
    m_buffer.clear();
    m_used = 0;
    return false;
  }
}

} // namespace halfspace
