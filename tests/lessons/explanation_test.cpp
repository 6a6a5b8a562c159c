#include "lessons/explanation.h"

#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace halfspace {
namespace {

Outcome sample() {
  Outcome outcome;
  outcome.caseName = "hit";
  outcome.values = {{"tenth", "", Surd(Rational(1, 10))},
                    {"root", "", Surd::root(3, Rational(1, 3))},
                    {"huge", "", Surd(Rational(mp::pow(Integer(10), 400)))},
                    {"foot", "\\mark{F}{F}", std::vector<Surd>{1, Rational(1, 2), -3}},
                    {"t", "\\lambda", Surd::root(3, Rational(-1, 3))},
                    {"side", "\\text{side}", std::string("on")},
                    {"feature", "", 2},
                    {"perp", "", std::vector<NamedValue>{{"uu", "\\vec u\\cdot\\vec u", Surd(80)}}}};
  outcome.working.lines = {
      {"t", "\\mark{t}{t} = \\frac{a}{b}", "= \\frac{1}{3}", "\\approx 0.33", "It is < 1 & so on."}};
  outcome.description = "100% done_ok {now}";
  return outcome;
}

TEST(ExplanationJson, OfValues_FollowsTheEvalFormatInOrder) {
  const auto json = nlohmann::ordered_json::parse(explanationJson("x", sample()));
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
  EXPECT_EQ(json["working"][0]["symbols"], "t = \\frac{a}{b}");
  EXPECT_EQ(json["working"][0]["text"], "t = a/b = 1/3 ≈ 0.33");
}

TEST(ExplanationText, CallsTheValuesAsTheLinesDoOneToALine) {
  const std::string text = explanationText("A title", sample());
  for (const char *part :
       {"A title\n", "t = a/b = 1/3 ≈ 0.33\n", "It is < 1 & so on.", "\nF = (1, 1/2, −3)\n",
        "\nλ = −(√3)/3\n", "\nside: on\n", "\nu·u = 80\n", "100% done_ok {now}"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  for (const char *part : {"tenth", "feature", "perp"})
    EXPECT_EQ(text.find(part), std::string::npos) << part << " has no name for a learner";
}

TEST(ExplanationLatex, AlignsAtTheFirstRelationAndEscapesWords) {
  const std::string latex = explanationLatex("50 %", sample());
  for (const char *part : {"\\paragraph{50 \\%}", "\\begin{align*}",
                           "t &= \\frac{a}{b} = \\frac{1}{3} \\approx 0.33", "100\\% done\\_ok \\{now\\}"})
    EXPECT_NE(latex.find(part), std::string::npos) << part << "\n" << latex;
  EXPECT_EQ(latex.find("\\mark"), std::string::npos);
}

} // namespace
} // namespace halfspace
