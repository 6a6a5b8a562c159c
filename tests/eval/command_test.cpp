// `halfspace eval` as a shell meets it: exit statuses, and nothing but answers on standard output.
#include "tests/program_test.h"

#include <algorithm>
#include <sys/stat.h>

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

} // namespace
} // namespace halfspace
