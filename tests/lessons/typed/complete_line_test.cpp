// Lines that are completed while somebody types them.
#include "lessons/construction/construction.h"
#include "lessons/text.h"
#include "lessons/typed/call_words.h"
#include "lessons/typed/complete_line.h"
#include "lessons/typed/read_line.h"
#include "lessons/typed/typed_scene.h"
#include "lessons/typed/write_line.h"
#include "tests/effort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace halfspace {
namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t all = 1000;

constexpr const char *typedScene = "A = (1, 2, 3)\n"
                                   "B = (4, -1/2, 6)\n"
                                   "C = (0, 5, 1)\n"
                                   "D = (1, 1, 7)\n"
                                   "P = (2, 0, 1)\n"
                                   "E: x + 2y + 2z = 27\n"
                                   "G = plane(A, B, C)\n"
                                   "g = line(A, B)\n"
                                   "h = line(C, D)\n"
                                   "r = A + t(-1, 3, 2)\n"
                                   "u = (1, 0, 2)\n"
                                   "v = (1, 2, 3)\n"
                                   "w = B - A\n"
                                   "k = 3/2\n"
                                   "frame = 2\n"
                                   "T = triangle(A, B, C)\n"
                                   "W = polygon(A, B, C)\n"
                                   "S = sphere(A, 3)\n"
                                   "K = box(A, 3, 2, 1)\n"
                                   "U = ufo(A, u, v, 2)\n"
                                   "I = screen(A, u, v, 3, 4)\n"
                                   "d = distance(A, E)\n";

const Scene &playground() {
  static const Scene scene = *readTypedScene(typedScene, "");
  return scene;
}

Lines completed(const std::string &line, const Scene &scene = playground(), std::size_t most = all) {
  Lines lines;
  for (const LineCompletion &each : completionsOf(line, line.size(), scene, '.', most))
    lines.push_back(each.line);
  return lines;
}

/// The first completion, or the empty line.
std::string first(const std::string &line, const Scene &scene = playground()) {
  const Lines lines = completed(line, scene);
  return lines.empty() ? "" : lines.front();
}

