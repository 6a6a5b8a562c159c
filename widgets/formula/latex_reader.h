// The reader of LaTeX from inside: recursive descent over the tokens, from rows down to what a command takes.
#pragma once

#include "widgets/formula/alphabets.h"
#include "widgets/formula/latex_commands.h"
#include "widgets/formula/nesting.h"
#include "widgets/formula/token_stream.h"

#include <optional>
#include <string_view>

namespace halfspace::math {

/// What a part of a formula stands in.
struct Surroundings {
  bool inOption = false; ///< a `]` ends the row
  bool inFences = false; ///< between \left and \right, where \middle may stand
  std::optional<Alphabet> alphabet;
};

/// Rows and their atoms. What the commands make of them stands in `latex_command_readers.h`. All functions
/// throw ReadError.
class LatexReader {
public:
  /// Source and macros must outlive it.
  LatexReader(std::string_view latex, const Macros &macros) : m_tokens(latex, macros) {}

  [[nodiscard]] TokenStream &tokens() { return m_tokens; }
  [[nodiscard]] Surroundings &surroundings() { return m_surroundings; }

  /// One level deeper for as long as it lives. An error where that is too deep.
  [[nodiscard]] Nesting nested() { return {m_depth, m_tokens}; }
  /// An error where the formula becomes too large. `add` counts what it appends.
  void countNode();
  void add(Row &row, Node node);
  /// The content alone where it is one atom, else a group of it.
  void addGroup(Row &row, Row content);

  /// Whether what is next ends a row.
  [[nodiscard]] bool atRowEnd();
  /// Up to what ends it, which is not taken.
  [[nodiscard]] Row readRow();
  /// A group, without its braces, or one atom.
  [[nodiscard]] Row readArgument();
  /// What stands between brackets; none where no `[` is next.
  [[nodiscard]] std::optional<Row> readOption();
  /// What the command of this token makes; the token is taken.
  void readCommand(Row &row, const Token &token);
  /// A character that has no meaning of its own in LaTeX.
  void readPlainCharacter(Row &row, char32_t character);

  /// The letter in the alphabet that its surroundings ask for.
  [[nodiscard]] char32_t inCurrentAlphabet(char32_t letter) const;

private:
  void readScriptedAtom(Row &row);
  void readAtom(Row &row);
  void readCharacter(Row &row, const Token &token);
  void readBraces(Row &row, const Token &open);
  /// Behind `{`, up to its `}`.
  [[nodiscard]] Row readGroup(std::size_t column);

  TokenStream m_tokens;
  Surroundings m_surroundings;
  std::size_t m_nodes = 0;
  int m_depth = 0;
};

} // namespace halfspace::math
