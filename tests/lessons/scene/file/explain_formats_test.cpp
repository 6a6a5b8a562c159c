#include "lessons/scene/file/explain_formats.h"

#include "lessons/construction/parts/worked_lines.h"
#include "lessons/lesson/lesson.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>

namespace halfspace {
namespace {

Evaluation sample() {
  const Term a = name(letter("a"), Rational(2, 7));
  const Term b = name(letter("b"), Rational(3, 1'000'000'007));
  const Term t = name(letter("t"), Rational(2'000'000'014, 21)).marked("t");
  const Term F = name(letter("F"), ExactVec3(1, Rational(1, 2), -3)).marked("F");
  const Term u = name(vectorLetter("u"), ExactVec3(4, 8, 0));
  const std::vector<NamedValue> values{{"tenth", {}, Surd(Rational(1, 10))},
                                       {"root", {}, Surd::root(3, Rational(1, 3))},
                                       {"huge", {}, Surd(powerOfTen(400))},
                                       listed("foot", F),
                                       listed("t", name(letter("λ"), Surd::root(3, Rational(-1, 3)))),
                                       {"side", std::string("side"), Word{"on", "in the plane"}},
                                       {"feature", {}, 2},
                                       {"perp", {}, std::vector<NamedValue>{listed("uu", dot(u, u))}}};
  const CaseWords told{"hit", "100% done_ok {now}: λ ≈ −2·10⁻³°", false};
  Explanation lines;
  lines.add("t", [=] { return line(withNumbers(t == a / b), "It is < 1 & so on."); });
  const auto outcome = std::make_shared<const Outcome>(
      Outcome{{{"F", PointObject{{1, Rational(1, 2), -3}}}},
              Lazy<CaseWords>([told] { return told; }),
              Lazy<std::vector<NamedValue>>([values] { return values; }),
              Lazy<Explanation>([lines] { return lines; }),
              Lazy<Figure>([] { return Figure(); }),
              Lazy<std::vector<SpecialCase>>([] { return std::vector<SpecialCase>(); }),
              Lazy<Crossings>([] { return Crossings(); }),
              nullptr});
  return {{{"it", "any", {}, {}, {}, outcome}}};
}

TEST(ExplanationJson, OfValues_FollowsTheEvalFormatInOrder) {
  const auto json = nlohmann::ordered_json::parse(explanationJson("x", {}, sample()));
  EXPECT_EQ(json["lesson"], "x");
  EXPECT_EQ(json["case"], "hit");
  const auto &values = json["values"];
  EXPECT_EQ(values.begin().key(), "tenth");
  EXPECT_EQ(values["tenth"]["exact"], "1/10");
  EXPECT_EQ(values["tenth"]["value"].dump(), "0.1");
  EXPECT_EQ(values["root"]["exact"], "1/3*sqrt(3)");
  EXPECT_TRUE(values["huge"]["value"].is_null());
  EXPECT_EQ(values["foot"]["exact"].dump(), R"(["1","1/2","-3"])");
  EXPECT_EQ(values["side"], "on");
  EXPECT_EQ(values["feature"], 2);
  EXPECT_EQ(values["perp"]["uu"]["value"], 80);
  const auto &line = json["working"][0];
  EXPECT_EQ(line["symbols"], "t = \\frac{a}{b}");
  EXPECT_EQ(line["numbers"], "= \\frac{2/7}{3/1000000007}");
  EXPECT_EQ(line["result"], "= \\frac{2000000014}{21}");
  EXPECT_EQ(line["text"], "t = a/b = (2/7)/(3/1000000007) = 2000000014/21");
  EXPECT_EQ(line["spoken"],
            "t equals a over b equals the fraction the fraction 2 over 7 end of fraction over the "
            "fraction 3 over 1000000007 end of fraction end of fraction equals 2000000014 over 21");
}

TEST(ExplanationText, CallsTheValuesAsTheLinesDoOneToALine) {
  const std::string text = explanationText("A title", sample());
  for (const char *part : {"A title\n", "t = a/b = (2/7)/(3/1000000007) = 2000000014/21\n",
                           "It is < 1 & so on.", "\nF = (1, 1/2, −3)\n", "\nλ = −√3/3\n",
                           "\nside: in the plane\n", "\nu·u = 80\n", "100% done_ok {now}"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  for (const char *part : {"tenth", "feature", "perp"})
    EXPECT_EQ(text.find(part), std::string::npos) << part << " has no name for a learner";
}

/// `plane2` and `mesh0` are places in a list, for programs; a learner reads letters.
TEST(ExplanationText, OfEveryLesson_NamesNoPlaceInAList) {
  const std::regex placeInAList(": [a-z]+[0-9]+\n");
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons) {
    const std::string text = explanationText(lesson.title, evaluate(lesson.scene));
    EXPECT_FALSE(std::regex_search(text, placeInAList)) << text;
  }
}

TEST(ExplanationText, OfABoundPoint_TellsWhereItIsOrWhyNowhere) {
  Object half = *makeObject("point-on-line");
  half[0].x = Rational(1, 2);
  const Object nowhere = *makeObject("point-on-plane");
  const Scene scene{{{"g", LineObject{{1, 0, 0}, {4, 0, 2}}},
                     {"P", half, "g"},
                     {"E", PlaneObject{{0, 0, 0}, {0, 0, 0}}},
                     {"S", nowhere, "E"}}};
  EXPECT_EQ(explanationText("Places", evaluate(scene)),
            "Places\n\nP = (3, 0, 1)\nAt the moment E has no place for S.\n");
}

TEST(ExplanationLatex, AlignsAtTheFirstRelationAndEscapesWords) {
  const std::string latex = explanationLatex("50 %", sample());
  for (const char *part : {"\\paragraph{50 \\%}", "\\begin{align*}", "t &= \\frac{a}{b} = \\frac{2/7}",
                           "\\end{align*}\nIt is < 1 \\& so on.\n", "100\\% done\\_ok \\{now\\}",
                           "$\\lambda$ $\\approx$ $-$2$\\cdot$10$^{-}$$^{3}$$^{\\circ}$"})
    EXPECT_NE(latex.find(part), std::string::npos) << part << "\n" << latex;
  EXPECT_EQ(latex.find("\\mark"), std::string::npos);
  EXPECT_TRUE(std::all_of(latex.begin(), latex.end(), [](char c) {
    return static_cast<unsigned char>(c) < 128;
  })) << "pdflatex knows no other characters";
}

TEST(ExplanationMathMl, IsASectionWithTheWordsAsParagraphs) {
  const std::string html = explanationMathMl("a < b", sample());
  EXPECT_TRUE(html.starts_with("<section>\n<h2>a &lt; b</h2>\n<p><math ")) << html;
  for (const char *part : {"<mfrac><mi>a</mi><mi>b</mi></mfrac>", "<p>It is &lt; 1 &amp; so on.</p>\n",
                           "<p>100% done_ok {now}: λ ≈ −2·10⁻³°</p>\n</section>\n"})
    EXPECT_NE(html.find(part), std::string::npos) << part << "\n" << html;
  EXPECT_EQ(html.find("data-mark"), std::string::npos);
  EXPECT_EQ(html.find("<h3>"), std::string::npos) << "there is only one construction";
}

} // namespace
} // namespace halfspace
