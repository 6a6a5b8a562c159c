#include "lessons/working.h"

#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/spoken.h"

#include <algorithm>

namespace halfspace {
namespace {

void keepTelling(Blank &blank) {
  std::vector<Mistake> telling;
  for (Mistake &mistake : blank.mistakes) {
    const bool known = std::any_of(telling.begin(), telling.end(),
                                   [&](const Mistake &other) { return other.value == mistake.value; });
    if (!known && !(mistake.value == blank.answer))
      telling.push_back(std::move(mistake));
  }
  blank.mistakes = std::move(telling);
}

template <class Write> std::string joined(const std::vector<Chain> &chains, Write write) {
  std::string text;
  for (const Chain &chain : chains)
    text += (text.empty() ? "" : ", ") + write(chain);
  return text;
}

/// Where the last side of a line of one statement begins to be its result.
std::size_t resultOf(const WorkingLine &line) {
  const Chain &chain = line.chains.front();
  const std::size_t sides = chain.sides().size();
  return line.chains.size() == 1 && sides > chain.symbolic() ? sides - 1 : sides;
}

std::string trimmedLatex(std::string latex) {
  latex.erase(0, std::min(latex.find_first_not_of(' '), latex.size()));
  return latex;
}

void collectMarks(const Term &term, std::vector<std::string> &marks) {
  if (!term->mark.empty() && std::find(marks.begin(), marks.end(), term->mark) == marks.end())
    marks.push_back(term->mark);
  for (const Term &part : term->parts)
    collectMarks(part, marks);
}

} // namespace

std::string plainText(const WorkingLine &line) {
  return joined(line.chains, [](const Chain &chain) { return plainText(chain); });
}

std::string questionText(const WorkingLine &line) {
  const Chain &chain = line.chains.front();
  std::string symbols = plainText(chain, 0, chain.symbolic());
  if (!line.blank || !line.blank->form)
    return symbols;
  return symbols + " = " + plainText(*line.blank->form) + ", " +
         plainText(line.blank->formula->sides().front()) + " =";
}

std::vector<ChainPart> partsOf(const WorkingLine &line, LinePiece piece) {
  const Chain &first = line.chains.front();
  const std::size_t result = resultOf(line);
  std::vector<ChainPart> parts;
  const auto append = [&](const Chain &chain, std::size_t begin, std::size_t end) {
    if (begin < end)
      parts.push_back({&chain, begin, end});
  };
  switch (piece) {
  case LinePiece::Symbols:
    append(first, 0, first.symbolic());
    break;
  case LinePiece::Numbers:
    append(first, first.symbolic(), result);
    for (std::size_t i = 1; i < line.chains.size(); ++i)
      append(line.chains[i], 0, line.chains[i].sides().size());
    break;
  case LinePiece::Result:
    append(first, result, first.sides().size());
    break;
  }
  return parts;
}

bool hasNumbers(const WorkingLine &line) {
  return !partsOf(line, LinePiece::Numbers).empty() || !partsOf(line, LinePiece::Result).empty();
}

std::string latexOf(const WorkingLine &line, LinePiece piece) {
  std::string latex;
  for (const ChainPart &part : partsOf(line, piece))
    latex += (latex.empty() ? "" : ",\\quad ") + trimmedLatex(latexOf(*part.chain, part.begin, part.end));
  return latex;
}

std::string latexOf(const WorkingLine &line) {
  std::string latex;
  for (const Chain &chain : line.chains)
    latex += (latex.empty() ? "" : ",\\quad ") + latexOf(chain);
  return latex;
}

std::string spoken(const WorkingLine &line) {
  return joined(line.chains, [](const Chain &chain) { return spoken(chain); });
}

std::vector<std::string> marksIn(const WorkingLine &line) {
  std::vector<std::string> marks;
  for (const Chain &chain : line.chains)
    for (const Term &side : chain.sides())
      collectMarks(side, marks);
  return marks;
}

Working withTellingMistakes(Working working) {
  for (WorkingLine &line : working.lines)
    if (line.blank)
      keepTelling(*line.blank);
  return working;
}

} // namespace halfspace
