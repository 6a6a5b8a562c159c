#include "lessons/files/write_file.h"

#include "tests/lessons/files/as_nobody.h"
#include "tests/program_test.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <thread>
#include <vector>

namespace halfspace {
namespace {

namespace fs = std::filesystem;
using test::AsNobody;
using test::nobody;

const std::string oldText = "old\n";
const std::string newText = "new, and longer than the old\n";

/// Longer than a pipe holds.
constexpr std::size_t muchMoreThanAPipe = 1U << 20U;

struct stat statusOf(const fs::path &file) {
  struct stat found {};
  EXPECT_EQ(::lstat(file.c_str(), &found), 0) << file;
  return found;
}

unsigned modeOf(const fs::path &file) { return statusOf(file).st_mode & 07777U; }

/// The process's mask, until the end of the test.
class Mask {
public:
  explicit Mask(mode_t mask) : m_before(umask(mask)) {}
  ~Mask() { umask(m_before); }
  Mask(const Mask &) = delete;
  Mask &operator=(const Mask &) = delete;

private:
  mode_t m_before;
};

class WriteFile : public ProgramTest {
protected:
  /// Nothing but these names is in the folder.
  void expectOnly(std::vector<std::string> names) const {
    std::vector<std::string> found;
    for (const auto &entry : fs::directory_iterator(folder()))
      found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    std::sort(names.begin(), names.end());
    EXPECT_EQ(found, names);
  }

  void expectWritten(const fs::path &file, Readers readers = Readers::AsUsual) const {
    const auto problem = writeFile(file, newText, readers);
    EXPECT_FALSE(problem) << problem->text();
    EXPECT_EQ(contentOf(file), newText);
  }

  void expectRefused(const fs::path &file, const std::string &reason) const {
    const auto problem = writeFile(file, newText);
    ASSERT_TRUE(problem) << file;
    EXPECT_EQ(problem->sentence, "This cannot be written: " + reason + ".");
    EXPECT_EQ(problem->file, file.string());
  }

