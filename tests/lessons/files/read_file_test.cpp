#include "lessons/files/read_file.h"

#include "tests/lessons/files/as_nobody.h"
#include "tests/program_test.h"

#include <sys/stat.h>

namespace halfspace {
namespace {

using test::AsNobody;

constexpr std::size_t limit = 100000;

class ReadFile : public ProgramTest {
protected:
  void expectRefused(const std::filesystem::path &file, const std::string &sentence) const {
    const auto text = readFile(file, limit);
    ASSERT_FALSE(text) << file;
    EXPECT_EQ(text.problem().sentence, sentence);
    EXPECT_EQ(text.problem().file, file.string());
  }
};

TEST_F(ReadFile, AsItWasWritten_IsReadWhole) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{65536}, limit}) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size; ++i)
      bytes[i] = static_cast<char>(i % 251);
    write("a", bytes);
    const auto text = readFile(inFolder("a"), limit);
    ASSERT_TRUE(text) << text.problem().text();
    EXPECT_TRUE(*text == bytes) << size;
  }
}

TEST_F(ReadFile, ThroughALink_IsReadLikeItsTarget) {
  write("a", "text");
  std::filesystem::create_symlink("a", inFolder("link"));
  const auto text = readFile(inFolder("link"), limit);
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "text");
}

TEST_F(ReadFile, LargerThanTheLimit_IsRefused) {
  write("a", std::string(limit + 1, 'x'));
  expectRefused(inFolder("a"), "The file is too large: at most 97 KiB are read.");
}

TEST_F(ReadFile, OfATerabyte_IsRefusedWithoutReadingIt) {
  write("a", "x");
  std::filesystem::resize_file(inFolder("a"),
                               std::uintmax_t{1} << 40U); // takes no room: all but a byte is a hole
  const auto text = readFile(inFolder("a"), 16U << 20U);
  ASSERT_FALSE(text);
  EXPECT_EQ(text.problem().sentence, "The file is too large: at most 16 MiB are read.");
}

TEST_F(ReadFile, ThatSaysItIsEmptyAndIsNot_IsReadToItsEnd) {
  // The kernel's files have no size.
  const auto text = readFile("/proc/self/status", limit);
  ASSERT_TRUE(text);
  EXPECT_NE(text->find("\nPid:"), std::string::npos);
}

TEST_F(ReadFile, ThatIsNone_IsNamedAsWhatItIs) {
  ASSERT_EQ(mkfifo(inFolder("pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", inFolder("link"));
  expectRefused(folder(), "This is a folder, not a file.");
  for (const std::filesystem::path &file :
       {inFolder("pipe"), inFolder("link"), std::filesystem::path("/dev/null")})
    expectRefused(file, "This is a device, a pipe or a socket, not a file.");
}

TEST_F(ReadFile, ThatIsMissing_IsToldSo) {
  write("a", "");
  std::filesystem::create_symlink("no-such", inFolder("dangling"));
  std::filesystem::create_symlink("circle", inFolder("circle"));
  for (const char *name : {"no-such", "no-such/a", "a/b", "dangling"})
    expectRefused(inFolder(name), "There is no such file.");
  expectRefused(inFolder("circle"), "The file cannot be opened: its links lead in a circle.");
  expectRefused("", "There is no such file.");
}

TEST_F(ReadFile, WithoutARightToRead_IsToldSo) {
  ASSERT_EQ(chmod(folder().c_str(), 0755), 0);
  write("a", "secret");
  ASSERT_EQ(chmod(inFolder("a").c_str(), geteuid() == 0 ? 0600 : 0200), 0);
  const AsNobody rights;
  ASSERT_FALSE(rights.failed());
  expectRefused(inFolder("a"), "You may not read this file.");
}

} // namespace
} // namespace halfspace
