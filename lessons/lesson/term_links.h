// Words of a lesson that lead to the glossary.
#pragma once

#include "lessons/lesson/glossary.h"
#include "lessons/reading/markdown.h"

#include <set>

namespace halfspace {

/// Addresses of the program's own: `term:` with the name of a term. No lesson can write such a link.
inline constexpr const char *termScheme = "term";
[[nodiscard]] std::string addressOf(const TaughtTerm &term);
/// The name of the term at an address; empty for other addresses.
[[nodiscard]] std::string_view termAt(std::string_view address);

/// Links terms in the words of one step, each where it stands first. Those that the step teaches itself have
/// no link, and neither has what is a link or code already.
class TermLinks {
public:
  /// The glossary must outlive it.
  TermLinks(const Glossary &glossary, const LessonStep &step);

  void addTo(Markdown &words);

private:
  void addTo(MarkdownBlock &block);
  /// Goes on with a piece of text, in as many spans as it takes.
  void addPieces(const MarkdownSpan &text, std::vector<MarkdownSpan> &spans);

  const Glossary &m_glossary;
  std::set<std::string> m_known; ///< the names of those that have no link any more
};

} // namespace halfspace
