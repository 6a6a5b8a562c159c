// Pictures are taken from the lesson's own folder and from nowhere else.
#include "lessons/lesson/lesson_picture.h"

#include "tests/program_test.h"

namespace halfspace {
namespace {

class LessonPicture : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    std::filesystem::create_directories(home() / "figures");
    write("secret.png", "secret");
    write("lesson/a.png", "a");
    write("lesson/figures/b.png", "b");
  }
  [[nodiscard]] std::filesystem::path home() const { return inFolder("lesson"); }
  [[nodiscard]] std::string refusal(const std::string &name) const {
    const auto picture = readLessonPicture(home(), name);
    return picture ? "read" : picture.problem().sentence;
  }
};

TEST_F(LessonPicture, InTheFolder_IsRead) {
  EXPECT_EQ(*readLessonPicture(home(), "a.png"), "a");
  EXPECT_EQ(*readLessonPicture(home(), "figures/b.png"), "b");
  EXPECT_EQ(*readLessonPicture(home(), "figures/../a.png"), "a");
}

TEST_F(LessonPicture, OutsideOfTheFolder_IsRefused) {
  std::filesystem::create_symlink("../secret.png", home() / "link.png");
  std::filesystem::create_directory(inFolder("lesson2"));
  write("lesson2/c.png", "c");
  for (const std::string &name : {std::string("../secret.png"), inFolder("secret.png").string(),
                                  std::string("figures/../../secret.png"), std::string("link.png"),
                                  std::string("../lesson2/c.png"), std::string("..")})
    EXPECT_NE(refusal(name).find("is not in the lesson's folder"), std::string::npos)
        << name << refusal(name);
}

TEST_F(LessonPicture, ThatIsNotThere_OrOnTheWeb_IsRefused) {
  for (const char *name : {"c.png", "https://a.b/c.png", "file:///etc/passwd"})
    EXPECT_NE(refusal(name).find("There is no picture"), std::string::npos) << name;
  EXPECT_NE(refusal("figures").find("cannot be read"), std::string::npos);
  EXPECT_NE(refusal("").find("cannot be read"), std::string::npos);
}

TEST_F(LessonPicture, OfAGibibyte_IsRefusedAtOnce) {
  write("lesson/large.png", "");
  std::filesystem::resize_file(home() / "large.png", std::uintmax_t{1} << 30U);
  EXPECT_NE(refusal("large.png").find("too large"), std::string::npos) << refusal("large.png");
}

} // namespace
} // namespace halfspace
