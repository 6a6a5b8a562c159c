// Worked lines: a formula in symbols, with the numbers put in, its result, and a sentence in plain words.
#pragma once

#include "geometry/surd.h"
#include "lessons/term/chain.h"

#include <optional>
#include <string>
#include <vector>

namespace halfspace {

/// A usual mistake: the number that it leads to, and a sentence that says what went wrong, with `{answer}`
/// for that number as the learner wrote it.
struct Mistake {
  Surd value;
  std::string sentence;
};

/// What a learner fills in where a line's numbers are blank.
struct Blank {
  Surd answer;
  /// Written for the line, because they say more than what the formula tells by itself. Looked through in
  /// their order. One that comes to the answer itself, or to what an earlier one comes to, is left out by
  /// itself; that only the sign is wrong is noticed without being named here.
  std::vector<Mistake> mistakes{};
  std::string prompt = "=";       ///< LaTeX between the line's symbols and what is filled in
  std::optional<Chain> formula{}; ///< how the answer is found: the usual mistakes follow from it
};

/// One line of a working. The three pieces are LaTeX and read on from one another. A term that belongs to a
/// mark of the figure is written `\mark{id}{…}`: it takes the mark's colour, and hovering one lights up the
/// other.
struct WorkingLine {
  std::string id;       ///< unique in the working; lessons' steps name lines by it
  std::string symbols;  ///< t = \frac{…}{…}
  std::string numbers;  ///< the numbers put in, after `=` (exact) or `\approx` (rounded); may be empty
  std::string result;   ///< likewise; may be empty
  std::string sentence; ///< plain words, no LaTeX; may be empty
  std::optional<Blank> blank{}; ///< nothing where one number would not do as an answer
  std::vector<Chain> chains{};  ///< what the three pieces say
};

struct Working {
  std::vector<WorkingLine> lines;
};

/// The working without mistakes that come to the answer, or to what an earlier one of the line comes to.
[[nodiscard]] Working withTellingMistakes(Working working);

/// The line in plain text, and in words to be read aloud; its sentence is not in it.
[[nodiscard]] std::string plainText(const WorkingLine &line);
[[nodiscard]] std::string spoken(const WorkingLine &line);

/// The ids of the marks in the line's terms, in order, each once.
[[nodiscard]] std::vector<std::string> marksIn(const WorkingLine &line);

/// The ids of the marks that a piece of LaTeX names with `\mark{id}{…}`, in order, each once.
[[nodiscard]] std::vector<std::string> marksNamedIn(const std::string &latex);

/// The piece without its `\mark{id}{…}`, which only this program knows: plain LaTeX.
[[nodiscard]] std::string withoutMarks(const std::string &latex);

/// The piece as one line of plain text: `t = ((P0 − Q)·n)/(r·n) = −30/9`.
[[nodiscard]] std::string plainText(const std::string &latex);

} // namespace halfspace
