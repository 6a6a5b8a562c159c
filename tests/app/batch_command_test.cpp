// Many figures from one command.
#include "tests/app/command_fixture.h"

#include <csignal>
#include <set>

namespace halfspace {
namespace {

namespace fs = std::filesystem;

class Batch : public Program {
protected:
  /// All files but those that the tests write to, by their names in this folder.
  [[nodiscard]] std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto &entry : fs::recursive_directory_iterator(folder()))
      if (const auto name = fs::relative(entry.path(), folder()).string();
          entry.is_regular_file() && !name.starts_with(".out") && !name.starts_with(".err"))
        names.insert(name);
    return names;
  }
  void expectDone(const std::string &arguments) const {
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.status, 0) << arguments << "\n" << ran.err;
    EXPECT_EQ(ran.err, "");
  }
  /// Some figures are missing: a sentence for each and one for all.
  void expectMissing(const std::string &arguments, const std::string &reason,
                     const std::string &count) const {
    SCOPED_TRACE(arguments);
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.status, 1);
    EXPECT_NE(ran.err.find(reason), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find(count + " figures are done. What kept the others is told above.\n"),
              std::string::npos)
        << ran.err;
  }
};

using Names = std::set<std::string>;

TEST_F(Batch, OfStepsOfLessons_IsWhatEachAloneIs) {
  expectDone("render signed-distance ray-sphere --steps 1,3 -o '{lesson}-{step:02}.svg'");
  EXPECT_EQ(files(), (Names{"signed-distance-01.svg", "signed-distance-03.svg", "ray-sphere-01.svg",
                            "ray-sphere-03.svg"}));
  expectDone("render ray-sphere --step 3 -o alone.svg");
  EXPECT_EQ(file("ray-sphere-03.svg"), file("alone.svg"));
  EXPECT_NE(file("ray-sphere-01.svg"), file("alone.svg"));
}

TEST_F(Batch, InSeveralFormats_IsEachAsItIsAlone) {
  expectDone("render signed-distance --width 8cm --dpi 100 --hidden paler -o a.png -o a.pdf");
  expectDone("render signed-distance --width 8cm --dpi 100 -o alone.png");
  expectDone("render signed-distance --width 8cm --hidden paler -o alone.pdf");
  EXPECT_EQ(file("a.png"), file("alone.png"));
  EXPECT_EQ(file("a.pdf"), file("alone.pdf"));
  expectRefused("render signed-distance --svg-text letters -o a.png -o a.pdf", "--svg-text is for SVG");
  expectRefused("render signed-distance -o a.png -o ./a.png", "“a.png” is asked for twice");
}

TEST_F(Batch, OfEachStep_HasAsManyFiguresAsTheLesson) {
  expectDone("render signed-distance -o '{step}.svg' --steps");
  const auto lessons = nlohmann::json::parse(run("lessons --json").out);
  for (const auto &lesson : lessons)
    if (lesson.at("id") == "signed-distance") {
      EXPECT_EQ(files().size(), lesson.at("steps").get<std::size_t>());
    }
}

TEST_F(Batch, OfAllLessons_HasEach) {
  expectDone("render --all --step 1 --crop -o '{lesson}.svg'");
  EXPECT_EQ(files().size(), nlohmann::json::parse(run("lessons --json").out).size());
}

TEST_F(Batch, OfRows_HasTheValuesOfEach) {
  write("values.csv", "\xEF\xBB\xBFQ;name;P0\r\n\"1,5; 2; 3\";first;\r\n4,5,6;\"the second\";0,0,0\r\n");
  expectDone("render signed-distance --rows values.csv -o '{row}-{name}.svg'");
  expectDone("render signed-distance --set Q=3/2,2,3 -o first.svg");
  expectDone("render signed-distance --set Q=4,5,6 --set P0=0,0,0 -o second.svg");
  EXPECT_EQ(file("1-first.svg"), file("first.svg"));
  EXPECT_EQ(file("2-the second.svg"), file("second.svg"));
  write("values.jsonl",
        "{\"Q\": [1.5, 2, 3], \"name\": \"a\"}\n{\"Q\": \"4,5,6\", \"P0\": [0, 0, 0], \"name\": \"b\"}\n");
  expectDone("render signed-distance --rows values.jsonl -o '{name}.svg'");
  EXPECT_EQ(file("a.svg"), file("first.svg"));
  EXPECT_EQ(file("b.svg"), file("second.svg"));
}

TEST_F(Batch, OfPixels_IsWhatEachAloneIs) {
  write("values.csv", "Q\n\"1,2,3\"\n\"11,15,8\"\n");
  expectDone("render signed-distance --size 160x100 --rows values.csv -o '{row}.png'");
  expectDone("render signed-distance --size 160x100 --set Q=11,15,8 -o alone.png");
  EXPECT_EQ(file("2.png"), file("alone.png"));
  EXPECT_NE(file("1.png"), file("alone.png"));
}

