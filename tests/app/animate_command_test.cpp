// Scenes in motion from the command line.
#include "tests/app/command_fixture.h"

#include <QImageReader>

#include <cmath>
#include <csignal>

namespace halfspace {
namespace {

class Animations : public Program {
protected:
  /// The names in a folder of the test's, in order; unfinished files among them.
  [[nodiscard]] std::vector<std::string> filesIn(const std::string &name) const {
    std::vector<std::string> names;
    for (const auto &entry : std::filesystem::directory_iterator(inFolder(name)))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  void makeFolder(const std::string &name) const { std::filesystem::create_directory(inFolder(name)); }
};

/// How far the colours of two pictures are from one another, on average, of 255.
double difference(const QImage &one, const QImage &other) {
  double sum = 0;
  for (int y = 0; y < one.height(); ++y)
    for (int x = 0; x < one.width(); ++x) {
      const QRgb a = one.pixel(x, y);
      const QRgb b = other.pixel(x, y);
      sum += std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
    }
  return sum / (3.0 * one.width() * one.height());
}

TEST_F(Animations, OfAFlight_AreTheFramesThatRenderDraws) {
  makeFolder("frames");
  const Ran ran = run("animate photon-torpedo --motion flight --size 160x100 -o frames/%03d.png");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.out + ran.err, "");
  for (const std::string frame : {"000", "038"}) {
    EXPECT_EQ(run("render photon-torpedo --size 160x100 --anonymous --frame " + frame + " -o one.png").status,
              0);
    EXPECT_EQ(picture("frames/" + frame + ".png"), picture("one.png")) << frame;
  }
}

TEST_F(Animations, AsGif_HavePicturesLikeThoseOfRender) {
  const Ran ran =
      run("animate ray-triangle-perp --motion turn --seconds 2 --fps 5 --size 320x200 -o turn.gif");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(
      run("animate ray-triangle-perp --motion turn --seconds 2 --fps 5 --size 320x200 -o %d.png").status, 0);
  QImageReader reader(QString::fromStdString(inFolder("turn.gif").string()));
  EXPECT_EQ(reader.imageCount(), 10);
  EXPECT_EQ(reader.loopCount(), -1); // for ever
  for (int i = 0; i < 10; ++i) {
    const QImage read = reader.read();
    EXPECT_EQ(read.size(), QSize(320, 200));
    EXPECT_LT(difference(read, picture(std::to_string(i) + ".png")), 1.5) << i;
    EXPECT_EQ(reader.nextImageDelay(), 200);
  }
}

TEST_F(Animations, WithoutABackground_AreClearWhereNothingIsDrawn) {
  EXPECT_EQ(run("animate ray-triangle-perp --motion turn --seconds 0.2 --size 160x100 --transparent -o a.gif")
                .status,
            0);
  EXPECT_EQ(qAlpha(picture("a.gif").pixel(0, 0)), 0);
}

TEST_F(Animations, OfSteps_BeginWithTheFirstAndEndWithTheLast) {
  EXPECT_EQ(run("animate signed-distance --motion steps --fps 1 --seconds 4 --size 160x100 -o %d.png").status,
            0);
  EXPECT_TRUE(std::filesystem::exists(inFolder("4.png")));
  EXPECT_FALSE(std::filesystem::exists(inFolder("5.png")));
  EXPECT_NE(picture("0.png"), picture("4.png"));
}

TEST_F(Animations, OfASession_HaveItsSceneAndView) {
  EXPECT_EQ(run("render signed-distance --set Q=1,1,1 --step 2 -o a.png --size 160x100").status, 0);
  EXPECT_EQ(run("animate a.png --motion turn --seconds 0.1 --fps 10 --size 160x100 -o %d.png").status, 0);
  EXPECT_EQ(run("animate signed-distance --set Q=1,1,1 --step 2 --motion turn --seconds 0.1 --fps 10 --size "
                "160x100 "
                "-o other%d.png")
                .status,
            0);
  EXPECT_EQ(picture("0.png"), picture("other0.png"));
}

TEST_F(Animations, AsVideos_HaveTheirPictures) {
  if (!has("ffmpeg") || !has("ffprobe"))
    GTEST_SKIP() << "ffmpeg is not installed";
  for (const std::string name : {"a.mp4", "a.webm"}) {
    const Ran ran =
        run("animate signed-distance --motion turn --seconds 1 --fps 10 --size 160x100 -o " + name);
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(ran.out + ran.err, "");
    const Ran probed =
        shell("ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 " + name +
              " >.out 2>.err");
    EXPECT_EQ(probed.out.substr(0, 2), "10") << probed.out;
  }
}

TEST_F(Animations, ThatCannotBeMade_AreRefusedInASentence) {
  const std::string turn = "animate signed-distance --motion turn ";
  expectRefused("animate signed-distance -o a.gif", "--motion");
  expectRefused("animate signed-distance --motion dance -o a.gif", "flight, steps, turn");
  expectRefused(turn, "--output");
  expectRefused(turn + "-o a.avi", ".gif, .mp4, .webm, .png");
  expectRefused(turn + "-o a.png", "frames/%04d.png");
  expectRefused(turn + "-o a.gif --fps 30", "1, 2, 4, 5, 10, 20, 25 or 50");
  expectRefused(turn + "-o a.mp4 --fps 61", "--fps");
  expectRefused(turn + "-o a.mp4 --fps 2.5", "--fps");
  expectRefused(turn + "-o a.gif --seconds 0", "--seconds");
  expectRefused(turn + "-o a.gif --seconds 1e9", "--seconds");
  expectRefused(turn + "-o a.gif --size 0x1", "--size");
  expectRefused(turn + "-o a.mp4 --transparent", "no transparent pictures");
  expectRefused(turn + "-o a.gif --theme neon", "neon");
  expectRefused(turn + "-o a.gif --step 99", "--step");
  expectRefused(turn + "-o a.gif --size 16000x16000", "too much for an animation");
  expectRefused("animate signed-distance --motion flight -o a.gif", "no flight");
  expectRefused("animate signed-distance --motion steps --step 2 -o a.gif", "All steps are shown");
  expectRefused(turn + "-o no-such-folder/a.gif", "no-such-folder/a.gif");
  expectRefused(turn + "-o no-such-folder/%d.png --size 64x64", "no-such-folder/0.png");
  expectRefused(turn + "-o a.mp4 --size 64x64", "apt install ffmpeg", "PATH=/nonexistent");
  expectRefused(turn + "-o a.gif --size 64x64", "the file would be larger than it may be",
                "prlimit --fsize=2000");
  EXPECT_FALSE(std::filesystem::exists(inFolder("a.gif")));
}

TEST_F(Animations, WithoutRoomForAVideo_SayWhatFfmpegSays_AndLeaveNothing) {
  if (!has("ffmpeg"))
    GTEST_SKIP() << "ffmpeg is not installed";
  makeFolder("out");
  expectRefused("animate signed-distance --motion turn --seconds 1 --size 320x200 -o out/a.mp4",
                "File too large", "prlimit --fsize=2000");
  EXPECT_EQ(filesIn("out"), std::vector<std::string>());
}

TEST_F(Animations, ToldToEnd_LeaveNothingButFinishedPictures) {
  const std::string film = "animate signed-distance --motion turn --seconds 600 --fps 10 --size 320x200 -o ";
  makeFolder("png");
  EXPECT_EQ(runUntil("[ -e png/3.png ]", film + "png/%d.png").status, 128 + SIGTERM);
  EXPECT_GT(filesIn("png").size(), 3U);
  for (const std::string &name : filesIn("png"))
    EXPECT_EQ(picture("png/" + name).width(), 320) << name;
  makeFolder("gif");
  EXPECT_EQ(runUntil("[ -n \"$(ls -A gif)\" ]", film + "gif/a.gif").status, 128 + SIGTERM);
  EXPECT_EQ(filesIn("gif"), std::vector<std::string>());
}

TEST_F(Animations, ToldToEnd_WhileFfmpegHangs_LeaveNeitherItNorAFile) {
  makeFolder("bin");
  makeFolder("out");
  write("bin/ffmpeg", "#!/bin/sh\necho $$ >pid\ncat >/dev/null\nexec sleep 1000\n");
  std::filesystem::permissions(inFolder("bin/ffmpeg"), std::filesystem::perms::owner_all);
  const Ran ran =
      shell("PATH=\"$PWD/bin:$PATH\"; { env -u DISPLAY '" + std::string(HALFSPACE_PROGRAM) +
            "' animate signed-distance --motion turn --seconds 0.2 --size 64x64 -o out/a.mp4 >.out 2>.err & "
            "}; until [ -s pid ]; do sleep 0.05; done; sleep 1; kill -TERM $!; wait $!");
  EXPECT_EQ(ran.status, 128 + SIGTERM);
  EXPECT_EQ(filesIn("out"), std::vector<std::string>());
  EXPECT_NE(shell("kill -0 $(cat pid) >.out 2>.err").status, 0) << "ffmpeg still runs";
}

} // namespace
} // namespace halfspace
