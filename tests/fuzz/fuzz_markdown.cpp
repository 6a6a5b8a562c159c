// Whatever the bytes: blocks that are not too deep, whose formulas are there, or a problem with a sentence.
#include "lessons/reading/markdown.h"

#include <cstdint>
#include <cstdlib>

namespace {

using namespace halfspace;

void demand(bool holds) {
  if (!holds)
    std::abort();
}

void demandSound(const MarkdownBlock &block, const Markdown &markdown, std::size_t depth) {
  demand(depth <= maxMarkdownDepth + 3); // a row and a cell are in a table
  demand(block.spans.empty() || block.children.empty());
  for (const MarkdownSpan &span : block.spans) {
    if (span.kind != MarkdownSpan::Kind::Picture)
      demand(span.text.empty() == (span.kind != MarkdownSpan::Kind::Text));
    demand(span.face.link.empty() || isOpenable(span.face.link));
    demand(span.text.find('\n') == std::string::npos);
    demand(span.kind != MarkdownSpan::Kind::Formula || span.formula < markdown.formulas.size());
  }
  for (const MarkdownBlock &child : block.children)
    demandSound(child, markdown, depth + 1);
}

void demandSound(const MarkdownFormula &formula, std::string_view text) {
  demand(!formula.sides.empty() && formula.sides.size() <= 2);
  for (const MarkdownFormula::Side &side : formula.sides)
    demand(side.place + side.text.size() <= text.size() &&
           writtenIn(formula).find(side.text) != std::string::npos);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char *>(data), size);
  const auto markdown = readMarkdown(text);
  if (!markdown) {
    demand(!markdown.problem().sentence.empty());
    return 0;
  }
  for (const MarkdownBlock &block : markdown->blocks)
    demandSound(block, *markdown, 1);
  for (const MarkdownFormula &formula : markdown->formulas)
    demandSound(formula, text);
  return 0;
}