TEST_F(Batch, OfFramesOfRows_HasEachFrameOfEachFlight) {
  write("seeds.csv", "seed\n7\n8\n");
  expectDone("render photon-torpedo --rows seeds.csv --frames 38:39 -o '{row}-%03d.svg'");
  EXPECT_EQ(files(), (Names{"seeds.csv", "1-038.svg", "1-039.svg", "2-038.svg", "2-039.svg"}));
  expectDone("render photon-torpedo --set seed=8 --frame 39 -o alone.svg");
  EXPECT_EQ(file("2-039.svg"), file("alone.svg"));
}

TEST_F(Batch, WithoutFoldersForItsLessons_MakesThem_ButNotTheOneThatTheyAreIn) {
  expectDone("render signed-distance ray-sphere --step 1 -o '{lesson}/{step}.svg'");
  EXPECT_EQ(files(), (Names{"signed-distance/1.svg", "ray-sphere/1.svg"}));
  expectMissing("render signed-distance ray-sphere --step 1 -o 'typo/{lesson}/{step}.svg'",
                "typo/ray-sphere/1.svg: This cannot be written", "0 of 2");
  EXPECT_FALSE(fs::exists(inFolder("typo")));
}

TEST_F(Batch, GoesOnAfterAFigureThatCannotBeMade) {
  write("values.csv", "Q\n\"1,2,3\"\n\"1,2\"\n\"1,2,x\"\n\"4,5,6\"\n");
  const std::string render = "render signed-distance --rows values.csv -o '{row}.svg'";
  expectMissing(render, "values.csv:3: Q: Q takes three numbers", "2 of 4");
  expectMissing(render, "values.csv:4: Q: “x” is not a number", "2 of 4");
  EXPECT_EQ(files(), (Names{"values.csv", "1.svg", "4.svg"}));
}

TEST_F(Batch, OfFramesThatARowTakesAway_HasTheOthers) {
  write("ends.csv", "frame.to\n5\n");
  expectMissing("render photon-torpedo --rows ends.csv --frames 5:7 -o '{frame}.svg'",
                "The flight has no frame 6: the nearest is 5.", "1 of 3");
  EXPECT_EQ(files(), (Names{"ends.csv", "5.svg"}));
}

TEST_F(Batch, OfFramesOfASceneWithoutItsFlight_IsRefused) {
  write("own.halfspace", R"({"format":"halfspace","version":5,"lesson":"photon-torpedo","step":1,)"
                         R"("scene":[{"name":"Q","point":[1,2,3]}]})");
  expectRefused("render own.halfspace --frame 3 -o a.svg", "no flight whose frames");
}

TEST_F(Batch, GoesOnAfterALessonThatIsNotThere) {
  expectMissing("render nowhere signed-distance --step 1 -o '{lesson}.svg'", "There is no lesson “nowhere”",
                "halfspace: 1");
  EXPECT_EQ(files(), Names{"signed-distance.svg"});
  expectMissing("render ray-sphere signed-distance --steps 1,99 -o '{lesson}-{step}.svg'",
                "ray-sphere: --step: The lesson has 9 steps.", "halfspace: 2");
  EXPECT_EQ(files(), (Names{"signed-distance.svg", "ray-sphere-1.svg", "signed-distance-1.svg"}))
      << "the steps that are there";
  expectMissing("render ray-sphere signed-distance --step 99 -o '{lesson}.svg'",
                "ray-sphere: --step: The lesson has", "halfspace: 0");
}

TEST_F(Batch, GoesOnAfterAFileThatCannotBeWritten) {
  fs::create_directory(inFolder("ray-sphere.svg"));
  expectMissing("render signed-distance ray-sphere plane-plane --step 1 -o '{lesson}.svg'",
                "ray-sphere.svg: This cannot be written: it is a folder.", "2 of 3");
  EXPECT_EQ(files(), (Names{"signed-distance.svg", "plane-plane.svg"}));
}

