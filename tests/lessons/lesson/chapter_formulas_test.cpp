#include "lessons/lesson/chapter_formulas.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

Lesson lessonOf(const std::string &id, const std::string &chapter, const std::string &steps) {
  auto lesson = parseLesson("---\nid: " + id + "\ntitle: About " + id + "\nchapter: " + chapter +
                                "\nscene:\n  - {name: Q, point: [1, 2, 3]}\n---\n" + steps,
                            id + ".md");
  EXPECT_TRUE(lesson) << lesson.problem().text();
  return *lesson;
}

std::string step(const std::string &formula) {
  return "## Step\n\n```lines\nnone\n```\n\n" +
         (formula.empty() ? "" : "```formulas\n$" + formula + "$\n```\n\n");
}

TEST(ChapterFormulas, AreThoseOfItsLessons_InTheirOrder) {
  const LessonLibrary library{{lessonOf("a", "One", step("x") + step("") + step("y")),
                               lessonOf("b", "One", step("")), lessonOf("c", "One", step("z")),
                               lessonOf("d", "Two", step("")), lessonOf("e", "Three", step("w")),
                               lessonOf("own", "One", step("v"))},
                              {}};
  const auto chapters = formulasOf(library);
  ASSERT_EQ(chapters.size(), 2U);
  EXPECT_EQ(chapters[0].chapter, "One");
  ASSERT_EQ(chapters[0].lessons.size(), 3U);
  EXPECT_EQ(chapters[0].lessons[0].title, "About a");
  ASSERT_EQ(chapters[0].lessons[0].formulas.size(), 2U);
  EXPECT_EQ(chapters[0].lessons[0].formulas[1].written(), "$y$");
  EXPECT_EQ(chapters[0].lessons[1].lesson, "c");
  EXPECT_EQ(chapters[0].lessons[2].lesson, "own") << "each chapter stands once";
  EXPECT_EQ(chapters[1].chapter, "Three");
}

} // namespace
} // namespace halfspace
