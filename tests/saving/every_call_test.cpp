// Each system call of a save fails in turn, or the program is killed there: the old content or the new one is
// whole, and whoever saved is told.
#include "tests/program_test.h"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <set>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace halfspace {
namespace {

namespace fs = std::filesystem;

/// What stands there before.
enum class Before { Nothing, AFile, ALink };

struct Saved {
  std::string kind; ///< as save_something takes it
  Before before;
};

/// For the test's name in ctest.
void PrintTo(const Saved &saved, std::ostream *out) { *out << saved.kind; }

struct Call {
  std::string name;
  std::string place; ///< in the folder, which itself is a dot
  [[nodiscard]] std::string text() const { return name + " " + place; }
};

/// A call that may fail without a word: the save goes well all the same.
struct Silent {
  std::string_view name;
  std::string_view placeBegins;
  std::string_view placeEnds;
  std::string_view why;

  [[nodiscard]] bool is(const Call &call) const {
    return call.name == name && call.place.starts_with(placeBegins) && call.place.ends_with(placeEnds);
  }
};

constexpr Silent silentCalls[] = {
    {"close", "kept", "kept", "the folder was opened to be synced, which is done by then"},
    {"close", "real", "real", "likewise, where a link leads"},
    {"fchown", "kept", ".part", "not everyone may give files away: then only the group is given, or nothing"},
    {"fchown", "real", ".part", "likewise, where a link leads"},
    {"stat", "kept", "kept",
     "asks whether the folder is there: where nothing tells so it is made, which does tell"},
    {"stat", ".", ".", "likewise, of the folder that it is made in"},
    {"flock", "kept", ".lock", "the lock is the file, not what the kernel holds beside it"},
    {"fdatasync", "kept", ".lock", "a program whose lock is lost by a loss of power does not live any more"},
};

/// Why the call may fail without a word; empty: it may not.
std::string_view whySilent(const Call &call) {
  const auto silent = std::find_if(std::begin(silentCalls), std::end(silentCalls),
                                   [&](const Silent &each) { return each.is(call); });
  return silent == std::end(silentCalls) ? std::string_view() : silent->why;
}

/// What the call is likely to fail with: where bytes or names are to be stored, the disk is full.
int likelyError(const Call &call) {
  const std::set<std::string_view> storing{"write", "fsync", "fdatasync", "close", "openat", "mkdir"};
  return storing.contains(call.name) ? ENOSPC : EIO;
}

/// Qt, which makes the lock of unsaved work, does not tell why it cannot.
bool namesReason(const std::string &sentence, const Call &call) {
  if (call.place.ends_with(".lock") &&
      sentence.find("No file can be made in this folder: ") != std::string::npos)
    return true;
  return sentence.find("no room left on the disk") != std::string::npos ||
         sentence.find("Input/output error") != std::string::npos;
}

class EveryCall : public ProgramTest, public testing::WithParamInterface<Saved> {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    m_old = made("old");
    m_new = made("new");
    ASSERT_NE(m_old, m_new);
    ASSERT_GT(std::min(m_old.size(), m_new.size()), 4096U);
  }

  /// The save with a call that fails as the settings say.
  Ran save(const std::string &settings = "") {
    prepare();
    return shell("exec env LD_PRELOAD='" FAILING_CALLS "' FAILING_FOLDER='" + home().string() +
                 "' FAILING_REPORT=\"$PWD/calls\" " + settings + " '" SAVE_SOMETHING "' " + GetParam().kind +
                 " '" + asked().string() + "' new >.out 2>.err </dev/null");
  }
  Ran saveFailing(std::size_t at, int error, const std::string &how) {
    return save("FAILING_AT=" + std::to_string(at) + " FAILING_ERROR=" + std::to_string(error) +
                " FAILING_HOW=" + how);
  }

  /// The calls that were counted in the last save.
  std::vector<Call> calls() const {
    std::vector<Call> found;
    std::ifstream report(inFolder("calls"));
    for (Call call; report >> call.name && std::getline(report >> std::ws, call.place);)
      found.push_back({call.name, fs::path(call.place).lexically_normal().string()});
    return found;
  }
  /// The calls of a save that goes well.
  std::vector<Call> goodCalls() {
    const Ran ran = save();
    EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
    EXPECT_EQ(content(), m_new);
    return calls();
  }

  /// What is there now; nothing where no file is.
  std::optional<std::string> content() const {
    for (const fs::path &file : filesInHome())
      if (file.extension() == ".json")
        return contentOf(file);
    return {};
  }
  std::optional<std::string> oldContent() const {
    return GetParam().before == Before::Nothing ? std::nullopt : std::optional(m_old);
  }
  const std::string &newContent() const { return m_new; }

