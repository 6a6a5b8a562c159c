// Long lines of long numbers are answered in a time that somebody waits for.
#include "geometry/rational.h"
#include "tests/eval/answers.h"

#include <array>
#include <ctime>
#include <numeric>
#include <random>

namespace halfspace {
namespace {

/// Fractions of so many digits very near to whole numbers, no two with the same denominator.
class LongNumbers {
public:
  std::string near(int whole) {
    constexpr int digits = 190; // and up to seven more of the whole number are fewer than 200
    std::string denominator = "1";
    for (int i = 0; i < digits; ++i)
      denominator += static_cast<char>('0' + std::uniform_int_distribution<int>(0, 9)(m_engine));
    const Rational numerator = *parseRational(denominator) * whole + 1;
    return "\"" + toText(numerator) + "/" + denominator + "\"";
  }

private:
  std::mt19937_64 m_engine{8};
};

std::string faceOf(const std::vector<int> &corners) {
  std::string text;
  for (const int corner : corners)
    text += (text.empty() ? '[' : ',') + std::to_string(corner);
  return text + "]";
}

/// A ray down into an upright prism over so many corners near a parabola.
std::string rayAndPrism(int sides, LongNumbers &numbers) {
  std::array<std::string, 2> rings;
  const std::array heights{numbers.near(0), numbers.near(1)};
  for (int x = 0; x < sides; ++x) {
    const std::string corner = (x == 0 ? "[" : ",[") + numbers.near(x) + "," + numbers.near(x * x) + ",";
    for (std::size_t i = 0; i < 2; ++i)
      rings[i] += corner + heights[i] + "]";
  }
  std::vector<int> bottom(static_cast<std::size_t>(sides));
  std::iota(bottom.rbegin(), bottom.rend(), 0);
  std::vector<int> top(static_cast<std::size_t>(sides));
  std::iota(top.begin(), top.end(), sides);
  std::string walls;
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    walls += "," + faceOf({i, next, sides + next, sides + i});
  }
  return R"({"query":"ray-solid","ray":{"origin":[1,2,9],"direction":[0,0,-1]},"solid":{"vertices":[)" +
         rings[0] + "," + rings[1] + R"(],"faces":[)" + faceOf(bottom) + "," + faceOf(top) + walls + "]}}";
}

TEST(LongNumbers, PrismOfManySides_IsAnsweredInSecondsAndNotInMinutes) {
  LongNumbers numbers;
  const std::string line = rayAndPrism(2400, numbers);
  const std::clock_t start = std::clock();
  const Json result = resultOf(line);
  const auto seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_EQ(result["case"], "hit");
  EXPECT_EQ(result["faces"], Json::parse("[1,0]"));
  // It takes one or two. When every vertex was held against every face, in fractions, it took forty.
  EXPECT_LT(seconds, 20.0);
}

} // namespace
} // namespace halfspace
