// Questions in a stream: order, outcome, and answers that do not wait for the end.
#include "tests/eval/answers.h"

#include <algorithm>
#include <sstream>

namespace halfspace {
namespace {

std::string numbered(int id, bool good = true) {
  return R"({"id":)" + std::to_string(id) + R"(,"query":"plane","plane":{"coefficients":[0,0,)" +
         (good ? "1" : "0") + ",0]}}";
}

std::vector<int> idsIn(const std::string &answers) {
  std::vector<int> ids;
  std::istringstream lines(answers);
  for (std::string line; std::getline(lines, line);)
    ids.push_back(parsed(line)["id"].get<int>());
  return ids;
}

StreamOutcome outcomeOf(const std::string &questions) {
  std::istringstream in(questions);
  std::ostringstream out;
  return evaluateLines(in, out);
}

TEST(EvaluateLines, ManyLines_AreAnsweredInTheirOrder) {
  constexpr int count = 3000;
  std::string questions;
  std::vector<int> expected;
  for (int id = 0; id < count; ++id) {
    questions += numbered(id, id % 7 != 0) + (id % 2 == 0 ? "\n" : "\r\n\n");
    expected.push_back(id);
  }
  std::istringstream in(questions);
  std::ostringstream out;
  EXPECT_EQ(evaluateLines(in, out), StreamOutcome::SomeFaults);
  EXPECT_EQ(idsIn(out.str()), expected);
}

TEST(EvaluateLines, Outcome_TellsWhetherAllWereAnswered) {
  EXPECT_EQ(outcomeOf(""), StreamOutcome::AllAnswered);
  EXPECT_EQ(outcomeOf("\n \n"), StreamOutcome::AllAnswered);
  EXPECT_EQ(outcomeOf("\r"), StreamOutcome::AllAnswered);
  EXPECT_EQ(outcomeOf(numbered(1)), StreamOutcome::AllAnswered);
  EXPECT_EQ(outcomeOf(numbered(1, false) + "\n" + numbered(2)), StreamOutcome::SomeFaults);
  EXPECT_EQ(outcomeOf("{"), StreamOutcome::SomeFaults);
}

/// Gives a line at a time, and looks at each whether those before are answered already.
class Conversation : public std::streambuf {
public:
  Conversation(int count, const std::ostringstream &answers) : m_count(count), m_answers(answers) {}
  [[nodiscard]] bool allCameAtOnce() const { return m_allCameAtOnce; }

private:
  int_type underflow() override {
    const std::string given = m_answers.str();
    m_allCameAtOnce = m_allCameAtOnce && std::count(given.begin(), given.end(), '\n') == m_next;
    if (m_next == m_count)
      return traits_type::eof();
    m_line = numbered(m_next++) + "\n";
    setg(m_line.data(), m_line.data(), m_line.data() + m_line.size());
    return traits_type::to_int_type(m_line.front());
  }

  int m_count;
  int m_next = 0;
  const std::ostringstream &m_answers;
  std::string m_line;
  bool m_allCameAtOnce = true;
};

TEST(EvaluateLines, BeforeTheNextLineIsWaitedFor_TheLastOneIsAnswered) {
  std::ostringstream out;
  Conversation source(20, out);
  std::istream in(&source);
  EXPECT_EQ(evaluateLines(in, out), StreamOutcome::AllAnswered);
  EXPECT_TRUE(source.allCameAtOnce());
  EXPECT_EQ(idsIn(out.str()).size(), 20U);
}

/// Takes so many bytes and then no more, as a full disk does.
class Full : public std::streambuf {
  std::streamsize xsputn(const char *, std::streamsize) override { return 0; }
  int_type overflow(int_type) override { return traits_type::eof(); }
};

TEST(EvaluateLines, AnswersThatCannotBeWritten_EndIt) {
  Full full;
  std::ostream out(&full);
  std::istringstream in(numbered(1));
  EXPECT_EQ(evaluateLines(in, out), StreamOutcome::CannotWrite);
}

/// Gives one line and then refuses, as a folder or a broken disk does.
class Breaking : public std::streambuf {
  int_type underflow() override {
    if (m_line.empty()) {
      m_line = numbered(1) + "\n";
      setg(m_line.data(), m_line.data(), m_line.data() + m_line.size());
      return traits_type::to_int_type(m_line.front());
    }
    throw std::ios_base::failure("refused");
  }
  std::string m_line;
};

TEST(EvaluateLines, SourceThatBreaks_HasItsFirstLinesAnsweredAndSaysSo) {
  Breaking source;
  std::istream in(&source);
  std::ostringstream out;
  EXPECT_EQ(evaluateLines(in, out), StreamOutcome::CannotRead);
  EXPECT_EQ(idsIn(out.str()), std::vector<int>{1});
}

} // namespace
} // namespace halfspace
