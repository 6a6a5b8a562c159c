// Sessions out of files, whatever these are.
#include "widgets/carriers/found_session.h"

#include "lessons/lesson/lesson.h"
#include "lessons/lesson/lesson_start.h"
#include "lessons/scene/file/session_file.h"
#include "tests/carriers/pictures.h"
#include "tests/carriers/qr/photographing.h"
#include "tests/program_test.h"

namespace halfspace {
namespace {

class FindSession : public ProgramTest {
protected:
  [[nodiscard]] Result<FoundSession> found(const std::string &content) const {
    write("file", content);
    return findSession(inFolder("file"));
  }
};

TEST_F(FindSession, InAFileOfItsOwnAndInEachPicture_IsTheSame_WhateverTheyAreCalled) {
  const LessonLibrary library = readLessons(LESSON_FOLDER);
  const Session session = startOf(library.lessons.front());
  const std::string text = writeSession(session);
  const auto own = found(text);
  ASSERT_TRUE(own);
  EXPECT_FALSE(own->isInPicture);
  for (const Carrier &carrier : carriers()) {
    const auto carried = found(carrier.put(test::pictureOf(carrier), text));
    ASSERT_TRUE(carried) << carrier.name;
    EXPECT_TRUE(carried->isInPicture);
    EXPECT_TRUE(carried->session == session);
    EXPECT_EQ(carried->text, own->text);
  }
}

TEST_F(FindSession, InAPhotographOfItsCode_IsTheSame) {
  const Session session = startOf(readLessons(LESSON_FOLDER).lessons.front());
  const std::string text = writeSession(session);
  const GreyImage image = test::drawn(*qrCodeOf(text));
  for (const std::string &picture : {test::pngOf(image), test::jpegOf(image)}) {
    const auto photographed = found(picture);
    ASSERT_TRUE(photographed) << photographed.problem().text();
    EXPECT_TRUE(photographed->isInPicture);
    EXPECT_TRUE(photographed->session == session);
    EXPECT_EQ(photographed->text, text);
  }
}

TEST_F(FindSession, InAPictureThatCarriesOneAndShowsTheCodeOfAnother_IsTheOneThatItCarries) {
  const LessonLibrary library = readLessons(LESSON_FOLDER);
  const std::string carried = writeSession(startOf(library.lessons.front()));
  const std::string shown = writeSession(startOf(library.lessons.back()));
  const auto both = found(withSession(test::pngOf(test::drawn(*qrCodeOf(shown))), carried));
  ASSERT_TRUE(both);
  EXPECT_EQ(both->text, carried);
}

TEST_F(FindSession, InAPhotographWithoutACode_TellsHowToTakeOne) {
  const auto none = found(test::jpegOf({40, 30, std::vector<std::uint8_t>(1200, 200)}));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.problem().text(),
            inFolder("file").string() +
                ": No QR code is found in this picture. Photograph it from straight above, in "
                "even light, and so near that it fills half of the picture.");
}

TEST_F(FindSession, ThatIsNone_IsRefusedAsInAFileOfItsOwn_WithTheFilesName) {
  const std::string tampered = "{\n \"format\": \"halfspace\",\n \"version\": 4,\n \"lesson\": 7\n}\n";
  const std::string sentence = readSession(tampered, "").problem().sentence;
  for (const Carrier &carrier : carriers()) {
    const auto refused = found(carrier.put(test::pictureOf(carrier), tampered));
    ASSERT_FALSE(refused) << carrier.name;
    EXPECT_EQ(refused.problem().sentence, sentence);
    EXPECT_EQ(refused.problem().file, inFolder("file").string());
    const auto foreign = found(test::pictureOf(carrier));
    ASSERT_FALSE(foreign);
    EXPECT_EQ(foreign.problem().text(), inFolder("file").string() + ": " + test::foreign);
  }
}

TEST_F(FindSession, InAFileBeyondTheLimit_IsRefused) {
  std::string png = test::pngPicture();
  png.resize(mostPictureBytes + 1);
  EXPECT_FALSE(found(png));
  EXPECT_FALSE(findSessionIn(png, ""));
}

} // namespace
} // namespace halfspace
