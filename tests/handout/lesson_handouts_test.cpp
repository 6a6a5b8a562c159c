// Every lesson as a handout, on each paper and in one column and two; what other programs find in the files.
#include "lessons/construction/line_text.h"
#include "lessons/lesson/filled_markdown.h"
#include "tests/handout/handouts.h"
#include "tests/program_test.h"
#include "tests/test_name.h"
#include "widgets/handout/fill_pages.h"
#include "widgets/handout/handout_text.h"
#include "widgets/handout/set_blocks.h"

#include <algorithm>
#include <cctype>

namespace halfspace {
namespace {

std::vector<std::string> lessonIds() {
  std::vector<std::string> ids;
  for (const Lesson &lesson : library().lessons)
    ids.push_back(lesson.id);
  return ids;
}

class LessonHandouts : public ProgramTest, public testing::WithParamInterface<std::string> {
protected:
  [[nodiscard]] const Lesson &lesson() const { return *library().find(GetParam()); }
  /// Each paper with one column and two.
  template <class Visit> void forEachLook(Visit visit) const {
    const WholeHandout handout(lesson());
    for (const HandoutPaper paper : {HandoutPaper::A4, HandoutPaper::Letter})
      for (const int columns : {1, 2}) {
        SCOPED_TRACE(columns);
        HandoutRequest request = handout.request();
        request.paper = paper;
        request.columns = columns;
        visit(request);
      }
  }
};
INSTANTIATE_TEST_SUITE_P(All, LessonHandouts, testing::ValuesIn(lessonIds()), test::testName);

TEST_P(LessonHandouts, AreWithoutFault_AndTheSameBytesAgain) {
  const bool isChecked = has("qpdf");
  forEachLook([&](const HandoutRequest &request) {
    const std::string file = handoutOf(request, handoutFonts());
    EXPECT_EQ(file, handoutOf(request, handoutFonts()));
    EXPECT_EQ(file.find("/Subtype/Image"), std::string::npos);
    if (!isChecked)
      return;
    write("handout.pdf", file);
    const Ran checked = shell("qpdf --check handout.pdf >.out 2>.err");
    EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
  });
}

/// The ink of a thing on its page.
std::vector<math::Rectangle> inkOf(const SetThing &thing) {
  std::vector<math::Rectangle> boxes;
  const auto addGlyph = [&](const math::FontFace &face, math::GlyphId glyph, double x, double y,
                            double size) {
    const math::GlyphMetrics &metrics = face.metrics(glyph);
    boxes.push_back({x + metrics.left * size, y - metrics.height * size, metrics.width * size,
                     (metrics.height + metrics.depth) * size});
  };
  std::visit(
      Overloaded{[&](const TextPart &text) {
                   for (const TextPart::Glyph &glyph : text.glyphs)
                     if (text.face->metrics(glyph.glyph).width > 0) // no space
                       addGlyph(*text.face, glyph.glyph, text.start.x + glyph.x, text.start.y, text.size);
                 },
                 [&](const FormulaPart &part) {
                   for (const math::PlacedGlyph &glyph : part.formula->glyphs)
                     addGlyph(math::fonts().face(glyph.font), glyph.glyph, part.start.x + glyph.x * part.size,
                              part.start.y + glyph.y * part.size, glyph.size * part.size);
                 },
                 [&](const RulePart &rule) { boxes.push_back(rule.box); },
                 [&](const FigurePart &figure) {
                   const glm::dvec2 size = figure.drawing->size;
                   boxes.push_back({figure.at.x, figure.at.y, size.x, size.y});
                 }},
      thing.content);
  return boxes;
}

/// To tell which thing is meant.
std::string nameOf(const SetThing &thing) {
  return std::visit(
      Overloaded{[](const FormulaPart &part) { return part.plain; },
                 [](const TextPart &text) { return std::to_string(text.glyphs.size()) + " glyphs"; },
                 [](const RulePart &) { return std::string("a rule"); },
                 [](const FigurePart &) { return std::string("a figure"); }},
      thing.content);
}

/// Lengths of letters that lean over and of arrows that stand above are less than this.
constexpr double slack = 2.5;

void expectWithinMargins(const HandoutRequest &request) {
  const HandoutLook look = handoutLook(request.paper, request.columns);
  const HandoutText text = handoutText(request, look, math::fonts());
  ReadingOrder order;
  const std::size_t root = order.add("Document", {});
  auto front = setBlocks(text.front, look.textWidth(), look, handoutFonts(), order, root);
  auto body = setBlocks(text.body, look.columnWidth(), look, handoutFonts(), order, root);
  for (const FilledPage &page : fillPages(std::move(front), std::move(body), look)) {
    ASSERT_FALSE(page.empty());
    EXPECT_FALSE(page.back().chunk.keepsWithNext); // as a heading does
    for (const PlacedChunk &placed : page)
      for (const SetThing &thing : placed.chunk.things)
        for (const math::Rectangle &box : inkOf(moved(thing, placed.at))) {
          EXPECT_GE(box.x, look.side - slack) << nameOf(thing);
          EXPECT_LE(box.right(), look.page.x - look.side + slack) << nameOf(thing);
          EXPECT_GE(box.y, look.top - slack) << nameOf(thing);
          EXPECT_LE(box.bottom(), look.page.y - look.bottom + slack) << nameOf(thing);
        }
  }
}

TEST_P(LessonHandouts, HaveNothingBeyondTheirMargins) { forEachLook(expectWithinMargins); }

TEST(Handout, OfWhatIsNestedDeep_AndOfWhatIsTooLong_StaysWithinItsMargins) {
  std::string words;
  for (int depth = 0; depth < 12; ++depth)
    words += std::string(static_cast<std::size_t>(2 * depth), ' ') + "- deep and deeper\n";
  words += "\n| " + std::string(300, 'x') + " | y |\n|---|---|\n| z | z |\n\n    " + std::string(300, 'c') +
           "\n\nAn address: " + std::string(300, 'a') + "\n\n$$" + std::string(150, 'b') +
           "$$\n\nIn a line $" + std::string(150, 'd') + "$ too.\n";
  const auto lesson = parseLesson("---\nid: own\ntitle: " + std::string(200, 't') +
                                      "\nscene:\n  - {name: Q, point: [1, 2, 3]}\n---\n## One\n" + words +
                                      "\n```lines\nnone\n```\n",
                                  "own.md");
  ASSERT_TRUE(lesson) << lesson.problem().text();
  const WholeHandout handout(*lesson);
  for (const int columns : {1, 2}) {
    HandoutRequest request = handout.request();
    request.columns = columns;
    expectWithinMargins(request);
  }
}

std::string withoutSpaces(std::string text) {
  for (const char *space : {"\xC2\xA0", "\xE2\x80\x82", "\xE2\x80\x83", "\xE2\x80\x89"}) // of Unicode
    for (auto place = text.find(space); place != std::string::npos; place = text.find(space))
      text.erase(place, std::string(space).size());
  text.erase(std::remove_if(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c); }),
             text.end());
  return text;
}

