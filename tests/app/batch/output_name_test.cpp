#include "app/batch/output_name.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

using Values = std::map<std::string, std::string>;

/// The file of a name, or why it is none.
std::string filled(const std::string &typed, const Values &values = {}, bool hasFrames = false) {
  const auto name = OutputName::parse(typed, hasFrames);
  return name ? name->filled([&](const std::string &place) { return values.at(place); })
              : name.problem().sentence;
}

TEST(OutputName, WithPlaces_HasTheirValuesThere) {
  EXPECT_EQ(filled("a/{lesson}-{step:02}.svg", {{"lesson", "ray-box"}, {"step", "7"}}), "a/ray-box-07.svg");
  EXPECT_EQ(filled("{row:3}{row}", {{"row", "12"}}), "01212");
  EXPECT_EQ(filled("plain.png"), "plain.png");
  EXPECT_EQ(filled("100%.png"), "100%.png");
}

TEST(OutputName, OfFrames_TakesTheirNumberAsPrintfDoes) {
  EXPECT_EQ(filled("f/%04d.png", {{"frame", "7"}}, true), "f/0007.png");
  EXPECT_EQ(filled("f/%d.png", {{"frame", "7"}}, true), "f/7.png");
  EXPECT_EQ(filled("{lesson}/{frame:03}.png", {{"frame", "7"}, {"lesson", "a"}}, true), "a/007.png");
  EXPECT_EQ(filled("f/%04d.png"), "f/%04d.png") << "without frames it is a name as any other";
}

TEST(OutputName, FilledByStrangers_StaysInItsFolder) {
  const auto named = [](const std::string &value) { return filled("out/{Q}/{Q}.png", {{"Q", value}}); };
  EXPECT_EQ(named("../../etc"), "out/..-..-etc/..-..-etc.png");
  EXPECT_EQ(named(".."), "out/--/--.png");
  EXPECT_EQ(named("."), "out/-/-.png");
  EXPECT_EQ(named(""), "out/-/-.png");
  EXPECT_EQ(named("/1/2\n"), "out/-1-2-/-1-2-.png");
  EXPECT_EQ(named("α 1,5"), "out/α 1,5/α 1,5.png");
}

TEST(OutputName, WithABraceThatIsNoPlace_IsRefused) {
  for (const char *typed : {"a{", "{}", "{:02}", "{step:}", "{step:x}", "{step:99}", "{step:-1}"})
    EXPECT_NE(filled(typed, {{"step", "1"}}).find("is no place to be filled: write one as {step}"),
              std::string::npos)
        << typed;
}

TEST(OutputName, KnowsTheFolderThatIsNotFilled) {
  const auto folderOf = [](const char *typed) { return OutputName::parse(typed, false)->fixedFolder(); };
  EXPECT_EQ(folderOf("a/b/{lesson}/{step}.png"), "a/b");
  EXPECT_EQ(folderOf("a/b-{lesson}/{step}.png"), "a");
  EXPECT_EQ(folderOf("{lesson}/a.png"), "");
  EXPECT_EQ(folderOf("/{lesson}/a.png"), "/");
  EXPECT_EQ(folderOf("a/b.png"), "a");
}

} // namespace
} // namespace halfspace
