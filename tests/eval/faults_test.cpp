// What is wrong with a question: each code, and which is given where several apply.
#include "tests/eval/answers.h"

#include "eval/fault.h"
#include "eval/json_line.h"

#include <algorithm>
#include <set>

namespace halfspace {
namespace {

struct Wrong {
  std::string code;
  std::string line;
};

/// A question of this query with these operands.
std::string question(const std::string &query, const std::string &operands) {
  return R"({"id":7,"query":")" + query + R"(",)" + operands + "}";
}

const std::string goodRay = R"("ray":{"origin":[0,0,0],"direction":[0,0,1]})";
const std::string stillRay = R"("ray":{"origin":[0,0,0],"direction":[0,0,0]})";
const std::string badRay = R"("ray":{"origin":[0,0],"direction":[0,0,0]})";
const std::string goodPlane = R"("plane":{"coefficients":[0,0,1,0]})";
const std::string flatPlane = R"("plane":{"coefficients":[0,0,0,1]})";
const std::string linePlane = R"("plane":{"points":[[0,0,0],[1,1,1],[2,2,2]]})";
const std::string noLine = R"("line":{"plucker":{"direction":[1,0,0],"moment":[1,0,0]}})";
const std::string stillLine = R"("line":{"through":[[1,2,3],[1,2,3]]})";

const std::vector<Wrong> oneOfEach{
    {"bad-json", "{"},
    {"unknown-query", "{}"},
    {"missing-operand", question("plane", goodRay)},
    {"bad-operand", question("plane", R"("plane":1)")},
    {"zero-vector", question("ray-plane", stillRay + "," + goodPlane)},
    {"zero-normal", question("plane", flatPlane)},
    {"collinear-points", question("plane", linePlane)},
    {"degenerate-triangle", question("ray-triangle", goodRay + R"(,"triangle":[[0,0,0],[1,1,1],[2,2,2]])")},
    {"not-planar", question("ray-polygon", goodRay + R"(,"polygon":[[0,0,0],[1,0,0],[1,1,1],[0,1,0]])")},
    {"not-convex", question("ray-polygon", goodRay + R"(,"polygon":[[0,0,0],[1,0,0],[2,0,0],[0,1,0]])")},
    {"not-closed",
     question("ray-solid", goodRay + R"(,"solid":{"vertices":[[0,0,0],[3,0,0],[0,3,0],[0,0,3]],)"
                                     R"("faces":[[0,2,1],[0,1,3],[1,2,3],[1,2,3]]})")},
    {"not-a-line", question("line-plane", noLine + "," + goodPlane)}};

TEST(Faults, EachCode_IsGivenAndKeepsTheId) {
  std::set<std::string> codes{"too-large"};
  for (const auto &[code, line] : oneOfEach) {
    EXPECT_EQ(codeOf(line), code) << line;
    codes.insert(code);
    if (code != "bad-json" && code != "unknown-query") {
      EXPECT_EQ(parsed(answerTo(line))["id"], 7);
    }
  }
  for (int code = 0; code <= static_cast<int>(FaultCode::NotALine); ++code)
    EXPECT_TRUE(codes.contains(std::string(nameOf(static_cast<FaultCode>(code))))) << code;
}

TEST(Faults, Answer_HasAnIdACodeAMessageAndNoResult) {
  const Json answer = parsed(answerTo(question("plane", flatPlane)));
  EXPECT_EQ(answer.size(), 3U);
  EXPECT_EQ(answer["ok"], false);
  EXPECT_EQ(answer["error"].size(), 2U);
  EXPECT_NE(answer["error"]["message"].get<std::string>().find("plane"), std::string::npos);
}

TEST(Faults, LineBeyondTheLargestLength_IsTooLargeWhateverElseIsWrong) {
  const std::string shell = R"({"id":1,"x":""})";
  std::string line = R"({"id":1,"x":")" + std::string(maxLineLength - shell.size(), 'a') + R"("})";
  ASSERT_EQ(line.size(), maxLineLength);
  EXPECT_EQ(codeOf(line), "unknown-query");
  line.insert(line.size() - 2, "a");
  EXPECT_EQ(codeOf(line), "too-large");
  EXPECT_TRUE(parsed(answerTo(line))["id"].is_null());
  line.pop_back();
  line += "\xFF";
  EXPECT_EQ(codeOf(line), "too-large");
}

TEST(Faults, BadJson_HasNoIdAndComesBeforeTheQuery) {
  for (const char *line : {R"({"id":1,"query":"no-such")", R"({"id":1,"id":1})", "[1]", R"({"id":1}})",
                           "{\"id\":1,\"query\":\"\xFF\"}", R"({"id":1,"query":NaN})",
                           R"({"id":1,"query":"plane","plane":{"coefficients":[1,2,Infinity,3]}})"}) {
    EXPECT_EQ(codeOf(line), "bad-json") << line;
    EXPECT_TRUE(parsed(answerTo(line))["id"].is_null()) << line;
  }
}

TEST(Faults, UnknownQuery_ComesBeforeItsOperands) {
  for (const char *query : {"null", "1", "[]", "\"\"", "\"Plane\"", "\"plane \"", "[\"plane\"]",
                            "\"plane\\u0000\"", "\"too-large\""})
    EXPECT_EQ(codeOf(R"({"plane":0,"query":)" + std::string(query) + "}"), "unknown-query") << query;
}

/// Whichever of the two operands comes first, and whichever stands first in the line.
TEST(Faults, OfTwoOperandsThatAreWrong_TheFirstOfTheTableIsGiven) {
  const std::vector<std::pair<std::string, std::string>> pairs{
      {"missing-operand", stillRay},
      {"missing-operand", flatPlane},
      {"missing-operand", badRay},
      {"bad-operand", badRay + "," + flatPlane},
      {"bad-operand", R"("plane":[],)" + stillRay},
      {"bad-operand", R"("plane":null,)" + stillRay},
      {"zero-vector", stillRay + "," + flatPlane},
      {"zero-vector", linePlane + "," + stillRay},
      {"zero-normal", flatPlane + "," + goodRay},
      {"collinear-points", goodRay + "," + linePlane}};
  for (const auto &[code, operands] : pairs)
    EXPECT_EQ(codeOf(question("ray-plane", operands)), code) << operands;
}

TEST(Faults, OfTwoPlanes_AZeroNormalComesBeforeCollinearPoints) {
  const std::string flat = R"({"point":[1,2,3],"normal":[0,0,0]})";
  const std::string collinear = R"({"points":[[1,1,1],[1,1,1],[2,3,4]]})";
  EXPECT_EQ(codeOf(question("plane-plane", R"("plane":)" + collinear + R"(,"plane2":)" + flat)),
            "zero-normal");
  EXPECT_EQ(codeOf(question("plane-plane", R"("plane":)" + flat + R"(,"plane2":)" + collinear)),
            "zero-normal");
  EXPECT_EQ(codeOf(question("plane-plane", R"("plane2":)" + collinear)), "missing-operand");
}

TEST(Faults, NumbersOfNoLine_ComeLast) {
  EXPECT_EQ(codeOf(question("line-plane", noLine + "," + flatPlane)), "zero-normal");
  EXPECT_EQ(codeOf(question("line-plane", noLine + "," + linePlane)), "collinear-points");
  EXPECT_EQ(codeOf(question("line-plane", noLine)), "missing-operand");
  EXPECT_EQ(codeOf(question("line-line", noLine + R"(,"line2":{"point":[0,0,0],"direction":[0,0,0]})")),
            "zero-vector");
  EXPECT_EQ(codeOf(question("line-line", stillLine + R"(,"line2":0)")), "bad-operand");
  EXPECT_TRUE(resultOf(question("line", noLine)).contains("relation"));
}

TEST(Faults, OfASolid_BentComesBeforeConvexAndConvexBeforeClosed) {
  const auto solid = [](const std::string &lastVertex, const std::string &faces) {
    return question("ray-solid", goodRay + R"(,"solid":{"vertices":[[0,0,0],[2,0,0],[2,2,0],[0,2,)" +
                                     lastVertex + R"(],[1,1,3]],"faces":)" + faces + "}");
  };
  const std::string pyramid = "[[3,2,1,0],[0,1,4],[1,2,4],[2,3,4],[3,0,4]]";
  const std::string open = "[[3,2,1,0],[0,1,4],[1,2,4],[2,3,4]]";
  const std::string openAndTurned = "[[3,2,1,0],[1,0,4],[1,2,4],[2,3,4]]";
  EXPECT_EQ(resultOf(solid("0", pyramid))["contacts"], "one");
  EXPECT_EQ(codeOf(solid("0", open)), "not-closed");
  EXPECT_EQ(codeOf(solid("0", openAndTurned)), "not-convex");
  EXPECT_EQ(codeOf(solid("1", openAndTurned)), "not-planar");
  EXPECT_EQ(codeOf(solid("0", "[[3,2,1,5],[0,1,4],[1,2,4],[2,3,4]]")), "bad-operand") << "no vertex 5";
  EXPECT_EQ(codeOf(solid("1", "[[3,2,1,0],[1,0,4]]")), "bad-operand") << "too few faces";
}

TEST(Faults, StillRayOrBentPolygon_IsNamedByTheTableAndNotByTheOrderOfTheKeys) {
  const std::string bent = R"("polygon":[[0,0,0],[1,0,0],[1,1,1],[0,1,0]])";
  EXPECT_EQ(codeOf(question("ray-polygon", bent + "," + stillRay)), "zero-vector");
  EXPECT_EQ(codeOf(question("ray-polygon", stillRay + "," + bent)), "zero-vector");
  EXPECT_EQ(codeOf(question("ray-polygon", stillRay + R"(,"polygon":[[0,0,0],[1,0,0]])")), "bad-operand");
  EXPECT_EQ(codeOf(question("ray-polygon", goodRay + R"(,"polygon":[[0,0,0],[1,1,1],[2,2,2],[3,3,3]])")),
            "not-convex");
}

TEST(Faults, DegenerateTriangle_SaysWhetherItsPointsCoincide) {
  const auto messageOf = [](const std::string &triangle) {
    const Json answer = parsed(answerTo(question("parametric", R"("s":0,"t":0,"triangle":)" + triangle)));
    return answer["error"].value("code", "") + ": " + answer["error"].value("message", "");
  };
  const std::string coincident = messageOf("[[1,2,3],[4,5,6],[1,2,3]]");
  const std::string collinear = messageOf("[[1,2,3],[2,4,6],[3,6,9]]");
  EXPECT_NE(coincident.find("degenerate-triangle: "), std::string::npos);
  EXPECT_NE(coincident.find("coincide"), std::string::npos) << coincident;
  EXPECT_NE(collinear.find("line"), std::string::npos) << collinear;
  EXPECT_EQ(collinear.find("coincide"), std::string::npos) << collinear;
}

TEST(Faults, OperandsOfOtherForms_AreBad) {
  const std::vector<std::pair<std::string, std::string>> operands{
      {"plane", R"("plane":{"point":[0,0,0],"normal":[0,0,1],"coefficients":[0,0,1,0]})"},
      {"plane", R"("plane":{"point":[0,0,0]})"},
      {"plane", R"("plane":{"point":[0,0,0],"normal":[0,0,1],"x":1})"},
      {"plane", R"("plane":{})"},
      {"plane", R"("plane":[0,0,1,0])"},
      {"plane", R"("plane":{"points":[[0,0,0],[1,0,0]]})"},
      {"plane", R"("plane":{"coefficients":[0,0,1]})"},
      {"plane", R"("plane":{"coefficients":{"0":1}})"},
      {"line", R"("line":{"plucker":{"direction":[1,0,0]}})"},
      {"line", R"("line":{"plucker":[1,0,0,0,0,0]})"},
      {"line", R"("line":{"through":[[0,0,0]]})"},
      {"project-vector", R"("vector":[1,2,3,4],"onto":[1,0,0])"},
      {"project-vector", R"("vector":[1,2,true],"onto":[1,0,0])"},
      {"project-vector", R"("vector":[1,2,[3]],"onto":[1,0,0])"},
      {"ray-sphere", goodRay + R"(,"sphere":{"center":[0,0,0],"radius":0})"},
      {"ray-sphere", goodRay + R"(,"sphere":{"center":[0,0,0],"radius":-1})"},
      {"ray-sphere", goodRay + R"(,"sphere":{"center":[0,0,0]})"},
      {"nearest-hit", goodRay + R"(,"triangles":[[0,0,0]])"},
      {"nearest-hit", goodRay + R"(,"triangles":{})"},
      {"parametric", R"("triangle":[[0,0,0],[1,0,0],[0,1,0]],"s":[0],"t":0)"}};
  for (const auto &[query, text] : operands)
    EXPECT_EQ(codeOf(question(query, text)), "bad-operand") << query << " " << text;
}

TEST(Faults, NumbersThatAreRefused_AreBadOperands) {
  const std::string most(200, '1');
  const auto codeWith = [](const std::string &number) {
    const Json answer =
        parsed(answerTo(question("point-plane", R"("point":[)" + number + ",0,0]," + goodPlane)));
    return answer["ok"] == true ? "" : answer["error"].value("code", "?");
  };
  for (const std::string &number : {std::string("0.1"), std::string("-1e400"), std::string("1E-400"), most,
                                    "\"" + most + "/-" + most + "\"", std::string("\"-0/-5\""),
                                    std::string(R"("1\/2")"), std::string(R"("\u0031")")})
    EXPECT_EQ(codeWith(number), "") << number;
  for (const std::string &number :
       {std::string("1e401"), std::string("0e-401"), "1" + most, most + ".0", "\"1/1" + most + "\"",
        std::string("\"0.5\""), std::string("\"NaN\""), std::string("\"inf\""), std::string("\"1/0\""),
        std::string("\"\""), std::string("\" 1\""), std::string("\"+1\""), std::string("\"1e2\""),
        std::string("\"1/\""), std::string("\"1/2/3\""), std::string("true"), std::string("null"),
        std::string("{}")})
    EXPECT_EQ(codeWith(number), "bad-operand") << number;
}

TEST(Faults, Indices_AreWholeNumbersOfVertices) {
  const auto codeWith = [](const std::string &index) {
    const Json answer = parsed(answerTo(
        question("ray-solid", goodRay + R"(,"solid":{"vertices":[[0,0,0],[3,0,0],[0,3,0],[0,0,3]],)" +
                                  R"("faces":[[0,2,1],[0,1,3],[1,2,3],[2,0,)" + index + "]]}")));
    return answer["ok"] == true ? "" : answer["error"].value("code", "?");
  };
  for (const char *index : {"3", "3.0", "0.3e1", "300e-2", "\"6/2\"", "\"3\""})
    EXPECT_EQ(codeWith(index), "") << index;
  for (const char *index : {"4", "-1", "2.5", "4294967299", "1e300", "null", "[3]", "\"x\"", "true"})
    EXPECT_EQ(codeWith(index), "bad-operand") << index;
}

TEST(Faults, AFault_LeavesNothingOfItsAnswerBehindAndHarmsNoNextLine) {
  Evaluator evaluator;
  std::string answers;
  EXPECT_FALSE(evaluator.answer(question("plane", flatPlane), answers));
  EXPECT_TRUE(evaluator.answer(question("plane", goodPlane), answers));
  EXPECT_FALSE(evaluator.answer("{", answers));
  EXPECT_EQ(std::count(answers.begin(), answers.end(), '\n'), 3);
  EXPECT_EQ(answers.find("result"), answers.rfind("result"));
}

} // namespace
} // namespace halfspace
