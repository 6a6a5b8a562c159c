// SVG pictures from other hands.
#include "lessons/text.h"
#include "tests/carriers/pictures.h"

namespace halfspace {
namespace {

using test::sentenceOf;

Result<std::string> taken(const std::string &svg) { return test::carrierCalled("SVG").take(svg); }

std::string carrying() {
  return test::carrierCalled("SVG").put(test::vectorPicture(".svg"), test::someSession());
}

TEST(SvgCarrier, InAnElementOfAnotherName_AndLaidOutAnew_IsFound) {
  std::string svg = replacedAll(carrying(), "<session", "<ns7:session");
  svg = replacedAll(svg, "</session", "\n  </ns7:session");
  const auto place = svg.find("halfspace-session:") + 30;
  EXPECT_EQ(sentenceOf(taken(svg.insert(place, "\r\n\t  "))), "taken: " + test::someSession());
}

TEST(SvgCarrier, WhoseTextIsDamaged_SaysSo) {
  const std::string damaged = "The scene in this picture is damaged, and cannot be read any more.";
  const std::string svg = carrying();
  const auto place = svg.find("halfspace-session:") + 18;
  EXPECT_EQ(sentenceOf(taken(svg.substr(0, place))), damaged);
  EXPECT_EQ(sentenceOf(taken(svg.substr(0, place + 40))), damaged);
  EXPECT_EQ(sentenceOf(taken(std::string(svg).insert(place + 20, "&amp;"))), damaged);
  EXPECT_EQ(sentenceOf(taken(std::string(svg).replace(place + 20, 2, "AA"))), damaged);
}

TEST(SvgCarrier, OfAPictureThatHasNoEnd_LeavesItAsItIs) {
  EXPECT_EQ(test::carrierCalled("SVG").put("<svg>", test::someSession()), "<svg>");
}

} // namespace
} // namespace halfspace
