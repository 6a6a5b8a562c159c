#include "lessons/construction/line_text.h"

#include "lessons/term/latex.h"
#include "lessons/term/latex_words.h"
#include "lessons/term/mathml.h"
#include "lessons/xml_text.h"

#include <string_view>

namespace halfspace {
namespace {

/// Of each statement the sides that may be told.
std::vector<ChainPart> toldParts(const ToldLine &told) {
  std::vector<ChainPart> parts = symbolsOf(*told.line);
  if (told.isWhole)
    for (ChainPart &part : parts)
      part.end = part.chain->sides().size();
  return parts;
}

std::string_view toldSentence(const ToldLine &told) {
  return told.isWhole ? std::string_view(told.line->sentence) : std::string_view();
}

std::string latexOf(const std::vector<ChainPart> &parts) {
  std::string latex;
  for (const ChainPart &part : parts)
    latex += (latex.empty() ? "" : ",\\quad ") + latexOf(*part.chain, part.begin, part.end);
  return latex;
}

std::string mathMlOf(const std::vector<ChainPart> &parts) {
  std::vector<std::string> rows;
  rows.reserve(parts.size());
  for (const ChainPart &part : parts)
    rows.push_back(mathMlRow(*part.chain, part.begin, part.end));
  return displayedMathMl(rows);
}

/// With the alignment mark before the first relation, in place of the space there; at the end where none
/// follows the first side.
std::string alignedLatex(const ToldLine &told) {
  std::string latex = latexOf(toldParts(told));
  const std::size_t relation = latexOf(told.line->chains.front(), 0, 1).size();
  const bool isThere = latex.size() > relation && latex[relation] == ' ';
  return isThere ? latex.replace(relation, 1, " &") : latex + " &";
}

/// The last sentence stands behind the environment, where an \intertext would leave an empty line below it.
std::string latexText(const std::vector<ToldLine> &lines) {
  std::string aligned;
  std::string words;
  for (const ToldLine &told : lines) {
    if (!aligned.empty())
      aligned += " \\\\\n" + (words.empty() ? "" : "\\intertext{" + words + "}\n");
    aligned += "  " + alignedLatex(told);
    words = latexWords(toldSentence(told));
  }
  if (aligned.empty())
    return {};
  return "\\begin{align*}\n" + aligned + "\n\\end{align*}\n" + (words.empty() ? "" : words + "\n");
}

std::string mathMlText(const std::vector<ToldLine> &lines) {
  std::string html;
  for (const ToldLine &told : lines) {
    html += xmlElement("p", formulaText(told, DocumentFormat::MathMl)) + "\n";
    if (const std::string_view sentence = toldSentence(told); !sentence.empty())
      html += xmlElement("p", escapedForXml(sentence)) + "\n";
  }
  return html;
}

std::string plainLines(const std::vector<ToldLine> &lines) {
  std::string text;
  for (const ToldLine &told : lines) {
    text += formulaText(told, DocumentFormat::PlainText) + "\n";
    if (const std::string_view sentence = toldSentence(told); !sentence.empty())
      text += "    " + std::string(sentence) + "\n";
  }
  return text;
}

} // namespace

std::string formulaText(const ToldLine &told, DocumentFormat format) {
  switch (format) {
  case DocumentFormat::Latex:
    return latexOf(toldParts(told));
  case DocumentFormat::MathMl:
    return mathMlOf(toldParts(told));
  case DocumentFormat::PlainText:
    break;
  }
  return told.isWhole ? plainText(*told.line) : waitingText(*told.line);
}

std::string workingText(const std::vector<ToldLine> &lines, DocumentFormat format) {
  switch (format) {
  case DocumentFormat::Latex:
    return latexText(lines);
  case DocumentFormat::MathMl:
    return mathMlText(lines);
  case DocumentFormat::PlainText:
    break;
  }
  return plainLines(lines);
}

} // namespace halfspace
