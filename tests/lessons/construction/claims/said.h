// Which of the program's sentences a text is made of.
#pragma once

#include "lessons/words.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace::test {

/// A sentence of the program as it was said once.
class Said {
public:
  /// As it stands in the program: `{f} is positive: …`
  std::string english;
  std::string text{}; ///< as it was said, with all that stands in it

  /// The text that was put at a place; empty for a place that the sentence does not have.
  [[nodiscard]] std::string at(const std::string &place) const;

  std::map<std::string, std::string> texts{}; ///< by the places' names
  std::string line{}; ///< the id of the worked line that it was said in; empty in the words of the case
};

/// While it lives every sentence tells where it begins and ends and which English one it is. The text is
/// read by `sentencesIn` and no longer for people.
class MarkedSentences {
public:
  MarkedSentences();
  MarkedSentences(const MarkedSentences &) = delete;
  MarkedSentences &operator=(const MarkedSentences &) = delete;
  ~MarkedSentences();
};

/// The sentences of a marked text, those within others too.
[[nodiscard]] std::vector<Said> sentencesIn(std::string_view marked);

/// The marked text as people read it.
[[nodiscard]] std::string withoutMarks(std::string_view marked);

} // namespace halfspace::test
