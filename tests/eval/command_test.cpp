// `halfspace eval` as a shell meets it: exit statuses, and nothing but answers on standard output.
#include "tests/effort.h"
#include "tests/program_test.h"

#include <algorithm>
#include <array>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace halfspace {
namespace {

const std::string good = R"({"id":1,"query":"plane","plane":{"coefficients":[0,0,1,0]}})";
const std::string bad = R"({"id":2,"query":"no-such"})";

class EvalCommand : public ProgramTest {
protected:
  /// What follows `halfspace eval`, as a shell reads it, without a display.
  Ran run(const std::string &arguments) const {
    return shell("{ env -u DISPLAY -u WAYLAND_DISPLAY HOME=. '" HALFSPACE_PROGRAM "' eval " + arguments +
                 "; } >.out 2>.err");
  }

  void expectRefused(const std::string &arguments) const {
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.status, 2) << arguments;
    EXPECT_EQ(ran.out, "") << arguments;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_TRUE(ran.err.starts_with("halfspace: ")) << ran.err;
  }
};

TEST_F(EvalCommand, AllAnswered_IsStatusZeroFromAFileAndFromStandardInput) {
  write("cases.jsonl", good + "\n\n" + good);
  const Ran fromFile = run("cases.jsonl");
  EXPECT_EQ(fromFile.status, 0);
  EXPECT_EQ(fromFile.err, "");
  EXPECT_EQ(std::count(fromFile.out.begin(), fromFile.out.end(), '\n'), 2);
  EXPECT_EQ(run("<cases.jsonl").out, fromFile.out);
  EXPECT_EQ(run("- <cases.jsonl").out, fromFile.out);
  EXPECT_EQ(run("<cases.jsonl").status, 0);
}

TEST_F(EvalCommand, NoLines_AreStatusZeroAndNoAnswers) {
  const Ran ran = run("</dev/null");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(ran.out + ran.err, "");
}

TEST_F(EvalCommand, OneFault_IsStatusOneAndAllLinesAreAnswered) {
  write("cases.jsonl", bad + "\n" + good + "\n");
  const Ran ran = run("cases.jsonl");
  EXPECT_EQ(ran.status, 1);
  EXPECT_EQ(ran.err, "");
  EXPECT_TRUE(ran.out.starts_with(R"({"id":2,"ok":false)")) << ran.out;
  EXPECT_NE(ran.out.find("\n{\"id\":1,\"ok\":true"), std::string::npos) << ran.out;
}

TEST_F(EvalCommand, WhatCannotBeRead_IsStatusTwoWithOneSentence) {
  expectRefused("missing.jsonl");
  expectRefused("/");
  expectRefused("</");
  expectRefused("cases.jsonl more.jsonl");
}

TEST_F(EvalCommand, WhereNothingCanBeWritten_IsStatusTwoWithOneSentence) {
  write("cases.jsonl", good);
  expectRefused("cases.jsonl >/dev/full");
  expectRefused("cases.jsonl >&-");
}

TEST_F(EvalCommand, AnswersBeforeTheInputEnds_AreWritten) {
  write("one.jsonl", good);
  ASSERT_EQ(mkfifo(inFolder("pipe").c_str(), S_IRUSR | S_IWUSR), 0);
  // The input ends only once the first answer is there.
  const Ran ran = run(R"(<pipe >answers & exec 3>pipe; cat one.jsonl >&3; echo >&3; tries=0
    until grep -q '"ok":true' answers || [ $tries = 100 ]; do sleep 0.1; tries=$((tries + 1)); done
    wc -l <answers; exec 3>&-; wait $!; echo $?)");
  EXPECT_EQ(ran.out, "1\n0\n") << ran.err;
}

/// A pipe between the test and the program.
struct Pipe {
  Pipe() { EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0); }
  ~Pipe() {
    closeOutput();
    close(ends[0]);
  }
  Pipe(const Pipe &) = delete;
  Pipe &operator=(const Pipe &) = delete;

  [[nodiscard]] int input() const { return ends[0]; }
  [[nodiscard]] int output() const { return ends[1]; }
  void closeOutput() {
    if (ends[1] >= 0)
      close(std::exchange(ends[1], -1));
  }

  std::array<int, 2> ends{-1, -1};
};

void makeNonBlocking(int descriptor) { EXPECT_EQ(fcntl(descriptor, F_SETFL, O_NONBLOCK), 0); }

/// Starts `halfspace eval` on these descriptors.
pid_t startEval(int input, int output) {
  const pid_t child = fork();
  if (child != 0)
    return child;
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  execl(HALFSPACE_PROGRAM, "halfspace", "eval", nullptr);
  _exit(127);
}

int statusOf(pid_t child) {
  int ended = 0;
  waitpid(child, &ended, 0);
  return WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
}

/// What there is to read up to a line's end.
std::string readLine(int descriptor) {
  std::string line;
  for (char c = 0; c != '\n' && read(descriptor, &c, 1) == 1;)
    line += c;
  return line;
}

TEST_F(EvalCommand, IntoAPipeThatDoesNotWait_LosesNoAnswer) {
  std::string questions;
  for (int i = 0; i < test::effort(4000); ++i)
    questions += good + "\n";
  write("cases.jsonl", questions);
  const std::string expected = run("<cases.jsonl").out;
  Pipe answers;
  makeNonBlocking(answers.output());
  const int input = open(inFolder("cases.jsonl").c_str(), O_RDONLY | O_CLOEXEC);
  const pid_t child = startEval(input, answers.output());
  const int size = fcntl(answers.output(), F_GETPIPE_SZ);
  ASSERT_GT(expected.size(), 2 * static_cast<std::size_t>(size));
  answers.closeOutput();
  close(input);
  // Nothing is read before the pipe is as good as full.
  for (int waiting = 0, tries = 0; waiting < size - 4096 && tries < 2000; ++tries) {
    usleep(5000);
    ASSERT_EQ(ioctl(answers.input(), FIONREAD, &waiting), 0);
  }
  std::string got;
  std::string part(1000, '\0');
  for (ssize_t count = 1; count > 0;) {
    count = read(answers.input(), part.data(), part.size());
    got += part.substr(0, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
  EXPECT_EQ(statusOf(child), 0);
  EXPECT_TRUE(got == expected) << got.size() << " of " << expected.size() << " bytes";
}

TEST_F(EvalCommand, FromAPipeThatDoesNotWait_WaitsForLateQuestions) {
  Pipe questions;
  Pipe answers;
  makeNonBlocking(questions.input());
  const pid_t child = startEval(questions.input(), answers.output());
  answers.closeOutput();
  const auto ask = [&](const std::string &text) {
    usleep(100000); // so late that it has looked before
    EXPECT_EQ(::write(questions.output(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
  };
  ask(good + "\n");
  EXPECT_TRUE(readLine(answers.input()).starts_with(R"({"id":1,"ok":true)"));
  ask(good.substr(0, 10));
  ask(good.substr(10) + "\n");
  EXPECT_TRUE(readLine(answers.input()).starts_with(R"({"id":1,"ok":true)"));
  questions.closeOutput();
  EXPECT_EQ(readLine(answers.input()), "");
  EXPECT_EQ(statusOf(child), 0);
}

} // namespace
} // namespace halfspace
