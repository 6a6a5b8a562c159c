// Worked lines: a formula in symbols, with the numbers put in, its result, and a sentence in plain words.
#pragma once

#include <string>
#include <vector>

namespace halfspace {

/// One line of a working. The three pieces are LaTeX and read on from one another. A term that belongs to a
/// mark of the figure is written `\mark{id}{…}`: it takes the mark's colour, and hovering one lights up the
/// other.
struct WorkingLine {
  std::string id;       ///< unique in the working; lessons' steps name lines by it
  std::string symbols;  ///< t = \frac{…}{…}
  std::string numbers;  ///< the numbers put in, after `=` (exact) or `\approx` (rounded); may be empty
  std::string result;   ///< likewise; may be empty
  std::string sentence; ///< plain words, no LaTeX; may be empty
};

struct Working {
  std::vector<WorkingLine> lines;
};

/// The working with `≈` before a result that follows rounded numbers: after one `≈` an `=` would claim too
/// much.
[[nodiscard]] Working withTrueRelations(Working working);

/// The ids of the marks that a piece of LaTeX names with `\mark{id}{…}`, in order, each once.
[[nodiscard]] std::vector<std::string> marksNamedIn(const std::string &latex);

/// The piece without its `\mark{id}{…}`, which only this program knows: plain LaTeX.
[[nodiscard]] std::string withoutMarks(const std::string &latex);

/// The piece as one line of plain text: `t = ((P0 − Q)·n)/(r·n) = −30/9`.
[[nodiscard]] std::string plainText(const std::string &latex);

} // namespace halfspace
