#include "lessons/lesson/glossary.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

Lesson lessonWith(const std::string &id, const std::string &terms) {
  auto lesson =
      parseLesson("---\nid: " + id + "\ntitle: T\nscene:\n  - {name: Q, point: [1, 2, 3]}\n---\n## One\n\n" +
                      "```lines\nnone\n```\n\n## Two\n\n" + terms,
                  id + ".md");
  EXPECT_TRUE(lesson) << lesson.problem().text();
  return *lesson;
}

std::string term(const std::string &name, const std::string &also) {
  return "```term\nname: " + name + "\nalso: [" + also + "]\nmeans: What it is.\n```\n\n";
}

LessonLibrary samples() {
  return {{lessonWith("a", term("ray", "rays") + term("Distance", "distances")),
           lessonWith("b", term("signed distance", "") + term("ray", ""))},
          {}};
}

std::vector<std::string> found(std::string_view text) {
  const LessonLibrary library = samples();
  const Glossary glossary(library);
  std::vector<std::string> texts;
  for (const TermUse &use : glossary.usesIn(text))
    texts.push_back(std::string(text.substr(use.begin, use.size)) + ": " + use.entry->term->name);
  return texts;
}

TEST(Glossary, HasEveryTerm_AsADictionarySortsThem_WithItsStep) {
  const LessonLibrary library = samples();
  const Glossary all(library);
  const auto &glossary = all.entries();
  ASSERT_EQ(glossary.size(), 3U);
  EXPECT_EQ(glossary[0].term->name, "Distance");
  EXPECT_EQ(glossary[1].term->name, "ray");
  EXPECT_EQ(glossary[2].term->name, "signed distance");
  EXPECT_EQ(glossary[2].lesson->id, "b");
  EXPECT_EQ(glossary[2].step, 1);
}

TEST(Glossary, FindsTermsAsWholeWords_InAnyCase_TheLongestFirst) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(found("Rays have a signed distance."), (Texts{"Rays: ray", "signed distance: signed distance"}));
  EXPECT_EQ(found("the distance, DISTANCES"), (Texts{"distance: Distance", "DISTANCES: Distance"}));
  EXPECT_EQ(found("array, arrays, rayé, rayon"), Texts());
  EXPECT_EQ(found("ray"), Texts{"ray: ray"});
  EXPECT_EQ(found(""), Texts());
}

TEST(TermBlock, NeedsANameAndAMeaning) {
  const auto problemOf = [](const std::string &block) {
    const auto lesson = parseLesson("---\nid: a\ntitle: T\nscene: []\n---\n## One\n\n" + block, "a.md");
    return lesson ? std::string() : lesson.problem().field;
  };
  EXPECT_EQ(problemOf("```term\nmeans: What it is.\n```\n"), "term.name");
  EXPECT_EQ(problemOf("```term\nname: ray\n```\n"), "term.means");
  EXPECT_EQ(problemOf("```term\nname: ray\nmeans: What it is.\nalso: [[a]]\n```\n"), "term.also");
}

} // namespace
} // namespace halfspace
