#include "app/batch/figure_mark.h"

#include "widgets/carriers/carrier.h"
#include "widgets/scene/png.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

struct MarkedFile {
  std::string ending;
  std::string content;
};

std::vector<MarkedFile> files() {
  const RgbaImage picture{2, 1, std::vector<std::uint8_t>(8, 200)};
  return {{".png", withSession(*pngOf(picture), "{}")},
          {".svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"></svg>\n"},
          {".pdf", "%PDF-1.7\nxref\n%%EOF\n"},
          {".tex", "\\begin{tikzpicture}\n\\end{tikzpicture}\n"}};
}

TEST(FigureMark, OfTheSame_IsKnownAgain) {
  for (const auto &[ending, content] : files()) {
    SCOPED_TRACE(ending);
    const std::string file = marked(content, ending, "Q=1");
    EXPECT_NE(file, content);
    EXPECT_TRUE(isMarked(file, ending, "Q=1"));
    EXPECT_EQ(file, marked(content, ending, "Q=1")) << "the same bytes again";
  }
}

TEST(FigureMark, OfAnythingElse_IsNot) {
  for (const auto &[ending, content] : files()) {
    SCOPED_TRACE(ending);
    const std::string file = marked(content, ending, "Q=1");
    EXPECT_FALSE(isMarked(file, ending, "Q=2"));
    EXPECT_FALSE(isMarked(content, ending, "Q=1"));
    EXPECT_FALSE(isMarked("", ending, "Q=1"));
    EXPECT_FALSE(isMarked(file + "x", ending, "Q=1"));
    for (std::size_t at = 0; at < file.size(); ++at) {
      std::string changed = file;
      changed[at] = static_cast<char>(changed[at] ^ 1);
      EXPECT_FALSE(isMarked(changed, ending, "Q=1")) << at;
      EXPECT_FALSE(isMarked(file.substr(0, at), ending, "Q=1")) << at;
    }
  }
}

TEST(FigureMark, OfAFormatWithoutAPlaceForIt_IsNone) {
  EXPECT_EQ(marked("content", ".xyz", "Q=1"), "content");
  EXPECT_FALSE(isMarked("content", ".xyz", "Q=1"));
}

TEST(FigureMark, InAPicture_LeavesItsSessionReadable) {
  const std::string png = marked(files().front().content, ".png", "Q=1");
  EXPECT_EQ(*carrierOf(png)->take(png), "{}");
}

TEST(ProgramFingerprint, IsTheSameForTheSameProgram) {
  EXPECT_EQ(programFingerprint().size(), 64U);
  EXPECT_EQ(programFingerprint(), programFingerprint());
}

} // namespace
} // namespace halfspace
