// `halfspace eval` without the program around it: lines a second on a mix of all queries, and memory.
#include "eval/evaluate.h"
#include "tests/bench/stopwatch.h"

#include <sys/resource.h>

#include <array>
#include <cstdio>
#include <istream>
#include <ostream>
#include <random>

namespace halfspace::bench {
namespace {

constexpr double goal = 100'000; // lines a second on one core

enum class Numbers { Whole, HalfFractions };

/// Writes seeded questions with whole numbers, or with as many decimals and fractions among them.
class Questions {
public:
  explicit Questions(Numbers numbers) : m_numbers(numbers) {}

  std::string next() {
    const std::size_t which = m_count++ % forms.size();
    std::string line;
    for (const char c : std::string_view(forms[which]))
      line += c == 'V' ? vector() : c == 'N' ? number() : std::string(1, c);
    return line;
  }

private:
  /// V stands for a vector, N for a number that is not zero.
  static constexpr std::array forms{
      R"({"query":"plane","plane":{"point":V,"normal":V}})",
      R"({"query":"point-plane","point":V,"plane":{"point":V,"normal":V}})",
      R"({"query":"project-vector","vector":V,"onto":V})",
      R"({"query":"ray-plane","ray":{"origin":V,"direction":V},"plane":{"points":[V,V,V]}})",
      R"({"query":"ray-triangle","ray":{"origin":V,"direction":V},"triangle":[V,V,V]})",
      R"({"query":"ray-sphere","ray":{"origin":V,"direction":V},"sphere":{"center":V,"radius":20}})",
      R"({"query":"ray-polygon","ray":{"origin":V,"direction":V},"polygon":[[0,0,0],[4,0,0],[5,3,0],[2,6,0],[-1,3,0]]})",
      R"({"query":"ray-solid","ray":{"origin":V,"direction":V},"solid":{"vertices":[[0,0,0],[3,0,0],[0,3,0],[0,0,3]],"faces":[[1,2,3],[0,3,2],[0,1,3],[0,2,1]]}})",
      R"({"query":"plane-plane","plane":{"point":V,"normal":V},"plane2":{"coefficients":[N,N,N,N]}})",
      R"({"query":"line","line":{"point":V,"direction":V}})",
      R"({"query":"line-line","line":{"point":V,"direction":V},"line2":{"through":[V,V]}})",
      R"({"query":"line-plane","line":{"point":V,"direction":V},"plane":{"point":V,"normal":V}})",
      R"({"query":"parametric","triangle":[V,V,V],"s":N,"t":N})",
      R"({"query":"nearest-hit","ray":{"origin":V,"direction":V},"triangles":[[V,V,V],[V,V,V],[V,V,V]]})"};

  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }

  std::string number() {
    const std::string sign = integer(0, 1) == 0 ? "-" : "";
    const std::string whole = std::to_string(integer(1, 20));
    if (m_numbers == Numbers::Whole)
      return sign + whole;
    switch (integer(0, 3)) {
    case 0:
      return sign + whole + "." + std::to_string(integer(1, 99));
    case 1:
      return "\"" + sign + whole + "/" + std::to_string(integer(1, 12)) + "\"";
    default:
      return sign + whole;
    }
  }
  std::string vector() { return "[" + number() + "," + number() + "," + number() + "]"; }

  Numbers m_numbers;
  std::mt19937_64 m_engine{5};
  std::size_t m_count = 0;
};

/// The most memory that this process ever had, in MiB.
double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// Hands out questions without end to hold: `count` lines, made as they are read.
class QuestionBuffer : public std::streambuf {
public:
  explicit QuestionBuffer(std::size_t count) : m_left(count) {}

protected:
  int_type underflow() override {
    if (m_left == 0)
      return traits_type::eof();
    m_text.clear();
    for (int i = 0; i < 100 && m_left > 0; ++i, --m_left)
      m_text += m_questions.next() + "\n";
    setg(m_text.data(), m_text.data(), m_text.data() + m_text.size());
    return traits_type::to_int_type(*gptr());
  }

private:
  Questions m_questions{Numbers::HalfFractions};
  std::size_t m_left;
  std::string m_text;
};

class NullBuffer : public std::streambuf {
protected:
  int_type overflow(int_type c) override { return traits_type::not_eof(c); }
  std::streamsize xsputn(const char *, std::streamsize count) override { return count; }
};

Contender answering(const char *name, Numbers numbers) {
  std::vector<std::string> lines;
  Questions questions(numbers);
  for (int i = 0; i < 14'000; ++i)
    lines.push_back(questions.next());
  return {name, lines.size(), [lines = std::move(lines)] {
            Evaluator evaluator;
            std::string answers;
            for (const std::string &line : lines)
              if (!evaluator.answer(line, answers))
                std::printf("refused: %s\n", line.c_str());
            return double(answers.size());
          }};
}

/// Before anything else is held: the peak never falls again.
void printMemory() {
  std::printf("\nhalfspace eval, memory\n");
  for (const std::size_t count : {1'000UL, 10'000UL, 100'000UL, 1'000'000UL}) {
    QuestionBuffer buffer(count);
    NullBuffer nothing;
    std::istream in(&buffer);
    std::ostream out(&nothing);
    const auto outcome = evaluateLines(in, out);
    std::printf("  %8zu lines: %6.1f MiB at most%s\n", count, peakMemory(),
                outcome == StreamOutcome::AllAnswered ? "" : ", not all answered");
  }
}

void run() {
  printMemory();
  std::vector<Contender> contenders{
      answering("a line of all queries in turns, whole numbers", Numbers::Whole),
      answering("the same, half of them fractions", Numbers::HalfFractions)};
  race(contenders, 9);
  print("halfspace eval", contenders);
  for (const Contender &each : contenders)
    printGoal(std::to_string(static_cast<long>(1e9 / each.nanoseconds)) + " lines a second; wanted / reached",
              goal * each.nanoseconds / 1e9, 1.0);
}

} // namespace
} // namespace halfspace::bench

int main() { halfspace::bench::run(); }
