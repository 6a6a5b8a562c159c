// What every answer has: the id as it came, the query, and figures as doubles and exactly.
#include "tests/eval/answers.h"

#include <cmath>
#include <limits>

namespace halfspace {
namespace {

const std::string groundPlane = R"("plane":{"coefficients":[0,0,1,0]})";

TEST(Answer, IdOfAnyKind_IsGivenBackAsItIsSpelled) {
  for (const char *id : {"0", "-0", "1.50", "1E400", "123456789012345678901234567890", "0.1e-0", "true",
                         "false", "null", "\"\"", R"("a\u0062\/\n\ud83d\ude00")", "\"é\"", "[]", "{}",
                         "[1, 2.0 ,{\"a\" : [null]}]", R"({"id":{"query":"x"},"ok":false})"}) {
    const std::string spelled = id;
    const std::string good = answerTo(R"({"query":"plane","id": )" + spelled + " ," + groundPlane + "}");
    EXPECT_TRUE(good.starts_with("{\"id\":" + spelled + ",\"ok\":true,\"query\":\"plane\",\"result\":{"))
        << good;
    const std::string bad = answerTo(R"({"id":)" + spelled + R"(,"query":"no-such"})");
    EXPECT_TRUE(bad.starts_with("{\"id\":" + spelled + ",\"ok\":false,\"error\":{\"code\":")) << bad;
  }
}

TEST(Answer, WithoutAnId_HasNull) {
  EXPECT_TRUE(answerTo(R"({"query":"plane",)" + groundPlane + "}").starts_with(R"({"id":null,"ok":true)"));
  EXPECT_TRUE(answerTo("{}").starts_with(R"({"id":null,"ok":false)"));
}

TEST(Answer, KeysAndQueryWithEscapes_AreTheSameAsWithout) {
  const std::string plain = answerTo(R"({"id":1,"query":"plane",)" + groundPlane + "}");
  EXPECT_EQ(
      answerTo(R"({"\u0069d":1,"qu\u0065ry":"p\u006cane","\u0070lane":{"coe\u0066ficients":[0,0,1,0]}})"),
      plain);
}

TEST(Answer, KeysThatTheQueryDoesNotUse_AreIgnored) {
  const std::string plain = answerTo(R"({"id":1,"query":"plane",)" + groundPlane + "}");
  EXPECT_EQ(answerTo(R"({"x":[{"ray":0}],"ray":"nonsense","id":1,"query":"plane","plane2":null,)" +
                     groundPlane + "}"),
            plain);
}

TEST(Answer, Whitespace_ChangesNothing) {
  const std::string plain = answerTo(R"({"id":1,"query":"plane",)" + groundPlane + "}");
  EXPECT_EQ(
      answerTo("\t{ \"id\" : 1\t,\r\"query\":\"plane\" , \"plane\":{ \"coefficients\" :[ 0 ,0, 1,0 ] } } "),
      plain);
}

/// The plane through the origin's multiple: its coefficients come back as figures.
Json coefficients(const std::string &numbers) {
  return resultOf(R"({"query":"plane","plane":{"coefficients":[)" + numbers + "]}}")["coefficients"];
}

TEST(Figure, AnyNumber_IsTheNearestDoubleAndTheFractionInLowestTerms) {
  const Json figure = coefficients(R"(0.1,"-20/6",1e-3,12345678901234567890)");
  EXPECT_EQ(figure["exact"], Json::parse(R"(["1/10","-10/3","1/1000","12345678901234567890"])"));
  EXPECT_EQ(figure["value"].get<std::vector<double>>(),
            (std::vector<double>{0.1, -10.0 / 3, 0.001, 12345678901234567890.0}));
  EXPECT_EQ(figure.size(), 2U);
}

TEST(Figure, BeyondTheRangeOfDoubles_IsNullWithItsExactText) {
  const Json figure = coefficients("1e308,1e309,-1e400,1e-400");
  EXPECT_DOUBLE_EQ(figure["value"][0].get<double>(), 1e308);
  EXPECT_TRUE(figure["value"][1].is_null());
  EXPECT_TRUE(figure["value"][2].is_null());
  EXPECT_EQ(figure["value"][3].get<double>(), 0);
  EXPECT_EQ(figure["exact"][1], "1" + std::string(309, '0'));
  EXPECT_EQ(figure["exact"][3], "1/1" + std::string(400, '0'));
}

TEST(Figure, AroundTheLargestAndSmallestDouble_IsRoundedAsDoublesAre) {
  const Json figure = coefficients("1.7976931348623157e308,1.7976931348623159e308,5e-324,2e-324");
  EXPECT_EQ(figure["value"][0].get<double>(), std::numeric_limits<double>::max());
  EXPECT_TRUE(figure["value"][1].is_null());
  EXPECT_EQ(figure["value"][2].get<double>(), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(figure["value"][3].get<double>(), 0);
}

std::string lengthOf(const std::string &vector) {
  return resultOf(R"({"query":"project-vector","vector":)" + vector + R"(,"onto":)" + vector + "}")["scalar"]
      .dump();
}

TEST(Figure, RootWithinTheLimit_IsWrittenOutAndBeyondItOnlyItsDoubleIs) {
  EXPECT_EQ(lengthOf("[1,1,1]"), R"~({"value":1.7320508075688772,"exact":"sqrt(3)"})~");
  EXPECT_EQ(lengthOf("[1,1,0]"), R"~({"value":1.4142135623730951,"exact":"sqrt(2)"})~");
  EXPECT_EQ(lengthOf("[3,4,0]"), R"({"value":5,"exact":"5"})");
  // 10^18 is within; 10^18 + 1 is not, nor are 2·10^20 and 1/(5·10^19), though they have only small factors.
  EXPECT_EQ(lengthOf("[1000000000,0,0]"), R"({"value":1000000000.0,"exact":"1000000000"})");
  EXPECT_EQ(lengthOf("[1000000000,1,0]"), R"({"value":1000000000.0,"exact":null})");
  EXPECT_EQ(lengthOf("[1e10,1e10,0]"), R"({"value":14142135623.730951,"exact":null})");
  EXPECT_EQ(lengthOf("[1e-10,1e-10,0]"), R"({"value":1.414213562373095e-10,"exact":null})");
}

TEST(Figure, EntriesOfAList_AreJudgedEachByItself) {
  const Json figure = resultOf(R"({"query":"plane","plane":{"coefficients":[1,1,0,1e10]}})")["normalized"];
  EXPECT_EQ(figure["exact"], Json::parse(R"~(["1/2*sqrt(2)","1/2*sqrt(2)","0",null])~"));
  EXPECT_DOUBLE_EQ(figure["value"][3].get<double>(), 1e10 / std::sqrt(2.0));
}

TEST(Figure, SumOfAFractionAndARoot_IsWrittenWithItsSign) {
  const Json result = resultOf(R"({"query":"ray-sphere","ray":{"origin":[-3,1,0],"direction":[2,0,0]},)"
                               R"("sphere":{"center":[0,0,0],"radius":2}})");
  EXPECT_EQ(result["t"]["exact"], Json::parse(R"~(["3/2 - 1/2*sqrt(3)","3/2 + 1/2*sqrt(3)"])~"));
  EXPECT_EQ(result["points"][0]["exact"], Json::parse(R"~(["-sqrt(3)","1","0"])~"));
}

TEST(Figure, RootsThatCancel_KeepTheirDigits) {
  // t is √(R² − 1) − 10^8 with R = 10^8 + 1, which is 1 − 5·10^-9 + 5·10^-17 and so on.
  const Json result =
      resultOf(R"({"query":"ray-sphere","ray":{"origin":[100000000,100000000,0],"direction":[1,0,0]},)"
               R"("sphere":{"center":[0,100000000,1],"radius":"100000001"}})");
  const double t = 0.99999999500000005;
  EXPECT_LE(std::abs(result["t"]["value"][1].get<double>() - t), std::nextafter(t, 1) - t);
}

} // namespace
} // namespace halfspace
