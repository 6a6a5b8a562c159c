#include "lessons/lesson/term_links.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

const LessonLibrary &library() {
  static const LessonLibrary sample{
      {*parseLesson("---\nid: a\ntitle: T\nscene:\n  - {name: Q, point: [1, 2, 3]}\n---\n## One\n\n"
                    "```lines\nnone\n```\n\n```term\nname: ray\nalso: [rays]\nmeans: A ray.\n```\n\n"
                    "```term\nname: plane\nmeans: A plane.\n```\n\n## Two\n\n```lines\nnone\n```\n",
                    "a.md")},
      {}};
  return sample;
}

/// The words with each link as [text](address).
std::string linked(const std::string &text, int step = 1) {
  const Glossary glossary(library());
  TermLinks links(glossary, library().lessons.front().steps[static_cast<std::size_t>(step)]);
  Markdown words = *readMarkdown(text);
  links.addTo(words);
  std::string all;
  for (const MarkdownBlock &block : words.blocks)
    for (const MarkdownSpan &span : block.spans)
      all += span.face.link.empty() ? span.text : "[" + span.text + "](" + span.face.link + ")";
  return all;
}

TEST(TermLinks, StandWhereATermStandsFirst) {
  EXPECT_EQ(linked("Two rays, a plane and a ray."), "Two [rays](term:ray), a [plane](term:plane) and a ray.");
  EXPECT_EQ(linked("Ray\n\nray"), "[Ray](term:ray)ray");
  EXPECT_EQ(linked("no word"), "no word");
}

TEST(TermLinks, AreNotInTheStepThatTeachesIt_NorInLinksAndCode) {
  EXPECT_EQ(linked("A ray.", 0), "A ray.");
  EXPECT_EQ(linked("`ray`"), "ray");
  EXPECT_EQ(linked("# ray"), "ray");
  EXPECT_EQ(linked("[a ray](https://example.org)"), "[a ray](https://example.org)");
}

TEST(TermLinks, HaveAnAddressThatNoLessonCanWrite) {
  EXPECT_EQ(termAt("term:dot product"), "dot product");
  EXPECT_EQ(termAt("https://example.org"), "");
  EXPECT_EQ(linked("[here](term:ray)"), "here");
}

} // namespace
} // namespace halfspace
