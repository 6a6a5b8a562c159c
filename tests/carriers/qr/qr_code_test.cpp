// Codes as they are made, of the sessions of all lessons and of those that are too long.
#include "widgets/carriers/qr/qr_code.h"

#include "lessons/lesson/lesson.h"
#include "lessons/lesson/lesson_start.h"
#include "lessons/scene/file/session_file.h"
#include "tests/carriers/qr/photographing.h"
#include "widgets/carriers/deflate.h"
#include "widgets/carriers/qr/qr_text.h"
#include "widgets/carriers/qr/read_codes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

/// The side of the largest that is made.
constexpr int largestSide = 117;

/// What does not become smaller when it is packed.
std::string noise(std::size_t size) {
  std::mt19937 dice(1);
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i)
    bytes += static_cast<char>(dice());
  return bytes;
}

/// The longest that fits.
std::string longestNoise() {
  std::string bytes = noise(mostBytesInCode);
  while (deflated(bytes).size() > mostBytesInCode)
    bytes.pop_back();
  return bytes;
}

TEST(QrCode, OfEveryLesson_IsSmall_AndSaysItsSession) {
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons) {
    SCOPED_TRACE(lesson.id);
    const std::string session = writeSession(startOf(lesson));
    const auto code = qrCodeOf(session);
    ASSERT_TRUE(code) << code.problem().sentence;
    EXPECT_EQ(*code, *qrCodeOf(session));
    EXPECT_LE(millimetresOf(*code), 45);
    const auto read = readCodes(test::drawn(*code));
    ASSERT_EQ(read.size(), 1U);
    EXPECT_TRUE(read.front().isWhole);
    const auto said = sessionInQrText(read.front().text);
    ASSERT_TRUE(said) << said.problem().sentence;
    EXPECT_EQ(*said, session);
  }
}

TEST(QrCode, OfTheLongestSession_IsNoLargerThanCanBePhotographed) {
  const std::string session = longestNoise();
  const auto code = qrCodeOf(session);
  ASSERT_TRUE(code);
  EXPECT_EQ(code->side, largestSide);
  EXPECT_EQ(code->modules.size(), std::size_t(largestSide) * largestSide);
  EXPECT_EQ(*sessionInQrText(readCodes(test::drawn(*code)).front().text), session);
}

TEST(QrCode, OfALongerSession_IsASentenceThatTellsTheLimit) {
  const auto code = qrCodeOf(longestNoise() + "more");
  ASSERT_FALSE(code);
  EXPECT_NE(code.problem().sentence.find("holds 960"), std::string::npos) << code.problem().sentence;
  EXPECT_FALSE(qrCodeOf(noise(100000)));
}

TEST(QrCode, WithANinthOfItCovered_IsRead) {
  const std::string session = noise(300);
  QrCode code = *qrCodeOf(session);
  const int covered = code.side / 3; // of the side: a ninth of the area, and none of the corners
  for (int row = covered; row < 2 * covered; ++row)
    for (int column = covered; column < 2 * covered; ++column)
      code.modules[std::size_t(row) * std::size_t(code.side) + std::size_t(column)] = true;
  const auto read = readCodes(test::drawn(code));
  ASSERT_EQ(read.size(), 1U);
  EXPECT_TRUE(read.front().isWhole);
  EXPECT_EQ(*sessionInQrText(read.front().text), session);
}

TEST(SessionInQrText, ThatIsDamagedOrUnpacksToTooMuch_IsASentence) {
  const std::string text = *qrTextOf("a session");
  EXPECT_EQ(*sessionInQrText(text), "a session");
  const std::string bomb = *qrTextOf(std::string(1U << 19U, 'x'));
  EXPECT_TRUE(sessionInQrText(bomb));
  for (const std::string &damaged :
       {std::string(), std::string("HALFSPACE:"), text.substr(0, text.size() - 3), text + "x",
        "halfspace:" + text.substr(10)}) {
    const auto session = sessionInQrText(damaged);
    ASSERT_FALSE(session) << damaged;
    EXPECT_EQ(session.problem().sentence,
              "The scene in this picture is damaged, and cannot be read any more.");
  }
}

} // namespace
} // namespace halfspace