  void link(const std::string &to, const std::string &name) const { fs::create_symlink(to, inFolder(name)); }
  void expectLink(const std::string &name, const std::string &to) const {
    ASSERT_TRUE(fs::is_symlink(inFolder(name))) << name;
    EXPECT_EQ(fs::read_symlink(inFolder(name)), to);
  }
};

TEST_F(WriteFile, NewOrThere_HoldsTheNewContentAlone) {
  expectWritten(inFolder("a"));
  write("b", oldText + oldText + oldText + oldText + oldText + oldText + oldText + oldText);
  expectWritten(inFolder("b"));
  EXPECT_FALSE(writeFile(inFolder("b"), ""));
  EXPECT_EQ(fs::file_size(inFolder("b")), 0U);
  expectOnly({"a", "b"});
}

TEST_F(WriteFile, WithZeroBytesAndMegabytes_HoldsAllOfThem) {
  std::string bytes(3U << 20U, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<char>(i * i >> 7U);
  EXPECT_FALSE(writeFile(inFolder("a"), bytes));
  EXPECT_TRUE(contentOf(inFolder("a")) == bytes);
}

TEST_F(WriteFile, NamedWithoutAFolder_IsWrittenWhereTheProgramIs) {
  const fs::path before = fs::current_path();
  fs::current_path(folder());
  expectWritten("a");
  fs::current_path(before);
  EXPECT_EQ(contentOf(inFolder("a")), newText);
}

TEST_F(WriteFile, Replaced_IsAnotherFileSoThatWhoReadsTheOldOneReadsItWhole) {
  write("a", oldText);
  fs::create_hard_link(inFolder("a"), inFolder("other"));
  expectWritten(inFolder("a"));
  EXPECT_EQ(contentOf(inFolder("other")), oldText);
}

TEST_F(WriteFile, ThroughARelativeLink_ChangesItsTargetAndStaysALink) {
  fs::create_directory(inFolder("there"));
  write("there/a", oldText);
  link("there/a", "link");
  expectWritten(inFolder("link"));
  EXPECT_EQ(contentOf(inFolder("there/a")), newText);
  expectLink("link", "there/a");
  expectOnly({"there", "link"});
}

TEST_F(WriteFile, ThroughAnAbsoluteLink_ChangesItsTargetAndStaysALink) {
  write("a", oldText);
  link(inFolder("a").string(), "link");
  expectWritten(inFolder("link"));
  EXPECT_FALSE(fs::is_symlink(inFolder("a")));
  EXPECT_EQ(contentOf(inFolder("a")), newText);
  expectLink("link", inFolder("a").string());
}

TEST_F(WriteFile, ThroughLinksOfLinks_ChangesTheLastTarget) {
  fs::create_directories(inFolder("x/y"));
  write("a", oldText);
  link("../../a", "x/y/second"); // each is relative to its own folder
  link("x/y/second", "first");
  expectWritten(inFolder("first"));
  EXPECT_EQ(contentOf(inFolder("a")), newText);
  expectLink("first", "x/y/second");
  expectLink("x/y/second", "../../a");
}

TEST_F(WriteFile, ThroughALinkToNothing_MakesItsTarget) {
  link("not-yet", "link");
  expectWritten(inFolder("link"));
  EXPECT_EQ(contentOf(inFolder("not-yet")), newText);
  expectLink("link", "not-yet");
}

TEST_F(WriteFile, ThroughALinkIntoNoFolder_IsRefused) {
  link("no-folder/a", "link");
  expectRefused(inFolder("link"), "there is no such folder");
  expectLink("link", "no-folder/a");
}

TEST_F(WriteFile, ThroughLinksInACircle_IsRefused) {
  link("b", "a");
  link("a", "b");
  expectRefused(inFolder("a"), "its links lead in a circle");
  expectLink("a", "b");
  expectOnly({"a", "b"});
}

TEST_F(WriteFile, OverAFile_KeepsItsPermissions) {
  const Mask mask(077);
  for (const mode_t mode : {0644U, 0600U, 0664U, 0755U, 0222U}) {
    write("a", oldText);
    ASSERT_EQ(chmod(inFolder("a").c_str(), mode), 0);
    EXPECT_FALSE(writeFile(inFolder("a"), newText, Readers::OwnerOnly));
    EXPECT_EQ(modeOf(inFolder("a")), mode);
    fs::remove(inFolder("a"));
  }
}

TEST_F(WriteFile, ByRootOverSomebodysFile_StaysThatOnes) {
  if (geteuid() != 0)
    return; // nobody else may give files away
  write("a", oldText);
  ASSERT_EQ(chown(inFolder("a").c_str(), nobody, 12345), 0);
  ASSERT_EQ(chmod(inFolder("a").c_str(), 0640), 0);
  expectWritten(inFolder("a"));
  EXPECT_EQ(statusOf(inFolder("a")).st_uid, nobody);
  EXPECT_EQ(statusOf(inFolder("a")).st_gid, 12345U);
  EXPECT_EQ(modeOf(inFolder("a")), 0640U);
}

TEST_F(WriteFile, ByAnotherThanItsOwner_GivesItsGroupNoRightsByAccident) {
  if (geteuid() != 0)
    return; // there is no other to be
  ASSERT_EQ(chmod(folder().c_str(), 0777), 0);
  write("a", oldText);
  ASSERT_EQ(chmod(inFolder("a").c_str(), 0666), 0);
  {
    const AsNobody rights;
    ASSERT_FALSE(rights.failed());
    expectWritten(inFolder("a"));
  }
  // The group of root's file would have become that of nobody.
  EXPECT_EQ(statusOf(inFolder("a")).st_uid, nobody);
  EXPECT_EQ(modeOf(inFolder("a")), 0606U);
}

TEST_F(WriteFile, New_ObeysTheMask) {
  for (const auto &[mask, mode] : {std::pair{022U, 0644U}, {077U, 0600U}, {002U, 0664U}}) {
    const Mask during(mask);
    fs::remove(inFolder("a"));
    expectWritten(inFolder("a"));
    EXPECT_EQ(modeOf(inFolder("a")), mode);
  }
}

TEST_F(WriteFile, NewForItsOwnerOnly_IsReadByNobodyElse) {
  const Mask mask(0);
  expectWritten(inFolder("a"), Readers::OwnerOnly);
  EXPECT_EQ(modeOf(inFolder("a")), 0600U);
}

TEST_F(WriteFile, ThatIsReadOnly_IsRefusedAndUnchanged) {
  write("a", oldText);
  ASSERT_EQ(chmod(inFolder("a").c_str(), 0444), 0);
  link("a", "link");
  expectRefused(inFolder("a"), "it is read-only");
  expectRefused(inFolder("link"), "it is read-only");
  EXPECT_EQ(contentOf(inFolder("a")), oldText);
  EXPECT_EQ(modeOf(inFolder("a")), 0444U);
  expectOnly({"a", "link"});
}

TEST_F(WriteFile, WithoutARightToTheFileOrItsFolder_IsRefusedAndUnchanged) {
  write("a", oldText);
  fs::create_directory(inFolder("closed"));
  write("closed/b", oldText);
  ASSERT_EQ(chmod(inFolder("a").c_str(), geteuid() == 0 ? 0644 : 0444), 0);
  ASSERT_EQ(chmod(inFolder("closed/b").c_str(), 0666), 0);
  ASSERT_EQ(chmod(inFolder("closed").c_str(), 0555), 0);
  ASSERT_EQ(chmod(folder().c_str(), 0777), 0);
  {
    const AsNobody rights;
    ASSERT_FALSE(rights.failed());
    expectRefused(inFolder("a"), "you may not do that there");
    expectRefused(inFolder("closed/b"), "you may not do that there");
    expectRefused(inFolder("closed/new"), "you may not do that there");
  }
  EXPECT_EQ(contentOf(inFolder("a")), oldText);
  EXPECT_EQ(contentOf(inFolder("closed/b")), oldText);
  ASSERT_EQ(chmod(inFolder("closed").c_str(), 0755), 0);
  expectOnly({"a", "closed"});
}

TEST_F(WriteFile, ThatIsAFolder_IsRefused) {
  fs::create_directory(inFolder("a"));
  expectRefused(inFolder("a"), "it is a folder");
  expectRefused(inFolder("a") / "", "it is a folder");
  expectRefused(inFolder("new") / "", "it is a folder");
  EXPECT_TRUE(fs::is_empty(inFolder("a")));
  expectOnly({"a"});
}

TEST_F(WriteFile, InNoFolder_IsRefusedWithTheReason) {
  write("file", oldText);
  expectRefused(inFolder("none/a"), "there is no such folder");
  expectRefused(inFolder("file/a"), "a part of its path is no folder");
  expectRefused(inFolder(std::string(256, 'x')), "its name is too long");
}

TEST_F(WriteFile, ThatIsASocket_IsRefusedAndStaysOne) {
  sockaddr_un address{AF_UNIX, {}};
  ASSERT_LT(inFolder("s").string().size(), sizeof address.sun_path);
  inFolder("s").string().copy(address.sun_path, sizeof address.sun_path - 1);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(socket, reinterpret_cast<const sockaddr *>(&address), sizeof address), 0);
  expectRefused(inFolder("s"), "it is no file but a device or a socket");
  EXPECT_TRUE(fs::is_socket(inFolder("s")));
  close(socket);
}

TEST_F(WriteFile, ThatIsAPipeWithAReader_GetsTheBytesAndStaysAPipe) {
  ASSERT_EQ(mkfifo(inFolder("pipe").c_str(), 0600), 0);
  const int reader = open(inFolder("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_FALSE(writeFile(inFolder("pipe"), newText));
  std::string got(100, '\0');
  const auto count = read(reader, got.data(), got.size());
  EXPECT_EQ(got.substr(0, static_cast<std::size_t>(std::max<ssize_t>(count, 0))), newText);
  close(reader);
  EXPECT_TRUE(fs::is_fifo(inFolder("pipe")));
  expectOnly({"pipe"});
}

TEST_F(WriteFile, ThatIsASlowlyReadPipe_GetsMoreThanAPipeHolds) {
  ASSERT_EQ(mkfifo(inFolder("pipe").c_str(), 0600), 0);
  const int reader = open(inFolder("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  ASSERT_EQ(fcntl(reader, F_SETFL, 0), 0);
  std::string text(muchMoreThanAPipe, 'x');
  text.back() = '\n';
  std::string got;
  std::atomic<bool> written = false;
  std::thread reading([&] {
    std::string part(1000, '\0');
    for (;;) {
      const bool last = written; // looked at first: what is read then is all that there is
      const ssize_t count = read(reader, part.data(), part.size());
      got += part.substr(0, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
      if (count <= 0 && last)
        return;
      if (count <= 0)
        std::this_thread::yield(); // nobody has opened it for writing yet
    }
  });
  EXPECT_FALSE(writeFile(inFolder("pipe"), text));
  written = true;
  reading.join();
  EXPECT_TRUE(got == text);
  close(reader);
}

TEST_F(WriteFile, ThatIsAPipeWithoutAReader_IsRefusedAtOnce) {
  ASSERT_EQ(mkfifo(inFolder("pipe").c_str(), 0600), 0);
  expectRefused(inFolder("pipe"), "nobody reads from it");
  EXPECT_TRUE(fs::is_fifo(inFolder("pipe")));
}

TEST_F(WriteFile, ThatIsADevice_IsWrittenToAndStaysOne) {
  // A copy of /dev/null where one may be made; else the link is as good: nothing takes its name.
  const fs::path device = inFolder("null");
  if (mknod(device.c_str(), S_IFCHR | 0666U, makedev(1, 3)) != 0)
    fs::create_symlink("/dev/null", device);
  const auto before = statusOf(device).st_ino;
  EXPECT_FALSE(writeFile(device, newText));
  EXPECT_EQ(statusOf(device).st_ino, before);
  EXPECT_TRUE(fs::is_character_file(device));
  expectOnly({"null"});
}

TEST_F(WriteFile, ThatIsAFullDevice_IsToldSo) {
  expectRefused("/dev/full", "there is no room left on the disk");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(WriteFile, ThatIsABlockDevice_IsRefused) {
  // Of a number that no driver has; only root may make one.
  if (mknod(inFolder("block").c_str(), S_IFBLK | 0666U, makedev(240, 250)) == 0)
    expectRefused(inFolder("block"), "it is no file but a device or a socket");
}

TEST_F(WriteFile, OfTheLongestName_IsWritten) {
  const std::string name(250, 'x');
  expectWritten(inFolder(name));
  write(name, oldText);
  expectWritten(inFolder(name));
  expectOnly({name});
}

TEST_F(WriteFile, WithAPlantedUnfinishedFile_LeavesItAlone) {
  write(".halfspace-1.part", oldText);
  expectWritten(inFolder("a"));
  EXPECT_EQ(contentOf(inFolder(".halfspace-1.part")), oldText);
}

TEST_F(WriteFile, BeyondTheLargestSizeAllowed_IsToldAndTheOldIsWhole) {
  write("a", oldText);
  // In a process of its own, as the limit cannot be lifted again.
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    const auto problem = setrlimit(RLIMIT_FSIZE, &limit) == 0
                             ? writeFile(inFolder("a"), std::string(10000, 'x'))
                             : std::nullopt;
    _exit(problem && problem->sentence == "This cannot be written: the file would be larger than it may be."
              ? 0
              : 1);
  }
  int ended = -1;
  ASSERT_EQ(waitpid(child, &ended, 0), child);
  EXPECT_EQ(ended, 0);
  EXPECT_EQ(contentOf(inFolder("a")), oldText);
  expectOnly({"a"});
}

TEST(UnfinishedFile, ByItsName_IsKnown) {
  EXPECT_TRUE(isUnfinishedFile(".halfspace-1f.part"));
  EXPECT_TRUE(isUnfinishedFile("/some/where/.halfspace-9fe4e9317b28aff8.part"));
  for (const char *other : {"", "mine.halfspace", ".halfspace-1f", "halfspace-1f.part", "a.part",
                            ".halfspace-1f.part~", "/x/.halfspace-1.part/mine.json"})
    EXPECT_FALSE(isUnfinishedFile(other)) << other;
}

TEST_F(WriteFile, Unfinished_HasTheTargetsNameOnlyWhenItIsWhole) {
  write("a", oldText);
  {
    auto file = UnfinishedFile::begin(inFolder("a"));
    ASSERT_TRUE(file);
    EXPECT_FALSE(file->write(newText));
    EXPECT_EQ(contentOf(inFolder("a")), oldText);
    EXPECT_EQ(contentOf(file->path()), newText);
    EXPECT_TRUE(isUnfinishedFile(file->path()));
    EXPECT_FALSE(file->write(newText));
    EXPECT_FALSE(file->finish());
  }
  EXPECT_EQ(contentOf(inFolder("a")), newText + newText);
  expectOnly({"a"});
}

TEST_F(WriteFile, Unfinished_IsWrittenByAnotherProgramToo_WithTheRightsOfTheOldOne) {
  write("a", oldText);
  fs::permissions(inFolder("a"), fs::perms(0640));
  auto file = UnfinishedFile::begin(inFolder("a"));
  ASSERT_TRUE(file);
  EXPECT_EQ(shell("cp /proc/self/comm '" + file->path().string() + "' >.out 2>.err").status, 0);
  EXPECT_FALSE(file->finish());
  EXPECT_EQ(contentOf(inFolder("a")), "cp\n");
  EXPECT_EQ(modeOf(inFolder("a")), 0640U);
}

TEST_F(WriteFile, Unfinished_ThatIsGivenUp_LeavesNothing) {
  {
    auto file = UnfinishedFile::begin(inFolder("a"));
    ASSERT_TRUE(file);
    EXPECT_FALSE(file->write(newText));
  }
  expectOnly({});
}

TEST_F(WriteFile, Unfinished_InPlaceOfAPipeOrInNoFolder_IsRefusedAtTheBeginning) {
  ASSERT_EQ(mkfifo(inFolder("pipe").c_str(), 0600), 0);
  EXPECT_FALSE(UnfinishedFile::begin(inFolder("pipe")));
  const auto nowhere = UnfinishedFile::begin(inFolder("no/a"));
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.problem().file, inFolder("no/a").string());
}

} // namespace
} // namespace halfspace
