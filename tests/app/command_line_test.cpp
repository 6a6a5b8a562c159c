// What the command line tells of itself: help, manual page and completion are of one mind.
#include "tests/app/command_fixture.h"

#include <regex>
#include <set>

namespace halfspace {
namespace {

/// The names of options that a text has, as --step.
std::set<std::string> optionsIn(const std::string &text) {
  const std::regex name("--[a-z][a-z-]*");
  std::set<std::string> names;
  for (auto each = std::sregex_iterator(text.begin(), text.end(), name); each != std::sregex_iterator();
       ++each)
    names.insert(each->str());
  return names;
}

TEST_F(Program, CompleteWords_OffersWhatMayStandThere) {
  const std::pair<const char *, const char *> cases[] = {
      {"exp", "file\nexplain\n"},
      {"explain signed-d", "file\nsigned-distance\n"},
      {"explain signed-distance --format ''", "\ntext\nlatex\nmathml\njson\n"},
      {"render signed-distance --theme = da", "\ndark\n"},
      {"render signed-distance --theme =", "\nlight\ndark\nprint\nprojector\n"},
      {"render signed-distance -o ''", "file\n"},
      {"explain signed-distance --set ''", "\n"},
      {"lessons --j", "\n--json\n"},
      {"explain x --lessons ''", "directory\n"},
      {"eval ''", "file\n"},
      {"read-m", "file\n"},
  };
  for (const auto &[words, offered] : cases) {
    const Ran ran = run("complete-words " + std::string(words));
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(ran.out, offered) << words;
  }
}

TEST_F(Program, CompleteWords_OffersOwnLessons) {
  EXPECT_EQ(run("new-lesson my-first").status, 0);
  EXPECT_EQ(run("complete-words --lessons . explain my-f").out, "file\nmy-first\n");
}

TEST_F(Program, ManualPageAndCompletion_KnowEveryOptionThatIsInAHelp) {
  std::string page = run("manual-page").out;
  page = std::regex_replace(page, std::regex(R"(\\-)"), "-");
  const std::set<std::string> inPage = optionsIn(page);
  for (const std::string command : {"", "lessons", "new-lesson", "constructions", "check", "explain",
                                    "render", "handout", "animate", "eval"}) {
    const Ran completed = run("complete-words " + command + " --");
    const std::set<std::string> offered = optionsIn(completed.out);
    for (const std::string &option : optionsIn(run(command + " --help").out)) {
      EXPECT_TRUE(inPage.contains(option)) << command << " " << option;
      EXPECT_TRUE(offered.contains(option)) << command << " " << option;
    }
    EXPECT_NE(page.find(command), std::string::npos) << command;
  }
}

} // namespace
} // namespace halfspace
