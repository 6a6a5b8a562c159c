#include "lessons/lesson/term_links.h"

#include <utility>

namespace halfspace {

std::string addressOf(const TaughtTerm &term) { return std::string(termScheme) + ":" + term.name; }

std::string_view termAt(std::string_view address) {
  const std::string begin = std::string(termScheme) + ":";
  return address.starts_with(begin) ? address.substr(begin.size()) : std::string_view();
}

TermLinks::TermLinks(const Glossary &glossary, const LessonStep &step) : m_glossary(glossary) {
  for (const TaughtTerm &term : step.terms)
    m_known.insert(term.name);
}

void TermLinks::addTo(Markdown &words) {
  for (MarkdownBlock &block : words.blocks)
    addTo(block);
}

void TermLinks::addTo(MarkdownBlock &block) {
  const bool isText = block.kind != MarkdownBlock::Kind::Code && block.kind != MarkdownBlock::Kind::Heading;
  for (MarkdownSpan &span : std::exchange(block.spans, {}))
    if (isText && span.kind == MarkdownSpan::Kind::Text && span.face.link.empty() && !span.face.code)
      addPieces(span, block.spans);
    else
      block.spans.push_back(std::move(span));
  for (MarkdownBlock &child : block.children)
    addTo(child);
}

void TermLinks::addPieces(const MarkdownSpan &text, std::vector<MarkdownSpan> &spans) {
  std::size_t begin = 0;
  const auto addUpTo = [&](std::size_t end, const std::string &link) {
    if (end == begin)
      return;
    MarkdownSpan &piece = spans.emplace_back(text);
    piece.text = text.text.substr(begin, end - begin);
    piece.face.link = link;
    begin = end;
  };
  for (const TermUse &use : m_glossary.usesIn(text.text)) {
    if (!m_known.insert(use.entry->term->name).second)
      continue;
    addUpTo(use.begin, "");
    addUpTo(use.begin + use.size, addressOf(*use.entry->term));
  }
  addUpTo(text.text.size(), "");
}

} // namespace halfspace
