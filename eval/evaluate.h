// Answers to geometry questions, line by line.
#pragma once

#include "eval/json_line.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace halfspace {

/// Answers questions, one JSON object each, by one JSON object each. Keeps its memory from line to line.
class Evaluator {
public:
  /// Writes the answer to a line behind what `answers` holds, with a line's end; true when its `ok` is true.
  /// A line of more than `maxLineLength` bytes may be given by any part of it that is itself longer than
  /// that.
  bool answer(std::string_view line, std::string &answers);

private:
  JsonLine m_line;
};

enum class StreamOutcome { AllAnswered, SomeFaults, CannotRead, CannotWrite };

/// Answers each line of a stream (UTF-8, ended by \n or \r\n), but for blank ones; a byte order mark before
/// the first is passed over. Answers are written before more input is waited for. Needs memory for the
/// longest line alone.
[[nodiscard]] StreamOutcome evaluateLines(std::istream &questions, std::ostream &answers);

} // namespace halfspace
