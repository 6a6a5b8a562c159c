// Worked lines: a formula in symbols, with the numbers put in, its result, and a sentence in plain words.
#pragma once

#include "lessons/shared_list.h"
#include "lessons/term/chain.h"

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfspace {

/// A mistake: what it calculates, and a sentence that says what went wrong, with `{answer}` for what the
/// learner wrote.
struct WrongTerm {
  Term wrong;
  std::string sentence;
};

/// What a learner can be asked for in a line: what its chain comes to, or, where that is zero for the right
/// points, the equation, which may be any multiple.
enum class Asked : std::uint8_t { Nothing, Value, Equation };

/// One line of a working: a statement in symbols, with the numbers put in, and its result; or several
/// statements beside each other, none of which is asked for. A term that is a mark of the figure takes the
/// mark's colour, and hovering one lights up the other.
struct WorkingLine {
  std::string id{}; ///< unique in the working: `distance.f` in that of a scene
  std::vector<Chain> chains;
  std::string sentence{}; ///< plain words, no LaTeX; may be empty
  Asked asked = Asked::Nothing;
  /// Written for the line, because they say more than what its formula tells by itself. Looked through in
  /// their order; those that come to the right answer are passed over.
  std::vector<WrongTerm> mistakes{};
};

/// What a line is made of, from left to right. A line of several statements has no result of its own.
enum class LinePiece : std::uint8_t { Symbols, Numbers, Result };
inline constexpr std::array linePieces{LinePiece::Symbols, LinePiece::Numbers, LinePiece::Result};

/// Sides of a chain: [begin, end).
struct ChainPart {
  const Chain *chain;
  std::size_t begin;
  std::size_t end;
};

/// The parts of a piece, to be parted by commas; empty where the line has no such piece. The line must
/// outlive them.
[[nodiscard]] std::vector<ChainPart> partsOf(const WorkingLine &line, LinePiece piece);

/// The symbols of all statements.
[[nodiscard]] std::vector<ChainPart> symbolsOf(const WorkingLine &line);

/// Whether a piece of one line can stand for that of the other, to the eye and to the hand.
[[nodiscard]] bool areInterchangeable(const WorkingLine &a, const WorkingLine &b, LinePiece piece);

/// The chain of a line of one statement, of which something can be asked.
[[nodiscard]] inline const Chain &askedChain(const WorkingLine &line) { return line.chains.front(); }

/// Whether there is something to hide.
[[nodiscard]] bool hasNumbers(const WorkingLine &line);

/// Copies of a working share its lines.
struct Working {
  SharedList<WorkingLine> lines;

  void add(WorkingLine line) { lines.push_back(std::move(line)); }
};

/// The line with this id, or null.
[[nodiscard]] const WorkingLine *findLine(const Working &working, std::string_view id);

/// The line in plain text, and in words to be read aloud; its sentence is not in it.
[[nodiscard]] std::string plainText(const WorkingLine &line);
[[nodiscard]] std::string spoken(const WorkingLine &line);
/// Whether its symbols are one expression, as n·u, so that nothing tells that a result belongs behind them.
[[nodiscard]] bool isOneExpression(const WorkingLine &line);
/// A line that waits with its numbers: its symbols, with `= ?` behind a single expression.
[[nodiscard]] std::string waitingText(const WorkingLine &line);
/// The line with its numbers left out: f(Q) = n·(Q − P₀); or s, t, s + t.
[[nodiscard]] std::string symbolsText(const WorkingLine &line);

/// The ids of the marks in the line's terms.
[[nodiscard]] std::set<std::string> marksIn(const WorkingLine &line);

/// A piece of the line as LaTeX; empty where the line has no such piece.
[[nodiscard]] std::string latexOf(const WorkingLine &line, LinePiece piece);
[[nodiscard]] std::string latexOf(const WorkingLine &line);

} // namespace halfspace
