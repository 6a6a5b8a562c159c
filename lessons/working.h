// Worked lines: a formula in symbols, with the numbers put in, its result, and a sentence in plain words.
#pragma once

#include "geometry/surd.h"
#include "lessons/term/chain.h"

#include <optional>
#include <string>
#include <vector>

namespace halfspace {

/// A usual mistake: what it leads to, and a sentence that says what went wrong, with `{answer}`
/// for that number as the learner wrote it.
struct Mistake {
  std::vector<Surd> value;
  std::string sentence;
};

/// What a learner fills in where a line's numbers are blank.
struct Blank {
  std::vector<Surd> answer; ///< a number, or the coordinates of a vector or a point
  /// Written for the line, because they say more than what the formula tells by itself. Looked through in
  /// their order. One that comes to the answer itself, or to what an earlier one comes to, is left out by
  /// itself; that only the sign is wrong is noticed without being named here.
  std::vector<Mistake> mistakes{};
  /// How the answer is found: the usual mistakes follow from it.
  std::optional<Chain> formula{};
  /// Where the answer is one number of the line's last side: that side in letters. The formula's first side
  /// is the letter that is asked for.
  std::optional<Term> form{};
};

/// One line of a working: a statement in symbols, with the numbers put in, and its result; or several
/// statements beside each other. A term that is a mark of the figure takes the mark's colour, and hovering
/// one lights up the other.
struct WorkingLine {
  std::string id; ///< unique in the working; lessons' steps name lines by it
  std::vector<Chain> chains;
  std::string sentence{};       ///< plain words, no LaTeX; may be empty
  std::optional<Blank> blank{}; ///< nothing where numbers would not do as an answer
};

/// What a line is made of, from left to right. A line of several statements has no result of its own.
enum class LinePiece : std::uint8_t { Symbols, Numbers, Result };

/// Sides of a chain: [begin, end).
struct ChainPart {
  const Chain *chain;
  std::size_t begin;
  std::size_t end;
};

/// The parts of a piece, to be parted by commas; empty where the line has no such piece. The line must
/// outlive them.
[[nodiscard]] std::vector<ChainPart> partsOf(const WorkingLine &line, LinePiece piece);

/// Whether there is something to leave blank.
[[nodiscard]] bool hasNumbers(const WorkingLine &line);

struct Working {
  std::vector<WorkingLine> lines;
};

/// The working without mistakes that come to the answer, or to what an earlier one of the line comes to.
[[nodiscard]] Working withTellingMistakes(Working working);

/// The line in plain text, and in words to be read aloud; its sentence is not in it.
[[nodiscard]] std::string plainText(const WorkingLine &line);
[[nodiscard]] std::string spoken(const WorkingLine &line);
/// The line with its numbers left out: f(Q) = n·(Q − P₀), or 0 = ax + by + cz + d, d = where one number is
/// asked.
[[nodiscard]] std::string questionText(const WorkingLine &line);

/// The ids of the marks in the line's terms, in order, each once.
[[nodiscard]] std::vector<std::string> marksIn(const WorkingLine &line);

/// A piece of the line as LaTeX; empty where the line has no such piece.
[[nodiscard]] std::string latexOf(const WorkingLine &line, LinePiece piece);
[[nodiscard]] std::string latexOf(const WorkingLine &line);

} // namespace halfspace