/// The words of a lesson's blocks in plain text, piece by piece in the order of reading.
class LessonPieces {
public:
  explicit LessonPieces(const WholeHandout &handout) : m_handout(handout) {}

  std::vector<std::string> all() {
    int number = 0;
    for (const LessonStep &step : m_handout.lesson.steps) {
      m_pieces.push_back(std::to_string(++number) + step.title);
      const Shown shown = shownIn(step, m_handout.evaluation);
      std::size_t line = 0;
      std::size_t block = 0;
      for (const StepBlock &each : step.blocks)
        if (std::holds_alternative<StepLines>(each))
          for (const std::size_t end = line + shown.linesIn.at(block++); line < end; ++line)
            add(shown.working.lines[line]);
        else
          std::visit([this](const auto &content) { add(content); }, each);
    }
    return std::move(m_pieces);
  }

private:
  void add(const WorkingLine &line) {
    m_pieces.push_back(formulaText({&line, true}, DocumentFormat::PlainText));
    m_pieces.push_back(line.sentence);
  }
  void add(const StepWords &words) { add(words.text); }
  void add(const StepNote &note) {
    m_pieces.push_back(note.title);
    add(note.words.text);
  }
  void add(const Task &task) {
    add(task.instruction);
    add(task.answer);
  }
  void add(const Prediction &prediction) {
    add(prediction.question);
    for (const Prediction::Choice &choice : prediction.choices)
      add(choice.text);
    add(prediction.reason);
  }
  template <class Other> void add(const Other &) {}

