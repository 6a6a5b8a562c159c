#include "tests/formula/laid_out.h"

#include <array>
#include <fstream>
#include <iterator>

namespace halfspace::math {
namespace {

TEST(FontFace, BytesThatAreNoFont_AreRefused) {
  constexpr std::array<std::byte, 4> bytes{};
  EXPECT_FALSE(FontFace::fromMemory(bytes));
  EXPECT_FALSE(FontFace::fromMemory({}));
  EXPECT_FALSE(FontFace::fromFile("/nowhere/font.otf"));
}

TEST(FontFace, FromMemory_IsTheSameAsFromItsFile) {
  std::ifstream stream(TEXT_FONT, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  const auto face = FontFace::fromMemory(std::as_bytes(std::span(bytes)));
  ASSERT_TRUE(face);
  const auto fromFile = FontFace::fromFile(TEXT_FONT);
  ASSERT_TRUE(fromFile);
  EXPECT_EQ(face->glyph(U'ж'), fromFile->glyph(U'ж'));
  EXPECT_NE(face->glyph(U'ж'), 0U);
}

TEST(FontFace, Metrics_AreThoseOfTheOutline) {
  const FontFace &face = fonts().math.face();
  const GlyphId glyph = face.glyph('x');
  double right = 0;
  double top = 0;
  for (const PathStep &step : face.outline(glyph)) {
    const PathStep::Point &end = step.kind == PathStep::Kind::Cubic ? step.c : step.a;
    right = std::max(right, end.x);
    top = std::max(top, end.y);
  }
  const GlyphMetrics &metrics = face.metrics(glyph);
  EXPECT_NEAR(metrics.left + metrics.width, right, 0.002);
  EXPECT_NEAR(metrics.height, top, 0.002);
  EXPECT_GT(metrics.advance, metrics.width);
}

TEST(FontFace, AnOutline_ClosesEachContourItBegins) {
  const FontFace &face = fonts().math.face();
  int open = 0;
  for (const PathStep &step : face.outline(face.glyph('8'))) {
    open += step.kind == PathStep::Kind::Move ? 1 : step.kind == PathStep::Kind::Close ? -1 : 0;
    EXPECT_TRUE(open == 0 || open == 1);
  }
  EXPECT_EQ(open, 0);
}

TEST(FontFace, ShapedWords_AreAsWideAsTheirLettersButForKerning) {
  const FontFace &face = fonts().math.face();
  const ShapedText text = face.shape("area");
  ASSERT_EQ(text.glyphs.size(), 4U);
  EXPECT_NEAR(text.width,
              2 * face.metrics(face.glyph('a')).advance + face.metrics(face.glyph('r')).advance +
                  face.metrics(face.glyph('e')).advance,
              0.1);
}

TEST(MathFont, AFaceWithoutAMathTable_IsRefused) {
  auto face = FontFace::fromFile(TEXT_FONT);
  ASSERT_TRUE(face);
  EXPECT_FALSE(MathFont::from(std::move(*face)));
  EXPECT_FALSE(readMathFonts(TEXT_FONT));
}

TEST(MathFont, Constants_AreInEm) {
  EXPECT_NEAR(axisHeight(), 0.25, 0.001);
  EXPECT_NEAR(fonts().math.factor(HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN), 0.7, 0.001);
}

TEST(MathFont, AStretchedParenthesis_IsAtLeastAsLongAsAskedFor) {
  const MathFont &font = fonts().math;
  const GlyphId glyph = font.face().glyph('(');
  double last = 0;
  for (double length = 0.5; length < 20; length += 0.37) {
    const Stretched stretched = font.stretch(glyph, length, Direction::Vertical);
    EXPECT_GE(stretched.length, length - 0.002);
    EXPECT_GE(stretched.length, last - 0.002);
    last = stretched.length;
  }
}

TEST(MathFont, TheParts_OverlapAndReachFromEndToEnd) {
  const MathFont &font = fonts().math;
  const Stretched stretched = font.stretch(font.face().glyph('{'), 9, Direction::Vertical);
  ASSERT_GT(stretched.parts.size(), 3U);
  double end = 0;
  for (const StretchPart &part : stretched.parts) {
    const GlyphMetrics &metrics = font.face().metrics(part.glyph);
    EXPECT_LE(part.at, end + 0.002);
    end = part.at + metrics.height + metrics.depth;
  }
  EXPECT_NEAR(end, stretched.length, 0.002);
}

TEST(MathFont, AWideHat_IsNoWiderThanItsBase) {
  const MathFont &font = fonts().math;
  const GlyphId hat = font.face().glyph(0x302);
  const GlyphId wide = font.widestWithin(hat, 1.5);
  EXPECT_NE(wide, hat);
  EXPECT_LE(font.face().metrics(wide).width, 1.5);
  EXPECT_EQ(font.widestWithin(hat, 0.01), hat);
}

TEST(MathFont, APrime_HasAFormForScripts) {
  const MathFont &font = fonts().math;
  const GlyphId prime = font.face().glyph(U'′');
  EXPECT_NE(font.scriptForm(prime, 1), prime);
  const GlyphId equals = font.face().glyph('=');
  EXPECT_EQ(font.scriptForm(equals, 1), equals);
}

TEST(FontFace, OfACharacterItLacks_GivesGlyphZeroAndItsSize) {
  const FontFace &face = fonts().math.face();
  EXPECT_EQ(face.glyph(U'ж'), 0U);
  EXPECT_EQ(face.glyph(0x10FFFF), 0U);
  EXPECT_GT(face.metrics(0).advance, 0) << "a box that says that something is missing";
  EXPECT_EQ(face.metrics(static_cast<GlyphId>(face.glyphCount()) + 7).advance, face.metrics(0).advance);
}

TEST(FontFace, OfASpace_HasRoomAndNoInk) {
  const FontFace &face = fonts().math.face();
  const GlyphId space = face.glyph(' ');
  EXPECT_GT(face.metrics(space).advance, 0.2);
  EXPECT_TRUE(face.outline(space).empty());
}

TEST(FontFace, CutOffAnywhere_IsReadOrRefusedButNeverBeyondItsEnd) {
  std::ifstream stream(TEXT_FONT, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  for (std::size_t size = 1; size < bytes.size(); size = size * 3 + 1) {
    const std::vector<char> part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    if (const auto face = FontFace::fromMemory(std::as_bytes(std::span(part)))) {
      EXPECT_LE(face->metrics(face->glyph('x')).advance, 10);
      EXPECT_LT(face->outline(face->glyph('x')).size(), 10000U);
    }
  }
}

TEST(FontFace, ShapedWords_GoFromLeftToRightAlsoInOtherScripts) {
  ASSERT_TRUE(fonts().text);
  const ShapedText text = fonts().text->shape("длина x");
  ASSERT_EQ(text.glyphs.size(), 7U);
  for (std::size_t i = 1; i < text.glyphs.size(); ++i)
    EXPECT_GT(text.glyphs[i].x, text.glyphs[i - 1].x);
  EXPECT_GT(text.width, text.glyphs.back().x);
  EXPECT_EQ(fonts().text->shape("").width, 0);
}

TEST(MathFont, SlantedLetters_AreCorrectedForAndUprightOnesAreNot) {
  const MathFont &font = fonts().math;
  EXPECT_GT(font.italicsCorrection(font.face().glyph(inAlphabet('f', Alphabet::Italic))), 0.05);
  EXPECT_EQ(font.italicsCorrection(font.face().glyph('0')), 0);
}

TEST(MathFont, TheMiddleOfAnAccent_LiesOverTheLetter) {
  const MathFont &font = fonts().math;
  for (const char32_t letter : {U'u', U'n', U'B', U'f'}) {
    const GlyphId glyph = font.face().glyph(inAlphabet(letter, Alphabet::Italic));
    EXPECT_GT(font.accentAttachment(glyph), 0) << static_cast<char>(letter);
    EXPECT_LT(font.accentAttachment(glyph), 1.3 * font.face().metrics(glyph).advance);
  }
}

TEST(MathFont, FormsForScriptsOfScripts_AreFormsOfTheSameGlyph) {
  const MathFont &font = fonts().math;
  const GlyphId prime = font.face().glyph(U'′');
  EXPECT_NE(font.scriptForm(prime, 2), prime);
  EXPECT_GT(font.face().metrics(font.scriptForm(prime, 2)).height, 0);
}

TEST(MathFont, AStretchedArrow_IsAtLeastAsLongAsAskedForAndItselfWhereItIsAlready) {
  const MathFont &font = fonts().math;
  const GlyphId arrow = font.face().glyph(U'→');
  EXPECT_EQ(font.stretch(arrow, 0.1, Direction::Horizontal).parts.front().glyph, arrow);
  for (const double length : {1.5, 3.0, 12.0})
    EXPECT_GE(font.stretch(arrow, length, Direction::Horizontal).length, length - 0.002);
}

TEST(MathFont, ALetterThatCannotGrow_StaysAsItIs) {
  const MathFont &font = fonts().math;
  const GlyphId letter = font.face().glyph('x');
  const Stretched stretched = font.stretch(letter, 9, Direction::Vertical);
  ASSERT_EQ(stretched.parts.size(), 1U);
  EXPECT_EQ(stretched.parts.front().glyph, letter);
  EXPECT_LT(stretched.length, 1);
}

} // namespace
} // namespace halfspace::math