bool has(const Lines &lines, const std::string &line) {
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

/// The bytes that are selected, between brackets.
std::string withSelection(const LineCompletion &completion) {
  std::string line = completion.line;
  line.insert(completion.selectedAt + completion.selectedLength, "]");
  return line.insert(completion.selectedAt, "[");
}

TEST(CompleteLine, WithNothingInIt_OffersStatementsToBeChanged) {
  const Lines lines = completed("", Scene());
  EXPECT_EQ(first("", Scene()), "A = (1, 2, 3)");
  EXPECT_TRUE(has(lines, "E: x + 2y + 2z = 27"));
  EXPECT_TRUE(has(lines, "g = line((0, 0, 0), (1, 2, 2))"));
  EXPECT_TRUE(has(lines, "u = (1, 2, 3)"));
  EXPECT_TRUE(has(lines, "k = 1"));
  EXPECT_FALSE(has(lines, "d = distance(E, A)")) << "there is nothing to look at";
  EXPECT_TRUE(has(completed(""), "d1 = distance(G, P)"));
}

TEST(CompleteLine, WithTheBeginningOfAWord_CallsItWithTheNewestThatFit) {
  EXPECT_EQ(first("dist"), "d1 = distance(G, P)");
  EXPECT_EQ(first("Tri"), "T1 = triangle(C, D, P)");
  EXPECT_EQ(first("e = dist"), "e = distance(G, P)");
  EXPECT_EQ(first("e = signed"), "e = signed-distance(G, P)");
  EXPECT_EQ(first("e = plane"), "e = plane(P, w)");
  EXPECT_EQ(first("e = cross"), "e = cross(v, w)");
  EXPECT_EQ(first("e = point-on-l"), "e = point-on-line(h, 1/4)");
}

TEST(CompleteLine, OfAName_OffersWhatUsuallyHasIt) {
  EXPECT_EQ(first("F = "), "F = x + 2y + 2z = 27");
  EXPECT_EQ(first("F"), "F: x + 2y + 2z = 27");
  EXPECT_EQ(first("Q = "), "Q = (1, 2, 3)");
  EXPECT_EQ(first("Q ="), "Q = (1, 2, 3)");
  EXPECT_EQ(first("T2 = "), "T2 = triangle(C, D, P)");
  EXPECT_EQ(first("m = "), "m = 1");
  EXPECT_EQ(first("u2 = "), "u2 = (1, 2, 3)");
  EXPECT_EQ(first("S2 = "), "S2 = sphere(P, frame)");
  EXPECT_TRUE(completed("A = ").empty()) << "that is taken";
}

TEST(CompleteLine, BetweenBrackets_OffersTheNamesThatFit) {
  EXPECT_EQ(completed("e = distance("),
            (Lines{"e = distance(G, P)", "e = distance(E, P)",   "e = distance(P, G)", "e = distance(D, G)",
                   "e = distance(C, G)", "e = distance(B, G)",   "e = distance(A, G)", "e = distance(d.F, G)",
                   "e = distance(D, P)", "e = distance(P, D)",   "e = distance(C, P)", "e = distance(B, P)",
                   "e = distance(A, P)", "e = distance(d.F, P)", "e = distance(P, h)", "e = distance(D, h)",
                   "e = distance(C, h)", "e = distance(B, h)",   "e = distance(A, h)", "e = distance(d.F, h)",
                   "e = distance(h, P)", "e = distance(g, P)",   "e = distance(g, h)", "e = distance(h, g)",
                   "e = distance(E, G)", "e = distance(G, E)"}));
  EXPECT_EQ(completed("e = distance(E, ").size(), 7U) << "six points and a plane";
  EXPECT_EQ(first("e = distance(E,"), "e = distance(E, P)");
  EXPECT_EQ(completed("e = distance(E, D"), Lines{"e = distance(E, D)"});
  EXPECT_EQ(completed("e = distance(E, v"), Lines());
  EXPECT_EQ(completed("e = distance(v, "), Lines());
  EXPECT_EQ(completed("e = triangle((1, 2, 3), B, D"), Lines{"e = triangle((1, 2, 3), B, D)"});
  EXPECT_EQ(completed("e = point-on-line(g"), Lines{"e = point-on-line(g, 1/4)"});
}

TEST(CompleteLine, OfAList_OffersMoreForIt) {
  const Lines lines = completed("e = ray-plane-substitution(G, ");
  EXPECT_EQ(first("e = ray-plane-substitution(G, "), "e = ray-plane-substitution(G, r)");
  EXPECT_TRUE(has(lines, "e = ray-plane-substitution(G, E, r)"));
}

TEST(CompleteLine, InAFormula_OffersItsNames) {
  EXPECT_EQ(completed("M = (A + "),
            (Lines{"M = (A + frame", "M = (A + k", "M = (A + w", "M = (A + v", "M = (A + u", "M = (A + P",
                   "M = (A + D", "M = (A + C", "M = (A + B", "M = (A + A", "M = (A + d.F"}));
  EXPECT_EQ(completed("M = (A + d"), Lines{"M = (A + d.F"});
  EXPECT_EQ(completed("q = 2fr"), Lines{"q = 2frame"});
  EXPECT_EQ(completed("q = B-d"), Lines{"q = B-d.F"});
  EXPECT_EQ(completed("M = (A"), Lines()) << "it is there already";
  EXPECT_EQ(completed("M = (A + B)"), Lines());
}

TEST(CompleteLine, WithMoreBehindTheCursor_KeepsIt) {
  const std::string line = "e = distance(E, ) + 1";
  const auto completions = completionsOf(line, line.find(')'), playground(), '.', all);
  ASSERT_EQ(completions.size(), 7U);
  EXPECT_EQ(withSelection(completions.front()), "e = distance(E, P[]) + 1");
  EXPECT_FALSE(completions.front().isWhole);
  const std::string whole = "e = distance(E, A)";
  for (const LineCompletion &each : completionsOf(whole, whole.size() - 2, playground(), '.', all))
    EXPECT_EQ(each.line.substr(each.line.size() - 2), "A)") << each.line;
  EXPECT_TRUE(completionsOf("di = 1", 2, playground(), '.', all).empty());
}

TEST(CompleteLine, WithWhatNobodyAskedFor_HasItSelected) {
  const auto selection = [](const std::string &line) {
    const auto completions = completionsOf(line, line.size(), playground());
    return completions.empty() ? "" : withSelection(completions.front());
  };
  EXPECT_EQ(selection("dist"), "d1 = distance([G, P])");
  EXPECT_EQ(selection("Q = "), "Q = [(1, 2, 3)]");
  EXPECT_EQ(selection("e = triangle(A"), "e = triangle(A, [D, P])");
  EXPECT_EQ(selection("e = distance(E, D"), "e = distance(E, D)[]");
}

TEST(CompleteLine, WithADecimalComma_SeparatesWithSemicolons) {
  const auto withComma = [](const std::string &line) {
    const auto completions = completionsOf(line, line.size(), playground(), ',');
    return completions.empty() ? "" : completions.front().line;
  };
  EXPECT_EQ(withComma("Q = "), "Q = (1; 2; 3)");
  EXPECT_EQ(withComma("e = distance(E"), "e = distance(E; P)");
  EXPECT_EQ(withComma("e = triangle((1,5; 2; 3); A"), "e = triangle((1,5; 2; 3); A; P)");
  EXPECT_EQ(withComma("e = distance(E; P"), "e = distance(E; P)");
}

TEST(CompleteLine, AtMostSoMany_IsCutOff) {
  EXPECT_EQ(completed("", playground(), 3).size(), 3U);
  EXPECT_EQ(completionsOf("", 0, playground()).size(), 12U);
}

TEST(CompleteLine, OfEveryWord_IsAWholeStatementWhereTheSceneHasWhatItTakes) {
  const Lines without{"mesh", "nearest-hit", "torpedo-flight"};
  for (const std::string &word : callWords()) {
    if (has(without, word))
      continue;
    const auto completions = completionsOf(word, word.size(), playground(), '.', all);
    ASSERT_FALSE(completions.empty()) << word;
    EXPECT_TRUE(completions.front().isWhole) << word;
  }
}

TEST(CompleteLine, OfAUseOfAnyConstruction_CutInItsLastName_BringsItBack) {
  int cuts = 0;
  for (const std::string &word : callWords())
    for (const LineCompletion &use :
         completionsOf("e = " + word + "(", 5 + word.size(), playground(), '.', 20)) {
      if (!use.isWhole || use.line.rfind('(') != use.line.find('(') || !isLetter(use.line.end()[-2]))
        continue;
      const std::string cut = use.line.substr(0, use.line.find_last_of(" (") + 2);
      EXPECT_TRUE(has(completed(cut), use.line)) << cut << " → " << use.line;
      ++cuts;
    }
  EXPECT_GT(cuts, 200);
}

TEST(CompleteLine, OfAnyBeginning_IsReadWhereItSaysSo) {
  std::mt19937 random(5);
  const Lines beginnings{"",      "e",          "e = ",  "e = dist",   "e = distance(", "e = triangle(A, ",
                         "M = (", "e = plane(", "E2: x", "e = A + t(", "e = line(A",    "e = intersect("};
  int whole = 0;
  for (int i = 0; i < test::effort(400); ++i) {
    const std::string line = beginnings[random() % beginnings.size()] + "ABEGghrvkTd.("[random() % 13];
    Scene scene;
    const std::size_t size = random() % playground().entries.size();
    for (std::size_t place = 0; place < size; ++place)
      scene.entries.push_back(playground().entries.shared(place));
    for (const LineCompletion &each : completionsOf(line, line.size(), scene)) {
      const auto read = readLine(each.line, scene);
      EXPECT_EQ(std::holds_alternative<Entry>(read), each.isWhole) << each.line;
      EXPECT_LE(each.selectedAt + each.selectedLength, each.line.size());
      EXPECT_FALSE(each.description.empty()) << each.line;
      whole += each.isWhole ? 1 : 0;
    }
  }
  EXPECT_GT(whole, test::atLeast(100));
}

TEST(CompleteLine, WithACursorAnywhere_KeepsWhatIsBehindIt) {
  std::mt19937 random(11);
  const Lines lines{"e = distance(E, A)",          "M = (A + B)/2 · u",
                    "e = plane(A, B, C), green",   "E2: x + 2y = z",
                    "q = k, 0 <= q <= 5, step 1",  "((;,)(",
                    "e = triangle((1,5; 2; 3), A", "ä = (ö, €"};
  for (int i = 0; i < test::effort(1500); ++i) {
    std::string line = lines[random() % lines.size()];
    for (std::size_t slips = random() % 3; slips > 0; --slips)
      line[random() % line.size()] = static_cast<char>(random() % 256);
    const std::size_t cursor = random() % (line.size() + 2);
    const std::string behind = line.substr(std::min(cursor, line.size()));
    for (const char mark : {'.', ','})
      for (const LineCompletion &each : completionsOf(line, cursor, playground(), mark, 4)) {
        EXPECT_TRUE(trimmed(behind).empty() || each.line.ends_with(behind)) << each.line;
        EXPECT_NE(each.line, line);
        EXPECT_EQ(std::holds_alternative<Entry>(readLine(each.line, playground(), mark)), each.isWhole);
        EXPECT_LE(each.selectedAt + each.selectedLength, each.line.size());
      }
  }
}

} // namespace
} // namespace halfspace