  void add(const MarkdownText &text) {
    const FilledMarkdown filled = filledIn(text.markdown(), [&](const std::string &name) {
      return liveValue(name, m_handout.evaluation.scene, m_handout.evaluation);
    });
    for (const MarkdownBlock &block : filled.blocks)
      add(block, filled);
  }
  void add(const MarkdownBlock &block, const FilledMarkdown &filled) {
    std::string piece;
    for (const MarkdownSpan &span : block.spans)
      piece += span.kind == MarkdownSpan::Kind::Formula
                   ? plainText(filled.formulas[span.formula], m_handout.lesson.macros)
                   : span.text;
    m_pieces.push_back(piece);
    for (const MarkdownBlock &child : block.children)
      add(child, filled);
  }

  const WholeHandout &m_handout;
  std::vector<std::string> m_pieces;
};

TEST_P(LessonHandouts, HaveTheWordsOfTheirLesson_InTheirOrder) {
  if (!has("pdftotext"))
    GTEST_SKIP() << "pdftotext is not installed";
  const WholeHandout handout(lesson());
  HandoutRequest request = handout.request();
  request.hasAnswers = true;
  request.drawFigure = [](const Figure &, const FigureSize &) { return std::vector<Drawing>(); };
  write("handout.pdf", handoutOf(request, handoutFonts()));
  const Ran ran = shell("pdftotext -raw handout.pdf - >.out 2>.err");
  std::string found;
  std::size_t number = 0;
  const std::string title = withoutSpaces(lesson().title);
  for (std::size_t begin = 0; begin < ran.out.size();) { // the pages without head and number, which come last
    const std::size_t end = std::min(ran.out.find('\f', begin), ran.out.size());
    std::string page = withoutSpaces(ran.out.substr(begin, end - begin));
    ++number;
    const std::string margins = (number > 1 ? title : "") + std::to_string(number);
    ASSERT_TRUE(page.ends_with(margins)) << page;
    found += page.substr(0, page.size() - margins.size());
    begin = end + 1;
  }
  std::size_t place = 0;
  for (const std::string &piece : LessonPieces(handout).all()) {
    const std::string wanted = withoutSpaces(piece);
    const std::size_t next = found.find(wanted, place);
    ASSERT_NE(next, std::string::npos) << piece << "\nbehind: " << found.substr(place, 200);
    place = next + wanted.size();
  }
}

std::size_t countOf(const std::string &part, const std::string &text) {
  std::size_t count = 0;
  for (auto place = text.find(part); place != std::string::npos; place = text.find(part, place + 1))
    ++count;
  return count;
}

TEST_P(LessonHandouts, AreTagged_WithABookmarkForEachStep) {
  const WholeHandout handout(lesson());
  const std::string file = handoutOf(handout.request(), handoutFonts());
  EXPECT_EQ(countOf("/S/Document/", file), 1U);
  EXPECT_EQ(countOf("/S/H1/", file), 1U);
  EXPECT_EQ(countOf("/S/H2/", file), lesson().steps.size());
  EXPECT_EQ(countOf("/XYZ ", file), lesson().steps.size());
  EXPECT_GT(countOf("/S/P/", file), lesson().steps.size());
  EXPECT_GT(countOf("/S/Figure/", file), 0U);
  EXPECT_EQ(countOf("/S/Figure/", file), countOf("/Placement/Block/BBox[", file));
  EXPECT_EQ(countOf("/S/Figure/", file), countOf("/S/Caption/", file));
  EXPECT_GT(countOf("/S/Formula/", file), 0U);
  EXPECT_EQ(countOf("/S/Formula/", file), countOf("]/ActualText<", file));
  for (const char *once : {"/Lang(en)", "/MarkInfo<</Marked true>>", "/DisplayDocTitle true", "/Title<FEFF"})
    EXPECT_GE(countOf(once, file), 1U) << once;
  EXPECT_EQ(countOf("/Alt<FEFF>", file), 0U);
}

TEST(Handout, OfALessonWithATable_HasATable) {
  const Lesson *withTable = library().find("cross-product");
  const std::string file = handoutOf(WholeHandout(*withTable).request(), handoutFonts());
  EXPECT_GE(countOf("/S/Table/", file), 1U);
  EXPECT_GE(countOf("/S/TR/", file), 2U);
  EXPECT_GE(countOf("/S/TD/", file), 2U);
}

TEST(TextFaces, OfAFolderWithoutThem_AreNone) { EXPECT_FALSE(math::readTextFaces("/nowhere")); }

} // namespace
} // namespace halfspace
