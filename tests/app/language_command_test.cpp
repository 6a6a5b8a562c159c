// The command line in a language that nobody speaks: nothing that it prints is English.
#include "tests/app/command_fixture.h"
#include "tests/untranslated.h"

namespace halfspace {
namespace {

/// What commands, their arguments, the values of these and objects of our lessons are called.
const test::Names names{
    "LESSON",  "FILE",    "FOLDER",    "ID",           "NAME",        "VALUE",         "INT",
    "FORMAT",  "THEME",   "Halfspace", "halfspace",    "subject",     "output",        "paths",
    "file",    "size",    "distance",  "lessons",      "new",         "constructions", "check",
    "explain", "render",  "eval",      "text",         "latex",       "json",          "light",
    "dark",    "print",   "projector", "WIDTHxHEIGHT", "NUMBER",      "nobody",        "nowhere",
    "LENGTH",  "dashed",  "paler",     "left",         "out",         "width",         "hidden",
    "mathml",  "shapes",  "letters",   "changed",      "steps",       "rows",          "lesson",
    "step",    "row",     "frame",     "CSV",          "ray",         "sphere",        "JSON",
    "handout", "letter",  "NUMBERS",   "paper",        "animate",     "motion",        "flight",
    "turn",    "seconds", "fps",       "labels",       "coordinates", "axes",          "grid",
    "shadows", "show",    "without",   "drop",         "lines"};

class ProgramInAnotherLanguage : public Program {
protected:
  void expectTranslated(const std::string &arguments) const {
    SCOPED_TRACE("halfspace " + arguments);
    const Ran ran = run(arguments, "HALFSPACE_LANGUAGE=pseudo");
    EXPECT_NE(ran.out + ran.err, "");
    for (const std::string &text : {ran.out, ran.err})
      EXPECT_EQ(test::untranslatedIn(text, names), std::vector<std::string>()) << text;
  }
};

TEST_F(ProgramInAnotherLanguage, Help_SaysNothingInEnglish) {
  expectTranslated("--help");
  for (const char *command :
       {"lessons", "new-lesson", "constructions", "check", "explain", "render", "handout", "animate", "eval"})
    expectTranslated(command + std::string(" --help"));
}

TEST_F(ProgramInAnotherLanguage, Refusals_SayNothingInEnglish) {
  for (const char *arguments : {"--nope",
                                "explain",
                                "explain a b c",
                                "render x",
                                "render x -o",
                                "render x -o a.png --step x",
                                "render x -o a.png --step 0",
                                "render x -o a.jpg",
                                "render x -o a.png --theme blue",
                                "render x -o a.svg --width 1km",
                                "render x -o a.svg --text big",
                                "render x -o a.svg --width 1cm --text 20pt",
                                "render x -o a.svg --hidden no",
                                "render x -o a.png --hidden dashed",
                                "render x -o a.png --without nobody",
                                "render x -o a.png --show axes --without axes",
                                "render x -o a.png --size 0x0",
                                "animate x -o a.gif",
                                "animate x --motion dance -o a.gif",
                                "animate x --motion turn -o a.avi",
                                "animate x --motion turn -o a.gif --fps 0",
                                "animate x --motion turn -o a.gif --seconds 0",
                                "animate ray-sphere --motion turn -o a.png",
                                "animate ray-sphere --motion turn -o a.gif --fps 30",
                                "animate ray-sphere --motion turn -o a.mp4 --transparent",
                                "animate ray-sphere --motion turn -o a.mp4 --size 65x65",
                                "animate ray-sphere --motion turn -o a.gif --size 16000x16000",
                                "animate ray-sphere --motion turn -o a.gif --seconds 600 --fps 25",
                                "animate ray-sphere --motion turn -o a.gif --step 99",
                                "animate ray-sphere --motion flight -o a.gif",
                                "animate ray-sphere --motion steps --step 1 -o a.gif",
                                "animate ray-sphere --motion turn -o no/where.gif",
                                "render x -o a.png --frame 1.5",
                                "render x -o a.png --frame 1 --frames 0:3",
                                "render -o a.png",
                                "render x --all -o a.png",
                                "render x --steps 0 -o a.png",
                                "render x --shard 2/1 -o a.png",
                                "render x -o 'a{.png'",
                                "render ray-sphere -o 'a{step}.png'",
                                "render ray-sphere -o 'a{nobody}.png'",
                                "render ray-sphere --steps -o a.png",
                                "render ray-sphere --rows nowhere.csv -o a.png",
                                "render ray-sphere nowhere --step 99 -o '{lesson}.png'",
                                "handout x",
                                "handout x -o a.pdf --steps x",
                                "handout x -o a.pdf --paper a3",
                                "handout x -o a.pdf --hidden no",
                                "handout nowhere -o a.pdf",
                                "handout ray-sphere -o a.pdf --steps 99",
                                "handout ray-sphere -o no/where.pdf",
                                "explain x --format xml",
                                "lessons explain x",
                                "x explain",
                                "explin x",
                                "--mesh a.stl lessons",
                                "new-lesson A",
                                "new-lesson ray-sphere",
                                "explain nowhere",
                                "explain nowhere.md",
                                "explain ray-sphere --set Q",
                                "explain ray-sphere --set Q=1",
                                "explain ray-sphere --set nobody=1",
                                "explain ray-sphere --set Q=1,2,x",
                                "eval nowhere",
                                "render ray-sphere -o no/where.png",
                                "render ray-sphere -o a.png --step 99",
                                "render ray-sphere -o a.png --flat",
                                "render ray-sphere -o a.png --frame 1",
                                ""})
    expectTranslated(arguments);
}

TEST_F(ProgramInAnotherLanguage, Check_SaysNothingInEnglish) {
  expectTranslated("check");
  ASSERT_EQ(run("new-lesson base").status, 0);
  expectTranslated("new-lesson base");
}

TEST_F(Program, InALocaleWithADecimalComma_WritesIt) {
  const std::string rounded = "explain plane-implicit --set n=1,1,2";
  EXPECT_NE(run(rounded, "LC_ALL=de_DE.UTF-8").out.find("103,1°"), std::string::npos);
  EXPECT_NE(run(rounded, "LC_ALL=C").out.find("103.1°"), std::string::npos);
}

} // namespace
} // namespace halfspace