  bool leftUnfinished() const {
    const auto files = filesInHome();
    return std::any_of(files.begin(), files.end(),
                       [](const fs::path &file) { return file.extension() == ".part"; });
  }

  void expectOldOrNewWhole() const {
    const auto found = content();
    EXPECT_TRUE(found == oldContent() || found == m_new)
        << (found ? std::to_string(found->size()) + " bytes" : "no file");
    expectLinkIsOne();
  }
  /// Old where the save says that it failed, new where it says nothing. Only the last call, by which the
  /// folder is synced, fails when the new content has its name already.
  void expectAsTold(const Ran &ran, const Call &failing) const {
    expectOldOrNewWhole();
    const bool hasItsName = failing.name == "fsync" && !failing.place.ends_with(".part");
    if (ran.status == 0 || !hasItsName) {
      EXPECT_EQ(content(), ran.status == 0 ? m_new : oldContent());
    }
  }

private:
  fs::path home() const { return inFolder("home"); }
  fs::path real() const {
    return home() / (GetParam().before == Before::ALink ? "real" : "kept") / "mine.json";
  }
  fs::path asked() const { return home() / "kept" / "mine.json"; }

  /// A file with one of the two contents.
  std::string made(const std::string &which) {
    fs::create_directories(inFolder(which));
    const fs::path file = inFolder(which) / "mine.json";
    const Ran ran = shell("'" SAVE_SOMETHING "' " + GetParam().kind + " '" + file.string() + "' " + which +
                          " >.out 2>.err </dev/null");
    EXPECT_EQ(ran.status, 0) << ran.out << ran.err;
    for (const auto &entry : fs::directory_iterator(inFolder(which)))
      if (entry.path().extension() == ".json")
        return contentOf(entry.path());
    return {};
  }

  void prepare() const {
    fs::remove_all(home());
    fs::remove(inFolder("calls"));
    fs::create_directories(home());
    const bool makesFolder = GetParam().kind == "recovery" || GetParam().kind == "settings";
    if (!makesFolder || GetParam().before != Before::Nothing)
      fs::create_directories(asked().parent_path());
    if (GetParam().before == Before::Nothing)
      return;
    fs::create_directories(real().parent_path());
    std::ofstream(real(), std::ios::binary) << m_old;
    const bool mayGiveAway = geteuid() == 0;
    ASSERT_TRUE(!mayGiveAway || chown(real().c_str(), 12345, 12345) == 0);
    if (GetParam().before == Before::ALink)
      fs::create_symlink("../real/mine.json", asked());
  }

  std::vector<fs::path> filesInHome() const {
    std::vector<fs::path> files;
    for (const auto &entry : fs::recursive_directory_iterator(home()))
      if (entry.is_regular_file() && !entry.is_symlink())
        files.push_back(entry.path());
    return files;
  }

  void expectLinkIsOne() const { EXPECT_EQ(fs::is_symlink(asked()), GetParam().before == Before::ALink); }

  std::string m_old;
  std::string m_new;
};

TEST_P(EveryCall, OfAGoodSave_IsSeen) {
  const auto seen = goodCalls();
  EXPECT_GT(seen.size(), 5U);
  for (const std::string_view name : {"write", "fsync", "close", "renameat"})
    EXPECT_TRUE(std::any_of(seen.begin(), seen.end(), [&](const Call &call) { return call.name == name; }))
        << name;
  // The content is on the disk before it has its name, and the name thereafter.
  const auto renamed =
      std::find_if(seen.begin(), seen.end(), [](const Call &call) { return call.name == "renameat"; });
  const auto isSync = [](const Call &call) { return call.name == "fsync"; };
  EXPECT_EQ(std::count_if(seen.begin(), renamed, isSync), 1);
  EXPECT_EQ(std::count_if(renamed, seen.end(), isSync), 1);
  EXPECT_FALSE(leftUnfinished());
}

TEST_P(EveryCall, ThatFails_IsToldAndLeavesTheOldOrTheNewWhole) {
  const auto all = goodCalls();
  for (std::size_t at = 1; at <= all.size(); ++at) {
    const Call &call = all[at - 1];
    SCOPED_TRACE(std::to_string(at) + ": " + call.text());
    const Ran ran = saveFailing(at, likelyError(call), "once");
    const auto why = whySilent(call);
    EXPECT_EQ(ran.status, why.empty() ? 1 : 0) << ran.out << why;
    EXPECT_EQ(namesReason(ran.out, call), why.empty()) << ran.out << why;
    expectAsTold(ran, call);
    EXPECT_FALSE(leftUnfinished());
  }
}

