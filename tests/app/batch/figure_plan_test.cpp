#include "app/batch/figure_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace halfspace {
namespace {

PlanRequest requestFor(const std::vector<std::string> &names, std::vector<PlannedSubject> subjects,
                       const ValueRows *rows = nullptr) {
  PlanRequest request{std::move(subjects), rows, {}, {}};
  for (const std::string &name : names)
    request.outputs.push_back(*OutputName::parse(name, true));
  return request;
}

std::vector<std::string> filesOf(const PlanRequest &request) {
  const auto jobs = planFigures(request);
  EXPECT_TRUE(jobs) << jobs.problem().text();
  std::vector<std::string> files;
  for (std::size_t i = 0; jobs && i < jobs->size(); ++i)
    files.push_back((*jobs)[i].file);
  return files;
}

std::string problemOf(const PlanRequest &request) {
  const auto jobs = planFigures(request);
  return jobs ? "none" : jobs.problem().text();
}

using Files = std::vector<std::string>;
const PlannedSubject whole{"ray-box", "ray-box"};
const PlannedSubject two{"x/a.halfspace", "a", true, {1, 3}};
const ValueRows rows{"v.csv", {"Q", "name"}, {{{{0, "1,2,3"}, {1, "first"}}, 2}, {{{1, "second"}}, 3}}};

TEST(FigurePlan, OfOneSubject_IsOneFigure) {
  const auto jobs = planFigures(requestFor({"a.png"}, {whole}));
  ASSERT_TRUE(jobs);
  ASSERT_EQ(jobs->size(), 1U);
  EXPECT_EQ(jobs->front().file, "a.png");
  EXPECT_FALSE(jobs->front().step || jobs->front().row || jobs->front().frame);
}

TEST(FigurePlan, GoesThroughSubjectsRowsStepsFramesAndFormats) {
  EXPECT_EQ(filesOf(requestFor({"{lesson}-{step}.svg"}, {two, {"b", "b", false, {2}}})),
            (Files{"a-1.svg", "a-3.svg", "b-2.svg"}));
  EXPECT_EQ(filesOf(requestFor({"{row:02}-{step}.svg", "{name}-{step}.pdf"}, {two}, &rows)),
            (Files{"01-1.svg", "first-1.pdf", "01-3.svg", "first-3.pdf", "02-1.svg", "second-1.pdf",
                   "02-3.svg", "second-3.pdf"}));
  PlanRequest frames = requestFor({"%03d.png"}, {whole});
  frames.frames = {9, 11};
  EXPECT_EQ(filesOf(frames), (Files{"009.png", "010.png", "011.png"}));
  const auto jobs = planFigures(frames);
  EXPECT_EQ((*jobs)[2].frame, 11);
}

TEST(FigurePlan, WithTwoFiguresForOneFile_SaysWhichAndWhatPartsThem) {
  EXPECT_EQ(problemOf(requestFor({"a.png"}, {whole, {"b", "b"}})),
            "--output: “a.png” would be written for ray-box and for b: put {lesson} into the name.");
  EXPECT_EQ(problemOf(requestFor({"{lesson}.png"}, {two})),
            "--output: “a.png” would be written for step 1 and for step 3: put {step} into the name.");
  EXPECT_EQ(problemOf(requestFor({"a{Q}.png"}, {whole}, &rows)), "none");
  EXPECT_EQ(problemOf(requestFor({"a.png"}, {whole}, &rows)),
            "--output: “a.png” would be written for row 1 and for row 2: put {row} into the name.");
  EXPECT_EQ(problemOf(requestFor({"a.png", "./x/../a.png"}, {whole})),
            "--output: “a.png” is asked for twice.")
      << "whatever it is called";
  PlanRequest frames = requestFor({"a.png"}, {whole});
  frames.frames = {0, 1};
  EXPECT_EQ(problemOf(frames),
            "--output: Several frames need a place for their number in the file's name: -o "
            "frames/%04d.png.");
  EXPECT_EQ(problemOf(requestFor({"{lesson}.png"}, {whole, {"y/ray-box.md", "ray-box"}})),
            "--output: “ray-box.png” would be written for ray-box and for y/ray-box.md: put {lesson} into "
            "the name.");
}

TEST(FigurePlan, WithAPlaceThatNothingFills_IsRefused) {
  EXPECT_EQ(problemOf(requestFor({"{step}.png"}, {whole})),
            "--output: {step} in the name of a file needs --steps.");
  EXPECT_EQ(problemOf(requestFor({"{row}.png"}, {whole})),
            "--output: {row} in the name of a file needs --rows.");
  EXPECT_EQ(problemOf(requestFor({"{frame}.png"}, {whole})),
            "--output: {frame} in the name of a file needs --frames.");
  EXPECT_EQ(problemOf(requestFor({"{who}.png"}, {whole}, &rows)),
            "--output: Nothing fills {who} in the name of a file: neither {lesson}, {step}, {row}, {frame} "
            "nor a column "
            "of --rows.");
  const ValueRows steps{"v.csv", {"step"}, {{{{0, "1"}}, 2}}};
  EXPECT_EQ(problemOf(requestFor({"a.png"}, {whole}, &steps)),
            "v.csv:1: step: A column cannot be called so: the places of names are {lesson}, {step}, {row}, "
            "{frame}.");
  const ValueRows frames{"v.csv", {"frame"}, {{{{0, "8"}}, 2}}};
  EXPECT_EQ(filesOf(requestFor({"{frame:03}.png"}, {whole}, &frames)), Files{"008.png"})
      << "a scene may have a number of this name";
}

TEST(FigurePlan, OverAFileThatIsRead_IsRefused) {
  const std::string refusal = "--output: “a.png” is read for this: a figure cannot be written over it.";
  EXPECT_EQ(problemOf(requestFor({"{lesson}.png"}, {{"./a.png", "a", true}})), refusal);
  EXPECT_EQ(problemOf(requestFor({"b{lesson}.png"}, {{"./a.png", "a", true}})), "none");
  EXPECT_EQ(problemOf(requestFor({"{lesson}"}, {{"a", "a", false}})), "none") << "a lesson is no file";
  const ValueRows table{"a.png", {"Q"}, {{{{0, "1,2,3"}}, 2}}};
  EXPECT_EQ(problemOf(requestFor({"x/../a.png"}, {whole}, &table)),
            "--output: “x/../a.png” is read for this: a figure cannot be written over it.");
}

TEST(FigurePlan, OfTooManyFigures_IsRefusedAtOnce) {
  PlanRequest request = requestFor({"{frame}.png"}, {whole});
  request.frames = {0, static_cast<int>(mostFigures)};
  EXPECT_EQ(problemOf(request), "These are too many figures for one command: at most 200000 are made.");
}

TEST(FigurePlan, InShards_HasEachFigureOnce) {
  PlanRequest request = requestFor({"{frame}.png"}, {whole});
  request.frames = {1, 11};
  const auto all = planFigures(request);
  std::multiset<std::string> files;
  for (std::size_t index = 1; index <= 4; ++index) {
    const auto part = shardOf(*all, {index, 4});
    EXPECT_TRUE(part.size() == 2 || part.size() == 3) << "they are alike";
    for (const FigureJob &job : part)
      files.insert(job.file);
  }
  const auto expected = filesOf(request);
  EXPECT_EQ(files, std::multiset<std::string>(expected.begin(), expected.end()));
  EXPECT_TRUE(shardOf(*all, {12, 12}).empty()) << "there are fewer figures than parts";
  EXPECT_EQ(shardOf(*all, {1, 1}).size(), 11U);
}

} // namespace
} // namespace halfspace