TEST_F(Batch, ThatCannotBeMeant_IsRefusedBeforeAnythingIsDrawn) {
  write("values.csv", "Q\n\"1,2,3\"\n\"4,5,6\"\n");
  write("names.csv", "Z\n1\n");
  write("broken.csv", "Q\n\"1,2,3\n");
  write("empty.csv", "");
  const std::string lesson = "render signed-distance ";
  expectRefused(lesson + "--steps -o a.svg",
                "would be written for step 1 and for step 2: put {step} into the name");
  expectRefused(lesson + "--rows values.csv -o a.svg", "for row 1 and for row 2: put {row} into the name");
  expectRefused(lesson + "ray-sphere -o a.svg", "put {lesson} into the name");
  expectRefused("render --all -o a.svg", "put {lesson} into the name");
  expectRefused(lesson + "-o 'a{step}.svg'", "{step} in the name of a file needs --steps");
  expectRefused(lesson + "-o 'a{who}.svg'", "Nothing fills {who}");
  expectRefused(lesson + "-o 'a{.svg'", "no place to be filled");
  expectRefused(lesson + "--rows names.csv -o '{row}.svg'",
                "names.csv:1: Z: “Z” is not one of the values here");
  expectRefused(lesson + "--rows broken.csv -o '{row}.svg'", "broken.csv:2: The quotes that begin a cell");
  expectRefused(lesson + "--rows empty.csv -o '{row}.svg'", "empty.csv: The file has no rows");
  expectRefused(lesson + "--rows no.csv -o '{row}.svg'", "no.csv");
  expectRefused(lesson + "--rows . -o '{row}.svg'", "folder");
  expectRefused(lesson + "--steps 0 -o '{step}.svg'", "--steps takes numbers of steps");
  expectRefused(lesson + "--steps 3-1 -o '{step}.svg'", "--steps takes numbers of steps");
  expectRefused(lesson + "--steps 1,99 -o '{step}.svg'", "The lesson has");
  expectRefused("render --steps signed-distance -o '{step}.svg'", "Lessons and files stand before it");
  expectRefused(lesson + "--steps 1 --step 1 -o '{step}.svg'", "--step");
  expectRefused(lesson + "--shard 3/2 -o a.svg", "--shard takes the number of a part");
  expectRefused(lesson + "--shard 0/2 -o a.svg", "--shard takes the number of a part");
  expectRefused(lesson + "--all -o '{lesson}.svg'", "--all is for all lessons");
  expectRefused("render -o a.svg", "Say what to draw");
  EXPECT_EQ(files(), (Names{"values.csv", "names.csv", "broken.csv", "empty.csv"}));
}

TEST_F(Batch, OverAFileThatItReads_IsRefused) {
  expectDone("render signed-distance -o a.svg");
  const std::string before = file("a.svg");
  expectRefused("render a.svg --theme dark -o '{lesson}.svg'", "“a.svg” is read for this");
  fs::create_symlink("a.svg", inFolder("b.svg"));
  expectRefused("render a.svg --theme dark -o b.svg", "“b.svg” is read for this");
  EXPECT_EQ(file("a.svg"), before);
}

TEST_F(Batch, InShards_IsTheSameTogether) {
  const std::string render = "render signed-distance ray-sphere --steps 1-3 -o ";
  expectDone(render + "'all-{lesson}-{step}.svg'");
  expectDone(render + "'{lesson}-{step}.svg' --shard 1/2");
  EXPECT_EQ(files().size(), 9U);
  expectDone(render + "'{lesson}-{step}.svg' --shard 2/2");
  EXPECT_EQ(files().size(), 12U);
  for (const std::string name : {"signed-distance-2.svg", "ray-sphere-3.svg"})
    EXPECT_EQ(file(name), file("all-" + name));
}

/// Draws only what has changed.
class ChangedBatch : public Batch {
protected:
  /// Draws again, and returns the numbers that are told: drawn and unchanged.
  [[nodiscard]] std::string drawn(const std::string &arguments) const {
    const Ran ran = run("render " + arguments + " --changed");
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_EQ(ran.err, "");
    return ran.out;
  }
  static std::string told(int made, int unchanged) {
    return "Figures drawn: " + std::to_string(made) + ". Unchanged: " + std::to_string(unchanged) + ".\n";
  }
};

TEST_F(ChangedBatch, WithNothingChanged_DrawsNothing_InAnyFormat) {
  for (const std::string ending : {"png", "svg", "pdf", "tex"}) {
    const std::string render = "signed-distance --size 160x100 --steps 1-2 -o '{step}." + ending + "'";
    EXPECT_EQ(drawn(render), told(2, 0)) << ending;
    const std::string before = file("2." + ending);
    EXPECT_EQ(drawn(render), told(0, 2)) << ending;
    EXPECT_EQ(file("2." + ending), before);
    fs::remove(inFolder("2." + ending));
    EXPECT_EQ(drawn(render), told(1, 1)) << ending;
    EXPECT_EQ(file("2." + ending), before) << "the same bytes again";
    if (ending != "tex") {
      EXPECT_EQ(run("explain 2." + ending).out, run("explain signed-distance").out);
    }
  }
}