TEST_P(EveryCall, WithAllAfterIt_FailsAndLeavesTheOldOrTheNewWhole) {
  const auto all = goodCalls();
  for (std::size_t at = 1; at <= all.size(); ++at) {
    const Call &call = all[at - 1];
    SCOPED_TRACE(std::to_string(at) + ": " + call.text());
    const Ran ran = saveFailing(at, EIO, "onwards");
    const bool last = at == all.size(); // the folder's closing
    EXPECT_EQ(ran.status, last ? 0 : 1);
    EXPECT_EQ(namesReason(ran.out, call), !last) << ran.out;
    expectAsTold(ran, call);
    const auto tried = calls();
    EXPECT_TRUE(!leftUnfinished() || tried.back().name == "unlinkat" || tried.back().name == "close");
  }
}

TEST_P(EveryCall, ThatWritesHalf_IsToldAndLeavesTheOldOrTheNewWhole) {
  const auto all = goodCalls();
  int halved = 0;
  for (std::size_t at = 1; at <= all.size(); ++at) {
    const Call &call = all[at - 1];
    if (call.name != "write")
      continue;
    SCOPED_TRACE(std::to_string(at) + ": " + call.text());
    ++halved;
    const Ran ran = saveFailing(at, ENOSPC, "half");
    EXPECT_EQ(ran.status, 1);
    EXPECT_TRUE(namesReason(ran.out, call)) << ran.out;
    EXPECT_EQ(content(), oldContent());
    EXPECT_FALSE(leftUnfinished());
  }
  EXPECT_GE(halved, 1);
}

TEST_P(EveryCall, WithTheProgramKilledThere_LeavesTheOldOrTheNewWhole) {
  const auto all = goodCalls();
  std::set<std::optional<std::string>> found;
  for (std::size_t at = 1; at <= all.size(); ++at) {
    SCOPED_TRACE(std::to_string(at) + ": " + all[at - 1].text());
    EXPECT_EQ(saveFailing(at, 0, "kill").status, -1);
    EXPECT_EQ(calls().size(), at);
    expectOldOrNewWhole();
    found.insert(content());
  }
  EXPECT_EQ(found, (std::set<std::optional<std::string>>{oldContent(), newContent()}));
}

TEST_P(EveryCall, WithTheProgramToldToEndThere_LeavesNothingUnfinished) {
  const auto all = goodCalls();
  for (std::size_t at = 1; at <= all.size(); ++at) {
    SCOPED_TRACE(std::to_string(at) + ": " + all[at - 1].text());
    EXPECT_EQ(saveFailing(at, 0, "end").status, -1);
    expectOldOrNewWhole();
    EXPECT_FALSE(leftUnfinished());
  }
}

TEST_P(EveryCall, ThatIsInterrupted_IsDoneAgain) {
  const auto all = goodCalls();
  for (std::size_t at = 1; at <= all.size(); ++at) {
    const Call &call = all[at - 1];
    if (call.name != "write" && call.name != "fsync" && call.name != "close")
      continue;
    SCOPED_TRACE(std::to_string(at) + ": " + call.text());
    const Ran ran = saveFailing(at, EINTR, "once");
    EXPECT_EQ(ran.status, 0) << ran.out;
    EXPECT_EQ(content(), newContent());
    EXPECT_FALSE(leftUnfinished());
  }
}

TEST_P(EveryCall, ThatSyncsWhereNothingCanBeSynced_DoesNotKeepFromSaving) {
  const auto all = goodCalls();
  for (std::size_t at = 1; at <= all.size(); ++at)
    if (all[at - 1].name == "fsync") {
      EXPECT_EQ(saveFailing(at, EINVAL, "once").status, 0);
      EXPECT_EQ(content(), newContent());
    }
}

std::string nameOf(const testing::TestParamInfo<Saved> &info) {
  const std::string before[] = {"New", "Old", "Linked"};
  return before[static_cast<std::size_t>(info.param.before)] + "_" + info.param.kind;
}

INSTANTIATE_TEST_SUITE_P(Saving, EveryCall,
                         testing::Values(Saved{"session", Before::Nothing}, Saved{"session", Before::AFile},
                                         Saved{"session", Before::ALink}, Saved{"recovery", Before::Nothing},
                                         Saved{"recovery", Before::AFile}, Saved{"settings", Before::Nothing},
                                         Saved{"settings", Before::AFile}, Saved{"picture", Before::Nothing},
                                         Saved{"picture", Before::AFile}),
                         nameOf);

} // namespace
} // namespace halfspace
