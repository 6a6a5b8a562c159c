// What the commands of LaTeX read and make, for the table of commands. Each takes what belongs to the
// command, which is taken itself, and appends to the row; all throw ReadError.
#pragma once

#include "widgets/formula/latex_commands.h"

namespace halfspace::math {

// read_latex_symbols.cpp
void readLetter(LatexReader &reader, Row &row, const CommandCall &call);
void readLargeOperator(LatexReader &reader, Row &row, const CommandCall &call);
void readFunction(LatexReader &reader, Row &row, const CommandCall &call);
void readDots(LatexReader &reader, Row &row, const CommandCall &call);
void readDiagonalDots(LatexReader &reader, Row &row, const CommandCall &call);
void readNot(LatexReader &reader, Row &row, const CommandCall &call);
void readModulo(LatexReader &reader, Row &row, const CommandCall &call);
void readClass(LatexReader &reader, Row &row, const CommandCall &call);
void readAlphabet(LatexReader &reader, Row &row, const CommandCall &call);
void readAlphabetSwitch(LatexReader &reader, Row &row, const CommandCall &call);

// read_latex_spaces.cpp
void readSpace(LatexReader &reader, Row &row, const CommandCall &call);
void readGivenSpace(LatexReader &reader, Row &row, const CommandCall &call);
void readKern(LatexReader &reader, Row &row, const CommandCall &call);
void readPhantom(LatexReader &reader, Row &row, const CommandCall &call);
void readLap(LatexReader &reader, Row &row, const CommandCall &call);
void readBlock(LatexReader &reader, Row &row, const CommandCall &call);
void readStrut(LatexReader &reader, Row &row, const CommandCall &call);
void readStyle(LatexReader &reader, Row &row, const CommandCall &call);

// read_latex_structures.cpp
void readFraction(LatexReader &reader, Row &row, const CommandCall &call);
void readContinuedFraction(LatexReader &reader, Row &row, const CommandCall &call);
void readBinomial(LatexReader &reader, Row &row, const CommandCall &call);
void readOver(LatexReader &reader, Row &row, const CommandCall &call);
void readRoot(LatexReader &reader, Row &row, const CommandCall &call);
void readFenced(LatexReader &reader, Row &row, const CommandCall &call);
void readMiddle(LatexReader &reader, Row &row, const CommandCall &call);
void readTallFence(LatexReader &reader, Row &row, const CommandCall &call);
void readAccent(LatexReader &reader, Row &row, const CommandCall &call);
void readWideAccent(LatexReader &reader, Row &row, const CommandCall &call);
void readBar(LatexReader &reader, Row &row, const CommandCall &call);
void readBrace(LatexReader &reader, Row &row, const CommandCall &call);
void readStack(LatexReader &reader, Row &row, const CommandCall &call);
void readArrow(LatexReader &reader, Row &row, const CommandCall &call);
void readBoxed(LatexReader &reader, Row &row, const CommandCall &call);

// read_latex_tables.cpp
void readEnvironment(LatexReader &reader, Row &row, const CommandCall &call);
void readSubstack(LatexReader &reader, Row &row, const CommandCall &call);

// read_latex_text.cpp
void readText(LatexReader &reader, Row &row, const CommandCall &call);
void readOperatorName(LatexReader &reader, Row &row, const CommandCall &call);
void readTag(LatexReader &reader, Row &row, const CommandCall &call);

// read_latex_marks.cpp
void readMark(LatexReader &reader, Row &row, const CommandCall &call);
void readColor(LatexReader &reader, Row &row, const CommandCall &call);
void readNothing(LatexReader &reader, Row &row, const CommandCall &call);
void readLabel(LatexReader &reader, Row &row, const CommandCall &call);
void readMisplaced(LatexReader &reader, Row &row, const CommandCall &call);

} // namespace halfspace::math
