// The program's lessons as a course: nothing is used before it is taught.
#include "lessons/lesson/glossary.h"
#include "lessons/lesson/lesson_words.h"
#include "lessons/lesson/prose.h"
#include "lessons/lesson/shown.h"
#include "lessons/text.h"

#include <gtest/gtest.h>

#include <map>
#include <regex>
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
      text += "\n" + piece.text.written();
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
  const Glossary glossary(library());
  for (const Lesson &lesson : library().lessons) {
    std::set<std::string> known = termsOf(needsOf(lesson));
    for (const LessonStep &step : lesson.steps) {
      addTerms(step, known);
      const std::string text = textOf(lesson, step);
      std::set<std::string> unknown;
      for (const TermUse &use : glossary.usesIn(text))
        if (!known.contains(use.entry->term->name))
          unknown.insert(use.entry->term->name + " (of " + use.entry->lesson->id + ")");
      for (const std::string &term : unknown)
        ADD_FAILURE() << lesson.id << ", “" << step.title << "”: " << term;
    }
  }
}

/// Whether a lesson speaks of what another teaches: by a term, or by its title.
bool speaksOf(const Lesson &lesson, const Lesson &needed) {
  const Glossary glossary(library());
  const std::set<std::string> taught = termsOf({&needed});
  for (const LessonStep &step : lesson.steps) {
    for (const LessonWords &piece : wordsOf(step))
      if (piece.text.written().find(needed.title) != std::string::npos)
        return true;
    for (const TermUse &use : glossary.usesIn(textOf(lesson, step)))
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

/// The letters of a formula in plain text, with their indices: P₀, n_E, λ. Words as cos are none.
std::set<std::string> lettersIn(const std::string &formula) {
  static const std::regex letter("[a-z]{2,}|(?:[A-Za-z]|[\xCE\xCF][\x80-\xBF])"
                                 "(?:\xE2\x82[\x80-\x9C]|_[A-Za-z0-9]+|⊥|′)*");
  static const std::regex word("[a-z]{2,}");
  std::set<std::string> letters;
  for (std::sregex_iterator found(formula.begin(), formula.end(), letter), end; found != end; ++found)
    if (!std::regex_match(found->str(), word))
      letters.insert(found->str());
  return letters;
}

/// Without its indices: P of P₁, for where one is known another is.
std::string baseOf(std::string_view letter) {
  const std::size_t bytes = static_cast<unsigned char>(letter.front()) < 0x80 ? 1 : 2;
  return std::string(letter.substr(0, bytes));
}

void addBases(const std::set<std::string> &letters, std::set<std::string> &bases) {
  for (const std::string &letter : letters)
    bases.insert(baseOf(letter));
}

/// The letters of the scene, which the picture shows.
void addLettersOfScene(const Lesson &lesson, std::set<std::string> &known) {
  for (const Entry &entry : lesson.scene.entries) {
    known.insert(baseOf(entry.name));
    if (const auto *object = std::get_if<Object>(&entry.content))
      for (const auto &coordinate : coordinatesOf(*object))
        known.insert(baseOf(coordinate.name));
  }
}

void addLettersOfLines(const Lesson &lesson, const LessonStep &step, std::set<std::string> &known) {
  for (const WorkingLine &line : shownIn(step, evaluate(lesson.scene)).working.lines)
    addBases(lettersIn(plainText(line)), known);
}

/// Of all formulas among the words of a step, but for notes: they quote others' letters.
std::set<std::string> lettersInWords(const Lesson &lesson, const LessonStep &step) {
  std::set<std::string> letters;
  for (const LessonWords &piece : wordsOf(step))
    if (piece.field != "note" && piece.field != "means")
      for (const MarkdownFormula &formula : piece.text.markdown().formulas)
        for (const MarkdownFormula::Side &side : formula.sides)
          if (!side.isLive)
            letters.merge(lettersIn(plainProse(side.text, lesson.macros)));
  return letters;
}

/// Letters that the words of a step say the meaning of, where no line and no picture does before.
const std::map<std::string, std::set<std::string>> &lettersSaidInWords() {
  static const std::map<std::string, std::set<std::string>> letters{
      {"clipping", {"k"}},                        // the number of a polygon's corners
      {"closest-points", {"G"}},                  // the closest point of h
      {"cross-product", {"n"}},                   // u×v, as the same sentence says
      {"determinant", {"a", "c", "s"}},           // a rule for any vectors; a number
      {"misprints", {"O", "R"}},                  // the origin; a printed letter
      {"plane-implicit", {"a", "b", "d", "k"}},   // the numbers of any equation; any factor but 0
      {"plane-parametric", {"d"}},                // the constant of any equation
      {"plane-plane", {"g"}},                     // the line that the picture shows
      {"pluecker-lines", {"G", "k", "α", "μ"}},   // the nearest point of h; steps; an angle; a factor
      {"pluecker-planes", {"S"}},                 // the common point
      {"point-line", {"F"}},                      // the foot
      {"ray-plane-picture", {"O"}},               // the origin
      {"ray-plane-substitution", {"H"}},          // the first hit
      {"ray-polygon-pluecker", {"I"}},            // where the line meets the plane
      {"ray-triangle-cramer", {"I", "λ"}},        // where the line meets the plane; steps along the ray
      {"ray-triangle-perp", {"I"}},               // where the line meets the plane
      {"shadow", {"L", "M"}},                     // the lamp's shadow; the midpoint
      {"signed-distance", {"F", "a", "b", "c"}}}; // the foot; the coordinates of any normal
  return letters;
}

TEST(Course, NoLetterIsUsedBeforeItIsSaidWhatItIs) {
  std::map<std::string, std::set<std::string>> unknown; // by lesson
  for (const Lesson &lesson : library().lessons) {
    std::set<std::string> known{"x", "y", "z"};
    for (const Lesson *needed : needsOf(lesson))
      for (const LessonStep &step : needed->steps)
        addLettersOfLines(*needed, step, known);
    addLettersOfScene(lesson, known);
    for (const LessonStep &step : lesson.steps) {
      addLettersOfLines(lesson, step, known);
      for (const std::string &letter : lettersInWords(lesson, step))
        if (known.insert(baseOf(letter)).second) // told once
          unknown[lesson.id].insert(letter);
    }
  }
  EXPECT_EQ(unknown, lettersSaidInWords());
}

} // namespace
} // namespace halfspace
