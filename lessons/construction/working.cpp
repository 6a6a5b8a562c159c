#include "lessons/construction/working.h"

#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/spoken.h"

#include <algorithm>
#include <span>

namespace halfspace {
namespace {

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

bool areAlike(const ChainPart &a, const ChainPart &b) {
  const auto sidesOf = [](const ChainPart &part) {
    return std::span(part.chain->sides()).subspan(part.begin, part.end - part.begin);
  };
  const auto left = sidesOf(a);
  const auto right = sidesOf(b);
  // What relates the sides of an identity follows from how they are written.
  const bool areRelatedAlike =
      a.chain->isIdentity() ? b.chain->isIdentity() : a.chain->relations() == b.chain->relations();
  return areRelatedAlike && (a.begin == 0) == (b.begin == 0) &&
         std::equal(left.begin(), left.end(), right.begin(), right.end(),
                    [](const Term &x, const Term &y) { return areInterchangeable(x, y); });
}

void collectMarks(const Term &term, std::set<std::string> &marks) {
  if (!term->mark.empty())
    marks.insert(term->mark);
  for (const Term &part : term->parts)
    collectMarks(part, marks);
}

} // namespace

std::string plainText(const WorkingLine &line) {
  return joined(line.chains, [](const Chain &chain) { return plainText(chain); });
}

bool isOneExpression(const WorkingLine &line) {
  const Chain &chain = line.chains.front();
  return line.chains.size() == 1 && chain.isIdentity() && chain.symbolic() == 1 && chain.sides().size() > 1;
}

std::string waitingText(const WorkingLine &line) {
  return symbolsText(line) + (isOneExpression(line) ? " = ?" : "");
}

std::string symbolsText(const WorkingLine &line) {
  return joined(line.chains, [](const Chain &chain) { return plainText(chain, 0, chain.symbolic()); });
}

std::vector<ChainPart> symbolsOf(const WorkingLine &line) {
  std::vector<ChainPart> parts;
  parts.reserve(line.chains.size());
  for (const Chain &chain : line.chains)
    parts.push_back({&chain, 0, chain.symbolic()});
  return parts;
}

std::vector<ChainPart> partsOf(const WorkingLine &line, LinePiece piece) {
  const Chain &first = line.chains.front();
  const bool isAlone = line.chains.size() == 1;
  const std::size_t result = resultOf(line);
  std::vector<ChainPart> parts;
  const auto append = [&](const Chain &chain, std::size_t begin, std::size_t end) {
    if (begin < end)
      parts.push_back({&chain, begin, end});
  };
  switch (piece) {
  case LinePiece::Symbols:
    if (isAlone)
      append(first, 0, first.symbolic());
    break;
  case LinePiece::Numbers:
    // Several statements are one piece: a line breaks best between them.
    for (const Chain &chain : line.chains)
      append(chain, isAlone ? chain.symbolic() : 0, isAlone ? result : chain.sides().size());
    break;
  case LinePiece::Result:
    if (isAlone)
      append(first, result, first.sides().size());
    break;
  }
  return parts;
}

bool areInterchangeable(const WorkingLine &a, const WorkingLine &b, LinePiece piece) {
  const auto partsOfA = partsOf(a, piece);
  const auto partsOfB = partsOf(b, piece);
  return std::equal(partsOfA.begin(), partsOfA.end(), partsOfB.begin(), partsOfB.end(), areAlike);
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

std::set<std::string> marksIn(const WorkingLine &line) {
  std::set<std::string> marks;
  for (const Chain &chain : line.chains)
    for (const Term &side : chain.sides())
      collectMarks(side, marks);
  return marks;
}

const WorkingLine *findLine(const Working &working, std::string_view id) {
  const auto line = std::find_if(working.lines.begin(), working.lines.end(),
                                 [&](const WorkingLine &each) { return each.id == id; });
  return line == working.lines.end() ? nullptr : &*line;
}

} // namespace halfspace
