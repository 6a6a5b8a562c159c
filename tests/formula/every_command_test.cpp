// Every command and environment is laid out, and each of its characters is in a font.
#include "tests/formula/described.h"
#include "tests/formula/laid_out.h"

#include "lessons/term/greek.h"
#include "widgets/formula/latex_command_readers.h"
#include "widgets/formula/latex_symbols.h"
#include "widgets/formula/latex_tokens.h"

#include <map>

namespace halfspace::math {
namespace {

/// What a command needs behind it.
struct Needs {
  ReadCommand read;
  const char *arguments;
};

const std::vector<Needs> needs{{&readFenced, "(x\\right)"},
                               {&readTallFence, "("},
                               {&readText, "{ab}"},
                               {&readOperatorName, "{ab}"},
                               {&readTag, "{1}"},
                               {&readLabel, "{ab}"},
                               {&readMark, "{id}{x}"},
                               {&readColor, "{red}{x}"},
                               {&readGivenSpace, "{1em}"},
                               {&readKern, "1em"},
                               {&readBlock, "{1em}{2em}"},
                               {&readSubstack, "{a\\\\b}"},
                               {&readEnvironment, "{matrix}a\\end{matrix}"}};

std::string sourceWith(const Command &command) {
  const std::string name = "\\" + std::string(command.name);
  if (command.read == &readMiddle)
    return "\\left(a" + name + "|b\\right)";
  for (const Needs &each : needs)
    if (each.read == command.read)
      return "a" + name + each.arguments + " b";
  return "a" + name + " xyz";
}

void expectComplete(const std::string &source) {
  const Layout layout = laidOut(source);
  EXPECT_FALSE(layout.glyphs.empty()) << source;
  for (const PlacedGlyph &glyph : layout.glyphs)
    EXPECT_NE(glyph.glyph, 0U) << source;
}

TEST(EveryCommand, LaidOut_HasAllItsGlyphs) {
  for (const Command &command : commands())
    if (command.read != &readMisplaced)
      expectComplete(sourceWith(command));
}

TEST(EveryCommand, Misplaced_IsAnErrorWhereverItStands) {
  for (const Command &command : commands())
    if (command.read == &readMisplaced) {
      const auto result = readLatex("{a\\" + std::string(command.name) + " x}");
      EXPECT_TRUE(std::holds_alternative<ReadError>(result) || command.name == "limits" ||
                  command.name == "nolimits")
          << command.name;
    }
}

TEST(EverySymbol, LaidOut_HasItsGlyph) {
  for (const SymbolCommand &command : symbolCommands())
    expectComplete("a\\" + std::string(command.name) + " b");
}

TEST(EverySymbol, Typed_IsLaidOutToo) {
  for (const SymbolCommand &command : symbolCommands()) {
    std::string character;
    appendUtf8(character, command.character);
    if (command.character >= 0x80)
      expectComplete("a" + character + "b");
  }
}

TEST(EverySymbol, ItsName_IsNoOtherCommands) {
  for (const SymbolCommand &command : symbolCommands()) {
    EXPECT_EQ(commandNamed(command.name), nullptr) << command.name;
    EXPECT_EQ(symbolNamed(command.name)->character, command.character) << command.name;
  }
}

TEST(EveryGreekLetter, ByItsCommand_IsTheLetter) {
  for (const GreekLetter &each : greekLetters) {
    const std::string command(each.latex);
    expectComplete("a\\" + command + " b");
    EXPECT_EQ(read("\\" + command), read(each.letter)) << command;
    EXPECT_EQ(commandNamed(command), nullptr) << command;
    EXPECT_EQ(symbolNamed(command), nullptr) << command;
  }
}

TEST(EveryAlphabet, LaidOut_HasAllItsLetters) {
  for (const char *alphabet :
       {"mathit", "mathrm", "mathbf", "boldsymbol", "mathbb", "mathcal", "mathfrak", "mathsf", "mathtt"})
    expectComplete("\\" + std::string(alphabet) +
                   "{ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789\\lambda\\Gamma}");
}

TEST(EveryEnvironment, LaidOut_HasItsCells) {
  for (const char *name : {"matrix",      "pmatrix",      "bmatrix",      "Bmatrix",  "vmatrix",   "Vmatrix",
                           "smallmatrix", "psmallmatrix", "bsmallmatrix", "cases",    "dcases",    "rcases",
                           "align",       "align*",       "aligned",      "split",    "eqnarray*", "gather",
                           "gather*",     "gathered",     "multline*",    "equation", "equation*", "array"}) {
    const std::string environment = name;
    const std::string source = "\\begin{" + environment + "}" + (environment == "array" ? "{lc}" : "") +
                               "p&q\\\\r&s\\end{" + environment + "}";
    expectComplete(source);
    const Layout layout = laidOut(source);
    EXPECT_GT(letterIn(layout, 'q').x, letterIn(layout, 'p').x) << name;
    EXPECT_GT(letterIn(layout, 'r').y, letterIn(layout, 'p').y) << name;
  }
}

TEST(EveryFence, Stretched_HasItsGlyphs) {
  for (const char *fence : {"(",        ")",       "[",         "]",           "\\{",           "\\}",
                            "|",        "\\|",     "/",         "\\backslash", "\\langle",      "\\rangle",
                            "\\lfloor", "\\rceil", "\\uparrow", "\\Downarrow", "\\updownarrow", "\\llbracket",
                            "\\lvert",  "\\lVert"})
    expectComplete("\\left" + std::string(fence) +
                   "\\begin{matrix}1\\\\2\\\\3\\\\4\\\\5\\end{matrix}\\right.");
}

} // namespace
} // namespace halfspace::math