TEST_F(ChangedBatch, WithOtherOptions_DrawsAll) {
  const std::string render = "signed-distance --steps 1-2 -o '{step}.svg' ";
  for (const std::string options :
       {"", "--theme dark", "--width 9cm", "--crop", "--hidden paler", "--anonymous", "--transparent",
        "--svg-text letters", "--show coordinates", "--without axes,grid", "--set Q=1,2,3"}) {
    EXPECT_EQ(drawn(render + options), told(2, 0)) << options;
    EXPECT_EQ(drawn(render + options), told(0, 2)) << options;
  }
  EXPECT_EQ(drawn("signed-distance --set Q=1,2,3 --steps 1-3 --shard 1/2 -o '{step}.svg'"), told(1, 1))
      << "which are asked for changes none";
}

TEST_F(ChangedBatch, WithAnotherValue_DrawsThatRow) {
  write("values.csv", "Q\n\"1,2,3\"\n\"4,5,6\"\n");
  const std::string render = "signed-distance --rows values.csv -o '{row}.svg'";
  EXPECT_EQ(drawn(render), told(2, 0));
  write("values.csv", "Q\n\"1,2,3\"\n\"4,5,7\"\n");
  EXPECT_EQ(drawn(render), told(1, 1));
}

TEST_F(ChangedBatch, OfAnotherFrame_DrawsIt) {
  EXPECT_EQ(drawn("photon-torpedo --set seed=7 --frame 38 -o a.svg"), told(1, 0));
  EXPECT_EQ(drawn("photon-torpedo --set seed=7 --frame 39 -o a.svg"), told(1, 0));
  EXPECT_EQ(drawn("photon-torpedo --set seed=7 --frame 39 -o a.svg"), told(0, 1));
}

TEST_F(ChangedBatch, WithAFileThatIsNotAsItWasMade_DrawsIt) {
  const std::string render = "signed-distance --steps 1-2 -o '{step}.svg'";
  EXPECT_EQ(drawn(render), told(2, 0));
  write("1.svg", file("1.svg").substr(0, 1000));
  EXPECT_EQ(drawn(render), told(1, 1));
  expectDone("render " + render);
  EXPECT_EQ(drawn(render), told(2, 0)) << "they were made without marks";
}

TEST_F(ChangedBatch, OfALessonWithOtherWords_DrawsItAgain) {
  ASSERT_EQ(run("new-lesson mine").status, 0);
  EXPECT_EQ(drawn("mine.md -o a.svg"), told(1, 0));
  EXPECT_EQ(drawn("mine.md -o a.svg"), told(0, 1));
  write("mine.md", file("mine.md") + "\nMore words.\n");
  EXPECT_EQ(drawn("mine.md -o a.svg"), told(1, 0));
}

TEST_F(ChangedBatch, ByAnotherProgram_DrawsAll) {
  ASSERT_EQ(run("new-lesson mine").status, 0);
  addLesson(file("mine.md"));
  EXPECT_EQ(drawn("signed-distance -o a.svg"), told(1, 0));
  EXPECT_EQ(drawn("signed-distance -o a.svg"), told(0, 1));
  std::ofstream(inFolder("own/bin/halfspace"), std::ios::binary | std::ios::app) << "another";
  EXPECT_EQ(drawn("signed-distance -o a.svg"), told(1, 0));
}

TEST_F(Batch, ThatIsToldToEnd_LeavesWholeFilesAndSaysHowFarItCame) {
  const Ran ran = runUntil("ls *.svg >/dev/null", "render --all -o '{lesson}-{step}.svg' --steps");
  EXPECT_EQ(ran.status, 128 + SIGTERM);
  const auto made = files();
  EXPECT_FALSE(made.empty());
  EXPECT_EQ(ran.err.find("halfspace: Interrupted: " + std::to_string(made.size()) + " of "), 0U) << ran.err;
  EXPECT_TRUE(ran.err.ends_with(" figures are done, and whole.\n")) << ran.err;
  for (const std::string &name : made)
    EXPECT_TRUE(name.ends_with(".svg") && file(name).ends_with("</svg>\n")) << name;
}

TEST_F(Batch, AtATerminal_TellsHowFarItIs) {
  if (shell("command -v script >.out 2>.err").status != 0)
    GTEST_SKIP() << "script is not installed";
  const Ran ran = shell("script --quiet --return --command \"'" HALFSPACE_PROGRAM
                        "' render signed-distance --steps 1-2 -o "
                        "'{step}.svg'\" .typed >.out 2>.err </dev/null");
  EXPECT_EQ(ran.status, 0);
  EXPECT_NE(ran.out.find("Figure 1 of 2"), std::string::npos) << ran.out;
}

} // namespace
} // namespace halfspace
