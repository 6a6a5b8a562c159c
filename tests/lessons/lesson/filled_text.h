// Filled words as one text, to be compared.
#pragma once

#include "lessons/lesson/filled_markdown.h"
#include "lessons/reading/markdown_text.h"

#include <string>

namespace halfspace::test {

inline std::string textOf(const MarkdownBlock &block, const FilledMarkdown &filled) {
  std::string text;
  for (const MarkdownSpan &span : block.spans)
    if (span.kind == MarkdownSpan::Kind::Formula)
      text += "$" + latexOf(filled.formulas.at(span.formula)) + "$" +
              filled.formulas.at(span.formula).punctuation;
    else
      text += span.kind == MarkdownSpan::Kind::LineBreak ? "\n" : span.text;
  for (const MarkdownBlock &child : block.children)
    text += (text.empty() ? "" : "\n") + textOf(child, filled);
  return text;
}

/// Formulas between dollars, without what else Markdown makes of it; blocks on lines of their own.
inline std::string textOf(const FilledMarkdown &filled) {
  std::string text;
  for (const MarkdownBlock &block : filled.blocks)
    text += (text.empty() ? "" : "\n") + textOf(block, filled);
  return text;
}

inline std::string filledText(const MarkdownText &text, const Scene &scene, const Evaluation &evaluation,
                              LiveValues values = LiveValues::Shown) {
  return textOf(filledIn(
      text.markdown(), [&](const std::string &name) { return liveValue(name, scene, evaluation, values); }));
}

} // namespace halfspace::test
