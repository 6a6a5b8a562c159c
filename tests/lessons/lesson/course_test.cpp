// The program's lessons as a course: nothing is used before it is taught.
#include "lessons/lesson/glossary.h"
#include "lessons/lesson/shown.h"
#include "lessons/text.h"

#include <gtest/gtest.h>

#include <set>

namespace halfspace {
namespace {

const LessonLibrary &library() {
  static const LessonLibrary read = readLessons(LESSON_FOLDER);
  return read;
}

/// The lesson with all that it builds on, and all that those build on.
void addWithNeeds(const Lesson &lesson, std::set<const Lesson *> &lessons) {
  if (!lessons.insert(&lesson).second)
    return;
  for (const Need &need : lesson.needs)
    if (const Lesson *needed = library().find(need.id))
      addWithNeeds(*needed, lessons);
}

std::set<const Lesson *> needsOf(const Lesson &lesson) {
  std::set<const Lesson *> lessons;
  addWithNeeds(lesson, lessons);
  lessons.erase(&lesson);
  return lessons;
}

/// All that a step says to a reader, where it does not speak of another lesson by its title.
std::string textOf(const Lesson &lesson, const LessonStep &step) {
  std::string text = step.title;
  for (const LessonWords &piece : wordsOf(step))
    if (piece.field != "means") // is read in the glossary
      text += "\n" + piece.text;
  for (const WorkingLine &line : shownIn(step, evaluate(lesson.scene)).working.lines)
    text += "\n" + line.sentence;
  for (const Lesson &other : library().lessons)
    text = replacedAll(text, other.title, "");
  return text;
}

void addTerms(const LessonStep &step, std::set<std::string> &names) {
  for (const TaughtTerm &term : step.terms)
    names.insert(term.name);
}

std::set<std::string> termsOf(const std::set<const Lesson *> &lessons) {
  std::set<std::string> names;
  for (const Lesson *lesson : lessons)
    for (const LessonStep &step : lesson->steps)
      addTerms(step, names);
  return names;
}

TEST(Course, EveryLessonHasAPlaceOfItsOwn_BehindThoseThatItNeeds) {
  std::set<int> places;
  for (const Lesson &lesson : library().lessons) {
    EXPECT_TRUE(places.insert(lesson.order).second) << lesson.id;
    for (const Need &need : lesson.needs) {
      const Lesson *needed = library().find(need.id);
      ASSERT_NE(needed, nullptr) << lesson.id << " needs " << need.id;
      EXPECT_LT(needed->order, lesson.order) << lesson.id << " needs " << need.id;
    }
  }
}

TEST(Course, NoTermIsUsedBeforeItIsTaught) {
  const std::vector<GlossaryEntry> glossary = glossaryOf(library());
  for (const Lesson &lesson : library().lessons) {
    std::set<std::string> known = termsOf(needsOf(lesson));
    for (const LessonStep &step : lesson.steps) {
      addTerms(step, known);
      const std::string text = textOf(lesson, step);
      std::set<std::string> unknown;
      for (const TermUse &use : termsIn(text, glossary))
        if (!known.contains(use.entry->term->name))
          unknown.insert(use.entry->term->name + " (of " + use.entry->lesson->id + ")");
      for (const std::string &term : unknown)
        ADD_FAILURE() << lesson.id << ", “" << step.title << "”: " << term;
    }
  }
}

/// Whether a lesson speaks of what another teaches: by a term, or by its title.
bool speaksOf(const Lesson &lesson, const Lesson &needed) {
  const std::vector<GlossaryEntry> glossary = glossaryOf(library());
  const std::set<std::string> taught = termsOf({&needed});
  for (const LessonStep &step : lesson.steps) {
    for (const LessonWords &piece : wordsOf(step))
      if (piece.text.find(needed.title) != std::string::npos)
        return true;
    for (const TermUse &use : termsIn(textOf(lesson, step), glossary))
      if (taught.contains(use.entry->term->name))
        return true;
  }
  return false;
}

TEST(Course, WhatALessonNeeds_ItSpeaksOf) {
  for (const Lesson &lesson : library().lessons)
    for (const Need &need : lesson.needs)
      EXPECT_TRUE(speaksOf(lesson, *library().find(need.id))) << lesson.id << " needs " << need.id;
}

} // namespace
} // namespace halfspace
