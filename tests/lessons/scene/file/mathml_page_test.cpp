// What is exported as MathML, through xmllint where that is installed.
#include "lessons/lesson/lesson.h"
#include "lessons/scene/file/explain_formats.h"
#include "lessons/scene/session.h"
#include "tests/lessons/construction/random_objects.h"
#include "tests/program_test.h"

#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

/// The part of MathML Core that is written: each element with as many children and with those attributes as
/// it has there.
constexpr std::string_view documentType =
    R"(<!ENTITY % formula "mrow|mi|mn|mo|mspace|mfrac|msqrt|msub|msup|mover|mstyle">
<!ELEMENT body (section*)>
<!ELEMENT section (h2, (h3|p)*)>
<!ELEMENT h2 (#PCDATA)>
<!ELEMENT h3 (#PCDATA)>
<!ELEMENT p (#PCDATA|math)*>
<!ELEMENT math (%formula;)*>
<!ATTLIST math xmlns CDATA #REQUIRED display (block) #IMPLIED>
<!ELEMENT mrow (%formula;|mtable)*>
<!ELEMENT mi (#PCDATA)>
<!ELEMENT mn (#PCDATA)>
<!ELEMENT mo (#PCDATA)>
<!ATTLIST mo form (prefix|infix|postfix) #IMPLIED>
<!ELEMENT mspace EMPTY>
<!ATTLIST mspace width CDATA #REQUIRED>
<!ELEMENT mfrac ((%formula;), (%formula;))>
<!ELEMENT msqrt (%formula;)*>
<!ELEMENT msub ((%formula;), (%formula;))>
<!ELEMENT msup ((%formula;), (%formula;))>
<!ELEMENT mover ((%formula;), (%formula;))>
<!ATTLIST mover accent (true|false) #IMPLIED>
<!ELEMENT mstyle (%formula;)*>
<!ATTLIST mstyle displaystyle (true|false) #IMPLIED>
<!ELEMENT mtable (mtr)+>
<!ELEMENT mtr (mtd)+>
<!ELEMENT mtd (%formula;)*>
)";

class MathMlPage : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (!has("xmllint"))
      GTEST_SKIP() << "xmllint is not installed";
  }

  /// What xmllint says of sections; empty where all is well.
  std::string complaintAbout(const std::string &sections) const {
    write("page.dtd", std::string(documentType));
    write("page.xml", "<body>" + sections + "</body>\n");
    const Ran ran = shell("xmllint --huge --dtdvalid page.dtd --noout page.xml >.out 2>.err");
    return ran.status == 0 ? ran.err : "not valid: " + ran.err;
  }
};

TEST_F(MathMlPage, OfOurLessons_IsValid) {
  std::string sections;
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons)
    sections += explanationMathMl(lesson.title, evaluate(lesson.scene));
  EXPECT_EQ(complaintAbout(sections), "");
}

TEST_F(MathMlPage, OfRandomAndDegenerateScenes_IsValid) {
  constexpr int scenesPerWriting = 3;
  RandomObjects random(11);
  std::string sections;
  for (const Construction &construction : constructions())
    for (const Writing writing : {Writing::SmallIntegers, Writing::Halves, Writing::Decimals,
                                  Writing::Fractions, Writing::LongFractions, Writing::LargeIntegers})
      for (int i = 0; i < scenesPerWriting; ++i)
        sections += explanationMathMl(
            "Scene", evaluate(sceneOf(construction, random.objectsFor(construction, writing))));
  EXPECT_EQ(complaintAbout(sections), "");
}

TEST_F(MathMlPage, OfTitlesInAnyLetters_IsValid) {
  const Evaluation outcome = evaluate(readLessons(LESSON_FOLDER).lessons.front().scene);
  std::string sections;
  for (const char *title : {"a < b & c > d \"e\" 'f'", "]]> <![CDATA[ <!-- --> &amp; <?x?>",
                            "ℝ³, плоскость, 平面, 🙂"})
    sections += explanationMathMl(title, outcome);
  EXPECT_EQ(complaintAbout(sections), "");
}

TEST_F(MathMlPage, WithAnElementMissing_IsFoundNotToBeValid) {
  const std::string half = "<section><h2/><p><math xmlns=\"\"><mfrac><mi>a</mi></mfrac></math></p></section>";
  EXPECT_NE(complaintAbout(half).find("Element mfrac content"), std::string::npos);
}

} // namespace
} // namespace halfspace
