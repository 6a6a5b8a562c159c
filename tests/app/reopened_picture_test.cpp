// Pictures that are opened again from the command line.
#include "tests/app/command_fixture.h"

namespace halfspace {
namespace {

using ReopenedPicture = Program;

TEST_F(ReopenedPicture, IsExplainedAndDrawnAsItsSession) {
  const std::string scene = "signed-distance --set Q=1,2/3,1 ";
  const std::string explanation = run("explain " + scene).out;
  for (const std::string picture : {"a.png", "a.svg", "a.pdf"}) {
    SCOPED_TRACE(picture);
    EXPECT_EQ(run("render " + scene + "--step 2 -o " + picture).status, 0);
    const Ran explained = run("explain " + picture);
    EXPECT_EQ(explained.status, 0) << explained.err;
    EXPECT_EQ(explained.out, explanation);
    // The step goes with it: drawn again, it is the same file, with the same session in it.
    EXPECT_EQ(run("render " + picture + " -o again-" + picture).status, 0);
    EXPECT_EQ(file("again-" + picture), file(picture));
  }
}

TEST_F(ReopenedPicture, OfAFlightsFrame_IsThatFrame) {
  EXPECT_EQ(run("render photon-torpedo --set seed=7 --frames 38:39 -o %02d.svg").status, 0);
  EXPECT_EQ(run("explain 38.svg").out, run("explain photon-torpedo --set seed=7 --set frame=38").out);
  EXPECT_NE(run("explain 38.svg").out, run("explain 39.svg").out);
}

TEST_F(ReopenedPicture, OfAFlatPicture_IsItsScene) {
  EXPECT_EQ(run("render ray-plane-picture --flat -o flat.png").status, 0);
  EXPECT_EQ(run("explain flat.png").out, run("explain ray-plane-picture").out);
}

TEST_F(ReopenedPicture, DrawnAnonymously_HoldsNothing) {
  for (const std::string picture : {"a.png", "a.svg", "a.pdf"}) {
    EXPECT_EQ(run("render signed-distance --anonymous -o " + picture).status, 0);
    EXPECT_EQ(file(picture).find("halfspace-session"), std::string::npos);
    EXPECT_EQ(file(picture).find("x-halfspace"), std::string::npos);
    expectRefused("explain " + picture, picture + ": This picture holds no scene of Halfspace.");
  }
}

TEST_F(ReopenedPicture, WithItsCode_IsReadOffItsPixels) {
  const std::string scene = "signed-distance --set Q=1,2/3,1 ";
  const std::string explanation = run("explain " + scene).out;
  for (const std::string measured : {"", "--width 8cm --dpi 150", "--theme dark --transparent"}) {
    SCOPED_TRACE(measured);
    EXPECT_EQ(run("render " + scene + "--step 2 --qr " + measured + " -o a.png").status, 0);
    for (const std::string scan : {"scan.jpg", "scan.png"}) {
      const QImage drawn = picture("a.png").convertToFormat(QImage::Format_RGB888);
      // Nothing but pixels goes along.
      const QImage pixels(drawn.constBits(), drawn.width(), drawn.height(),
                          static_cast<int>(drawn.bytesPerLine()), drawn.format());
      EXPECT_TRUE(pixels.save(inFolder(scan).c_str()));
      EXPECT_EQ(file(scan).find("halfspace-session"), std::string::npos);
      const Ran explained = run("explain " + scan);
      EXPECT_EQ(explained.status, 0) << explained.err;
      EXPECT_EQ(explained.out, explanation);
    }
  }
  EXPECT_EQ(run("render scan.jpg -o again.svg").status, 0);
  EXPECT_EQ(run("render " + scene + "--step 2 -o first.svg").status, 0);
  EXPECT_EQ(file("again.svg"), file("first.svg"));
}

TEST_F(ReopenedPicture, WithItsCode_IsWiderByIt_InEveryFormat) {
  EXPECT_EQ(run("render signed-distance --qr -o a.png").status, 0);
  const QImage with = picture("a.png");
  EXPECT_GT(with.width(), 1800);
  EXPECT_EQ(with.height(), 1000);
  for (const std::string format : {"svg", "pdf", "tex"}) {
    EXPECT_EQ(run("render signed-distance -o without." + format).status, 0);
    EXPECT_EQ(run("render signed-distance --qr -o with." + format).status, 0);
    EXPECT_GT(file("with." + format).size(), file("without." + format).size() + 1000);
  }
  EXPECT_NE(file("with.svg").find("The QR code beside the figure holds its scene"), std::string::npos);
}

TEST_F(ReopenedPicture, ThatIsToHaveACodeAndNoScene_IsRefused) {
  expectRefused("render signed-distance --qr --anonymous -o a.png", "--qr excludes --anonymous");
}

TEST_F(ReopenedPicture, OfFramesWithTheirCodes_IsRefused_ForTheyWouldDifferInSize) {
  expectRefused("render photon-torpedo --qr --frames 0:3 -o %02d.png", "--qr excludes --frames");
}

TEST_F(ReopenedPicture, OfASceneThatIsTooLongForACode_IsRefused_AndNothingIsWritten) {
  nlohmann::json session = nlohmann::json::parse(
      R"({"format": "halfspace", "version": 4, "lesson": "signed-distance", "step": 0})");
  for (int i = 0; i < 300; ++i)
    session["scene"].push_back(
        {{"name", "P" + std::to_string(i)},
         {"point", {std::to_string(i * 7919 % 1009), std::to_string(i * 104729 % 997), "0"}}});
  write("long.halfspace", session.dump());
  expectRefused("render long.halfspace --qr -o a.png", "too long for a QR code");
  EXPECT_FALSE(std::filesystem::exists(inFolder("a.png")));
}

TEST_F(ReopenedPicture, OfAPhotographWithoutACode_SaysHowToTakeOne) {
  QImage plain(60, 40, QImage::Format_RGB888);
  plain.fill(Qt::gray);
  EXPECT_TRUE(plain.save(inFolder("IMG_1.JPG").c_str()));
  expectRefused("explain IMG_1.JPG", "No QR code is found in this picture");
  expectRefused("IMG_1.JPG", "No QR code is found in this picture");
}

TEST_F(ReopenedPicture, ThatIsDamaged_IsRefusedInASentence) {
  EXPECT_EQ(run("render signed-distance -o a.png").status, 0);
  std::string png = file("a.png");
  const auto place = png.find("halfspace-session");
  ASSERT_NE(place, std::string::npos);
  png[place + 40] = static_cast<char>(png[place + 40] ^ 1);
  write("a.png", png);
  expectRefused("explain a.png", "a.png: The scene in this picture is damaged");
  expectRefused("render a.png -o b.png", "a.png: The scene in this picture is damaged");
  expectRefused("a.png", "a.png: The scene in this picture is damaged");
}

} // namespace
} // namespace halfspace
