// Videos by ffmpeg, and by programs that stand in for it.
#include "tests/animation/encoded.h"

#include <chrono>

namespace halfspace {
namespace {

using test::encode;
using test::filesIn;
using test::requestFor;

/// PATH as it was when the test ends.
class Videos : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    m_path = getenv("PATH"); // NOLINT(concurrency-mt-unsafe): a test is one thread
    std::filesystem::create_directory(inFolder("out"));
  }
  void TearDown() override {
    setPath(m_path);
    ProgramTest::TearDown();
  }

  static void setPath(const std::string &path) {
    setenv("PATH", path.c_str(), 1); // NOLINT(concurrency-mt-unsafe): likewise
  }
  /// From now on ffmpeg is this script.
  void standIn(const std::string &script) const {
    std::filesystem::create_directory(inFolder("bin"));
    write("bin/ffmpeg", "#!/bin/sh\n" + script);
    std::filesystem::permissions(inFolder("bin/ffmpeg"), std::filesystem::perms::owner_all);
    setPath(inFolder("bin").string() + ":" + m_path);
  }
  [[nodiscard]] bool has(const std::string &program) const {
    return shell("command -v " + program + " >.out 2>.err").status == 0;
  }
  [[nodiscard]] std::filesystem::path target(const std::string &name) const { return inFolder("out") / name; }
  /// What ffprobe says of the one stream.
  [[nodiscard]] std::string probed(const std::string &name) const {
    return shell("ffprobe -v error -count_frames -show_entries "
                 "stream=codec_name,width,height,pix_fmt,avg_frame_rate,nb_read_frames,color_space -of "
                 "default=nw=1 'out/" +
                 name + "' >.out 2>.err")
        .out;
  }

private:
  std::string m_path;
};

TEST_F(Videos, ByFfmpeg_HaveTheirPicturesSizeAndTime) {
  if (!has("ffmpeg") || !has("ffprobe"))
    GTEST_SKIP() << "ffmpeg is not installed";
  for (const auto &[name, codec] :
       {std::pair<std::string, std::string>("a.mp4", "h264"), {"a.webm", "vp9"}}) {
    SCOPED_TRACE(name);
    const auto problem = encode(requestFor(target(name), {160, 100}), 30);
    ASSERT_FALSE(problem) << problem->text();
    const std::string found = probed(name);
    for (const std::string &expected :
         {"codec_name=" + codec, std::string("width=160"), std::string("height=100"),
          std::string("pix_fmt=yuv420p"), std::string("color_space=bt709"),
          std::string("avg_frame_rate=25/1"), std::string("nb_read_frames=30")})
      EXPECT_NE(found.find(expected), std::string::npos) << expected << "\n" << found;
  }
  const std::string mp4 = contentOf(target("a.mp4"));
  EXPECT_LT(mp4.find("moov"), mp4.find("mdat")) << "players begin before they have all of it";
  EXPECT_EQ(filesIn(inFolder("out")), 2);
}

TEST_F(Videos, WithOddSides_AreRefusedAsMp4) {
  standIn("exit 1\n");
  const auto problem = encode(requestFor(target("a.mp4"), {161, 100}), 1);
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->sentence.find("even numbers of pixels, not 161 × 100"), std::string::npos);
}

TEST_F(Videos, WithoutFfmpeg_AreRefusedWithWhatToInstall_AndNothingIsLeft) {
  setPath("/nonexistent");
  const auto problem = encode(requestFor(target("a.mp4"), {160, 100}), 1);
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->sentence.find("apt install ffmpeg"), std::string::npos) << problem->text();
  EXPECT_EQ(filesIn(inFolder("out")), 0);
}

TEST_F(Videos, ThatFfmpegGivesUp_SayWhatItSays_AndLeaveNothing) {
  standIn("echo 'Something before.' >&2\necho \"Unknown encoder 'libx264'\" >&2\nexit 1\n");
  const auto problem = encode(requestFor(target("a.mp4"), {1600, 1000}), 5);
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->sentence.find("It says: “Unknown encoder 'libx264'”"), std::string::npos)
      << problem->text();
  EXPECT_EQ(problem->file, target("a.mp4").string());
  EXPECT_EQ(filesIn(inFolder("out")), 0);
}

TEST_F(Videos, ThatFfmpegGivesUpInTheEnd_OrWritesNothingOf_OrIsKilledAt_AreFailures) {
  for (const std::string script :
       {"cat >/dev/null\nexit 1\n", "cat >/dev/null\n", "cat >/dev/null\nkill -9 $$\n"}) {
    SCOPED_TRACE(script);
    standIn(script);
    const auto problem = encode(requestFor(target("a.webm"), {160, 100}), 5);
    ASSERT_TRUE(problem);
    EXPECT_NE(problem->sentence.find("did not say why"), std::string::npos) << problem->text();
    EXPECT_EQ(filesIn(inFolder("out")), 0);
  }
}

TEST_F(Videos, ThatFfmpegComplainsOf_AndEndsAsIfAllWereWell_AreFailures) {
  standIn("cat >/dev/null\nfor file; do :; done\necho some >\"${file#file:}\"\necho 'No space left.' >&2\n");
  const auto problem = encode(requestFor(target("a.mp4"), {160, 100}), 5);
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->sentence.find("It says: “No space left.”"), std::string::npos) << problem->text();
  EXPECT_EQ(filesIn(inFolder("out")), 0);
}

TEST_F(Videos, ByAProgramThatSaysVeryMuch_KeepTheLastOfIt) {
  standIn("head -c 3000000 /dev/zero | tr '\\0' 'x' >&2\necho >&2\necho 'The end.' >&2\nexit 1\n");
  const auto problem = encode(requestFor(target("a.mp4"), {1600, 1000}), 5);
  ASSERT_TRUE(problem);
  EXPECT_NE(problem->sentence.find("It says: “The end.”"), std::string::npos) << problem->text();
}

TEST_F(Videos, ThatHang_AreKilledWhenCancelled_AndLeaveTheOldFile) {
  write("out/a.mp4", "old");
  for (const std::string script : {"exec sleep 1000\n", "cat >/dev/null\nexec sleep 1000\n"}) {
    SCOPED_TRACE(script);
    standIn("echo $$ >'" + inFolder("pid").string() + "'\n" + script);
    EncodingRequest request = requestFor(target("a.mp4"), {1600, 1000});
    const auto begin = std::chrono::steady_clock::now();
    request.isCancelled = [begin] {
      return std::chrono::steady_clock::now() - begin > std::chrono::milliseconds(500);
    };
    static_cast<void>(encode(request, 3));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
    EXPECT_EQ(shell("kill -0 $(cat pid) >.out 2>.err").status, 1) << "it still runs";
    EXPECT_EQ(contentOf(target("a.mp4")), "old");
    EXPECT_EQ(filesIn(inFolder("out")), 1);
  }
}

TEST_F(Videos, InAFolderThatIsNotThere_AreRefusedAtTheBeginning) {
  standIn("exit 1\n");
  EXPECT_FALSE(animationFormatOf("a.mp4")->begin(requestFor(inFolder("no/a.mp4"), {160, 100})));
}

} // namespace
} // namespace halfspace
