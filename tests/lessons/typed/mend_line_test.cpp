// What was perhaps meant by a line with a slip in it.
#include "lessons/typed/mend_line.h"
#include "lessons/typed/read_line.h"
#include "lessons/typed/write_line.h"

#include <gtest/gtest.h>

#include <cctype>
#include <random>

namespace halfspace {
namespace {

const std::vector<std::string> right{"A = (1, 2, 3)",
                                     "B = (4, -1/2, 6)",
                                     "C = point(0, 5, 1)",
                                     "E: x + 2y + 2z = 27",
                                     "F = plane(A, B, C)",
                                     "M = (A + B)/2",
                                     "r = A + t(-1, 3, 2)",
                                     "g = line(B, (1, 0, 2))",
                                     "T = triangle(A, B, C)",
                                     "S = sphere(A, 3)",
                                     "k = 3/2, 0 <= k <= 5, step 1/2",
                                     "d = distance(A, E)",
                                     "h = intersect(r, E)",
                                     "s = intersect(E, F)",
                                     "c = barycentric(T, M)",
                                     "p = distance(C, g)",
                                     "q = reflect(E, r)"};

bool isOfWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// Whether a name or a number is this character alone: without it nobody knows what was meant.
bool isWhole(const std::string &line, std::size_t at) {
  return isOfWord(line[at]) && !isOfWord(line[at - 1]) && !isOfWord(line[at + 1]);
}

/// A slip of the fingers: a character left out, doubled, exchanged with the next one, or a neighbour of it.
std::string slipped(std::string line, std::mt19937 &random) {
  std::size_t at = 0;
  do
    at = 1 + random() % (line.size() - 2);
  while (isWhole(line, at));
  switch (random() % 4) {
  case 0:
    return line.erase(at, 1);
  case 1:
    return line.insert(at, 1, line[at]);
  case 2:
    std::swap(line[at], line[at + 1]);
    return line;
  default:
    line[at] = static_cast<char>(line[at] ^ 1); // one beside it
    return line;
  }
}

TEST(MendLine, OfSlips_IsWhatWasMeant) {
  std::mt19937 random(3);
  Scene above;
  int wrong = 0;
  int mended = 0;
  std::string missed;
  for (int i = 0; wrong < 300; ++i) {
    if (i % static_cast<int>(right.size()) == 0)
      above = {};
    const std::string &line = right[static_cast<std::size_t>(i) % right.size()];
    const auto meant = readLine(line, above);
    ASSERT_TRUE(std::holds_alternative<Entry>(meant)) << line << std::get<TypedFault>(meant).sentence;
    const std::string slip = slipped(line, random);
    if (std::holds_alternative<TypedFault>(readLine(slip, above))) { // else it says something else
      ++wrong;
      const auto mends = mendsOf(slip, above);
      const bool isRight =
          !mends.empty() && std::get<Entry>(readLine(mends.front(), above)) == std::get<Entry>(meant);
      mended += isRight ? 1 : 0;
      if (!isRight)
        missed += line + " | " + slip + " | " + (mends.empty() ? "-" : mends.front()) + "\n";
    }
    above.entries.push_back(std::get<Entry>(meant));
  }
  EXPECT_GE(mended, wrong * 9 / 10) << missed;
}

TEST(MendLine, OfWhatIsRight_IsNothing) { EXPECT_TRUE(mendsOf("A = (1, 2, 3)", {}).empty()); }

TEST(Mends, OfNumbersInAnotherLanguage_AreTheSameNumbers) {
  EXPECT_EQ(mendsOf("P = (1,5; 2; 3)", Scene()).front(), "P = (1.5, 2, 3)");
  EXPECT_EQ(mendsOf("P = (1.5, 2, 3)", Scene(), ',').front(), "P = (1,5; 2; 3)");
}

TEST(Mends, OfWhatLacksItsEndOrItsBrackets_HaveThem) {
  EXPECT_EQ(mendsOf("F: x + 2y + 2z", Scene()).front(), "F: x + 2y + 2z = 0");
  EXPECT_EQ(mendsOf("P = 1, 2, 3", Scene()).front(), "P = (1, 2, 3)");
}

} // namespace
} // namespace halfspace
