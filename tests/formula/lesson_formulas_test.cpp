// Every formula in the words of our lessons: read, laid out with all its glyphs, and broken into lines.
#include "lessons/lesson/lesson_words.h"
#include "tests/formula/laid_out.h"
#include "widgets/formula/break_lines.h"

#include <set>

namespace halfspace::math {
namespace {

struct LessonFormula {
  std::string latex;
  std::string where; ///< file and line
  const Macros *macros;
};

const LessonLibrary &library() {
  static const LessonLibrary lessons = readLessons(LESSON_FOLDER);
  return lessons;
}

/// What stands between dollars, each formula once for a lesson.
std::vector<LessonFormula> formulas() {
  std::vector<LessonFormula> found;
  for (const Lesson &lesson : library().lessons) {
    std::set<std::string> known;
    for (const LessonWords &words : wordsOf(lesson)) {
      const std::string &text = words.text.written();
      for (std::size_t open = text.find('$'); open != std::string::npos;) {
        const std::size_t close = text.find('$', open + 1);
        if (close == std::string::npos)
          break;
        const std::string latex = text.substr(open + 1, close - open - 1);
        if (!latex.empty() && known.insert(latex).second)
          found.push_back(
              {latex, lesson.file + ":" + std::to_string(words.lineAt(open)) + " " + latex, &lesson.macros});
        open = text.find('$', close + 1);
      }
    }
  }
  return found;
}

/// The formula as it is laid out; the test fails where it cannot be read.
Layout laidOut(const LessonFormula &formula, Style style) {
  const auto row = readLatex(formula.latex, *formula.macros);
  if (const auto *error = std::get_if<ReadError>(&row)) {
    ADD_FAILURE() << formula.where << ": " << error->sentence;
    return {};
  }
  return layOut(std::get<Row>(row), fonts(), style);
}

TEST(LessonFormulas, AreMany) { EXPECT_GT(formulas().size(), 50U); }

TEST(LessonFormulas, LaidOutInTextAndDisplay_HaveAllTheirGlyphs) {
  for (const LessonFormula &formula : formulas())
    for (const Style style : {Style::Text, Style::Display}) {
      const Layout layout = laidOut(formula, style);
      EXPECT_FALSE(layout.glyphs.empty()) << formula.where;
      EXPECT_GT(layout.width, 0) << formula.where;
      for (const PlacedGlyph &glyph : layout.glyphs)
        EXPECT_NE(glyph.glyph, 0U) << formula.where;
    }
}

TEST(LessonFormulas, InLinesOfText_AreNotTooTallForThem) {
  // Two lines of text: what is taller tears the paragraph apart and belongs on a line of its own.
  for (const LessonFormula &formula : formulas()) {
    const Layout layout = laidOut(formula, Style::Text);
    EXPECT_LT(layout.ascent + layout.depth, 2.8) << formula.where;
  }
}

TEST(LessonFormulas, InANarrowPanel_AreBrokenWithoutLosingAnything) {
  constexpr double narrow = 12; // em
  for (const LessonFormula &formula : formulas()) {
    const Layout whole = laidOut(formula, Style::Display);
    LineRules rules;
    rules.width = narrow;
    const Layout broken = breakLines(whole, rules);
    EXPECT_EQ(broken.glyphs.size(), whole.glyphs.size()) << formula.where;
    EXPECT_EQ(broken.lines.size() > 1, broken.depth > whole.depth + rounding) << formula.where;
    EXPECT_LE(broken.width, std::max(whole.width, narrow) + rounding) << formula.where;
  }
}

} // namespace
} // namespace halfspace::math
