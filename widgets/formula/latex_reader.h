// The reader of LaTeX from inside: recursive descent over the tokens. All functions throw ReadError, which
// `readLatex` catches.
#pragma once

#include "widgets/formula/latex_commands.h"
#include "widgets/formula/token_stream.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace::math {

class LatexReader {
public:
  LatexReader(std::string_view latex, const Macros &macros) : m_tokens(latex, macros) {}

  /// All of the source.
  [[nodiscard]] Row formula();

  // What the table of commands names (read_latex_commands.cpp). Each appends to the row.
  void readLetter(Row &row, const Command &command);
  void readLargeOperator(Row &row, const Command &command);
  void readFunction(Row &row, const Command &command);
  void readOperatorName(Row &row, const Command &command);
  void readDots(Row &row, const Command &command);
  void readDiagonalDots(Row &row, const Command &command);
  void readAlphabet(Row &row, const Command &command);
  void readAlphabetSwitch(Row &row, const Command &command);
  void readStyle(Row &row, const Command &command);
  void readSpace(Row &row, const Command &command);
  void readGivenSpace(Row &row, const Command &command);
  void readKern(Row &row, const Command &command);
  void readFraction(Row &row, const Command &command);
  void readContinuedFraction(Row &row, const Command &command);
  void readBinomial(Row &row, const Command &command);
  void readRoot(Row &row, const Command &command);
  void readFenced(Row &row, const Command &command);
  void readMiddle(Row &row, const Command &command);
  void readTallFence(Row &row, const Command &command);
  void readAccent(Row &row, const Command &command);
  void readWideAccent(Row &row, const Command &command);
  void readBar(Row &row, const Command &command);
  void readBrace(Row &row, const Command &command);
  void readStack(Row &row, const Command &command);
  void readArrow(Row &row, const Command &command);
  void readNot(Row &row, const Command &command);
  void readClass(Row &row, const Command &command);
  void readOver(Row &row, const Command &command);
  void readBoxed(Row &row, const Command &command);
  void readPhantom(Row &row, const Command &command);
  void readLap(Row &row, const Command &command);
  void readBlock(Row &row, const Command &command);
  void readStrut(Row &row, const Command &command);
  void readModulo(Row &row, const Command &command);
  void readMark(Row &row, const Command &command);
  void readColor(Row &row, const Command &command);
  void readText(Row &row, const Command &command); // read_latex_text.cpp
  void readTag(Row &row, const Command &command);
  void readNothing(Row &row, const Command &command);
  void readLabel(Row &row, const Command &command);
  void readMisplaced(Row &row, const Command &command);
  void readEnvironment(Row &row, const Command &command); // read_latex_tables.cpp
  void readSubstack(Row &row, const Command &command);

private:
  class Nesting;

  // Rows and atoms (read_latex.cpp)
  [[nodiscard]] bool atRowEnd();
  [[nodiscard]] Row readRow();
  void readRowInto(Row &row);
  void readScriptedAtom(Row &row);
  [[nodiscard]] bool atScript();
  void readScripts(Row &row);
  void readScript(Row &above, Row &below);
  void readAtom(Row &row);
  void readCommand(Row &row, const Token &token);
  void readCharacter(Row &row, const Token &token);
  void readPlainCharacter(Row &row, char32_t character);
  void readBraces(Row &row, const Token &open);
  [[nodiscard]] Row readPrimes();
  [[nodiscard]] Row readTypedScript(bool isAbove);
  /// A group, without its braces, or one atom.
  [[nodiscard]] Row readArgument();
  [[nodiscard]] std::optional<Row> readOption();
  /// Behind `{`, up to its `}`.
  [[nodiscard]] Row readGroup(std::size_t column);
  [[nodiscard]] char32_t inCurrentAlphabet(char32_t letter) const;
  void add(Row &row, Node node);
  void countNode();

  // Arguments that are no formulas (read_latex_commands.cpp)
  [[nodiscard]] std::string readName();
  [[nodiscard]] std::string readBareLength();
  [[nodiscard]] double lengthOf(const std::string &text, std::size_t column) const;
  [[nodiscard]] Color readColorValue();
  [[nodiscard]] char32_t readFence();

  // Tables (read_latex_tables.cpp)
  void readTableRows(Table &table);
  void readCells(TableRow &tableRow);
  [[nodiscard]] bool takeRowBreak(TableRow &tableRow);
  [[nodiscard]] bool atTableEnd();
  [[nodiscard]] int readRules();
  void readColumns(Table &table);

  // Words (read_latex_text.cpp)
  [[nodiscard]] Row readWords(Alphabet alphabet);
  void readWordsInto(Row &row, std::string &words, Alphabet alphabet, std::size_t column);
  void readTextCommand(Row &row, std::string &words, Alphabet alphabet);
  void readFormulaInText(Row &row, std::size_t column);
  void flushWords(Row &row, std::string &words, Alphabet alphabet);

  /// What stands here cannot end what began at `column` and lacks `closer`.
  [[noreturn]] void failUnclosed(std::size_t column, std::string_view opener, std::string_view closer);
  [[noreturn]] void failStray(const Token &token) const;

  TokenStream m_tokens;
  std::size_t m_column = 1; ///< of the command being read
  std::size_t m_nodes = 0;
  int m_depth = 0;
  bool m_inOption = false; ///< a `]` ends the row
  int m_fences = 0;        ///< how many \left are open
  std::optional<Alphabet> m_alphabet;
};

} // namespace halfspace::math
