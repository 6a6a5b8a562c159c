// The sessions of all lessons, put into each carrier and taken out again.
#include "lessons/lesson/lesson.h"
#include "lessons/lesson/lesson_start.h"
#include "lessons/scene/file/session_file.h"
#include "tests/carriers/pictures.h"
#include "tests/test_name.h"

namespace halfspace {
namespace {

/// As somebody leaves it who has moved something, turned the camera and gone on a step.
Session changed(Session session) {
  const CoordinateId id = coordinatesOf(session.scene).front();
  Object object = *findObject(session.scene, id.object);
  coordinate(object, id.index).x += Rational(1, 7);
  setObject(session.scene, id.object, std::move(object));
  session.step = 1;
  session.view = ChosenView{};
  return session;
}

class RoundTrip : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Each, RoundTrip, testing::Values("PNG", "SVG", "PDF"), test::testName);

TEST_P(RoundTrip, OfEveryLesson_AsItBeginsAndChanged_GivesTheSameBytes) {
  const Carrier &carrier = test::carrierCalled(GetParam());
  const std::string picture = test::pictureOf(carrier);
  const LessonLibrary library = readLessons(LESSON_FOLDER);
  ASSERT_FALSE(library.lessons.empty());
  for (const Lesson &lesson : library.lessons) {
    SCOPED_TRACE(lesson.id);
    const Session start = startOf(lesson);
    for (const Session &session : {start, changed(start)}) {
      const std::string text = writeSession(session);
      const std::string carrying = carrier.put(picture, text);
      EXPECT_EQ(carrying, carrier.put(picture, text));
      EXPECT_LT(carrying.size(), picture.size() + 2500);
      const auto taken = carrier.take(carrying);
      ASSERT_TRUE(taken) << taken.problem().sentence;
      EXPECT_EQ(*taken, text);
    }
  }
}

TEST_P(RoundTrip, OfWhatIsNotAscii_AndOfAllBytes_GivesTheSameBytes) {
  const Carrier &carrier = test::carrierCalled(GetParam());
  EXPECT_EQ(test::sentenceOf(carrier.take(carrier.put(test::pictureOf(carrier), test::someSession()))),
            "taken: " + test::someSession());
}

TEST_P(RoundTrip, OfAPictureWithoutASession_SaysSo) {
  const Carrier &carrier = test::carrierCalled(GetParam());
  EXPECT_EQ(test::sentenceOf(carrier.take(test::pictureOf(carrier))), test::foreign);
}

TEST_P(RoundTrip, OfASessionBeyondTheLimit_IsRefused) {
  const Carrier &carrier = test::carrierCalled(GetParam());
  std::string session = test::someSession();
  session.resize(maxSessionBytes + 1, ' ');
  EXPECT_EQ(test::sentenceOf(carrier.take(carrier.put(test::pictureOf(carrier), session))),
            "The scene in this picture is too large: at most 16 MiB are read.");
}

TEST_P(RoundTrip, OfAPictureWithAChangedByte_IsTheSessionOrASentence) {
  const Carrier &carrier = test::carrierCalled(GetParam());
  const std::string whole = carrier.put(test::pictureOf(carrier), test::someSession());
  bool wasRefused = false;
  for (std::size_t place = 0; place < whole.size(); ++place) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 0x15);
    if (!carrier.isOf(damaged))
      continue;
    const auto taken = carrier.take(damaged);
    if (taken) {
      EXPECT_EQ(*taken, test::someSession()) << place;
    } else {
      EXPECT_FALSE(taken.problem().sentence.empty());
    }
    wasRefused = wasRefused || !taken;
  }
  EXPECT_TRUE(wasRefused);
}

TEST_P(RoundTrip, OfAPictureThatIsCutOff_IsTheSessionOrASentence) {
  const Carrier &carrier = test::carrierCalled(GetParam());
  const std::string whole = carrier.put(test::pictureOf(carrier), test::someSession());
  for (std::size_t length = 0; length < whole.size(); ++length) {
    if (const std::string cut = whole.substr(0, length); carrier.isOf(cut)) {
      if (const auto taken = carrier.take(cut)) {
        EXPECT_EQ(*taken, test::someSession()) << length;
      }
    }
  }
}

TEST(CarrierOf, GoesByHowAFileBegins) {
  for (const Carrier &carrier : carriers())
    EXPECT_EQ(carrierOf(test::pictureOf(carrier)), &carrier) << carrier.name;
  EXPECT_EQ(carrierOf(""), nullptr);
  EXPECT_EQ(carrierOf(test::someSession()), nullptr);
  EXPECT_EQ(carrierOf("---\nid: lesson\n---\n## The <svg> of a step\n"), nullptr);
  EXPECT_EQ(carrierOf("<html><body>no picture</body></html>"), nullptr);
}

TEST(NamesPicture, GoesByTheEnding_WhateverItsCase) {
  for (const char *file : {"x.png", "a/x.SVG", "x.pdf", "IMG_0001.JPG", "x.jpeg"})
    EXPECT_TRUE(namesPicture(file)) << file;
  for (const char *file : {"x.tex", "png", "x.gif", ""})
    EXPECT_FALSE(namesPicture(file)) << file;
}

TEST(WithSession, InAFormatThatCarriesNone_LeavesItAsItIs) {
  const std::string tikz = test::vectorPicture(".tex");
  EXPECT_EQ(withSession(tikz, test::someSession()), tikz);
}

} // namespace
} // namespace halfspace
