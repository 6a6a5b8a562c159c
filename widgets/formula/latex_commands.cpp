#include "widgets/formula/latex_commands.h"

#include "widgets/formula/latex_command_readers.h"

#include <algorithm>
#include <array>

namespace halfspace::math {
namespace {

/// TeX's unit of spaces in mathematics.
constexpr double mu = 1.0 / 18;
constexpr double wordSpace = 1.0 / 3;
/// How tall \big, \Big, \bigg and \Bigg are at least. LaTeX's are 1.2, 1.8, 2.4 and 3 em; fonts' differ by a
/// hair.
constexpr std::array<double, 4> tall{1.19, 1.79, 2.39, 2.98};

constexpr Command letter(std::string_view name, char32_t character) {
  return {.name = name, .read = &readLetter, .character = character};
}
constexpr Command large(std::string_view name, char32_t character,
                        ScriptPlace scriptPlace = ScriptPlace::LimitsInDisplay) {
  return {.name = name,
          .read = &readLargeOperator,
          .character = character,
          .atomClass = AtomClass::Op,
          .scriptPlace = scriptPlace};
}
constexpr Command integral(std::string_view name, char32_t character) {
  return large(name, character, ScriptPlace::Beside);
}
constexpr Command named(std::string_view name, std::string_view text = {}) {
  return {.name = name, .read = &readFunction, .atomClass = AtomClass::Op, .text = text};
}
constexpr Command limit(std::string_view name, std::string_view text = {}) {
  Command command = named(name, text);
  command.scriptPlace = ScriptPlace::LimitsInDisplay;
  return command;
}
constexpr Command accented(std::string_view name, char32_t character) {
  return {.name = name, .read = &readAccent, .character = character};
}
constexpr Command wide(std::string_view name, char32_t character) {
  return {.name = name, .read = &readWideAccent, .character = character};
}
constexpr Command braced(std::string_view name, char32_t character, Side side) {
  return {.name = name, .read = &readBrace, .character = character, .side = side};
}
constexpr Command arrow(std::string_view name, char32_t character) {
  return {.name = name, .read = &readArrow, .character = character};
}
constexpr Command alphabet(std::string_view name, Alphabet alphabet) {
  return {.name = name, .read = &readAlphabet, .alphabet = alphabet};
}
constexpr Command alphabetSwitch(std::string_view name, Alphabet alphabet) {
  return {.name = name, .read = &readAlphabetSwitch, .alphabet = alphabet};
}
constexpr Command text(std::string_view name, Alphabet alphabet) {
  return {.name = name, .read = &readText, .alphabet = alphabet};
}
constexpr Command space(std::string_view name, double em) {
  return {.name = name, .read = &readSpace, .amount = em};
}
constexpr Command styled(std::string_view name, Style style) {
  return {.name = name, .read = &readStyle, .style = style};
}
constexpr Command fence(std::string_view name, AtomClass atomClass, double height) {
  return {.name = name, .read = &readTallFence, .amount = height, .atomClass = atomClass};
}
constexpr Command classed(std::string_view name, AtomClass atomClass) {
  return {.name = name,
          .read = &readClass,
          .atomClass = atomClass,
          .scriptPlace = atomClass == AtomClass::Op ? ScriptPlace::LimitsInDisplay : ScriptPlace::Beside};
}
constexpr Command lap(std::string_view name, Align align) {
  return {.name = name, .read = &readLap, .align = align};
}
constexpr Command plain(std::string_view name, ReadCommand read) { return {.name = name, .read = read}; }
constexpr Command fraction(std::string_view name, ReadCommand read, Style style) {
  return {.name = name, .read = read, .style = style};
}

constexpr auto byName(auto commands) {
  std::sort(commands.begin(), commands.end(), [](const auto &a, const auto &b) { return a.name < b.name; });
  return commands;
}

constexpr Command listed[]{
    // Small Greek letters that lessons/term/greek.h does not have
    letter("epsilon", U'ϵ'), letter("vartheta", U'ϑ'), letter("varkappa", U'ϰ'), letter("omicron", U'ο'),
    letter("varpi", U'ϖ'), letter("varrho", U'ϱ'), letter("varsigma", U'ς'), letter("upsilon", U'υ'),
    letter("phi", U'ϕ'),
    // Large operators and functions
    large("sum", U'∑'), large("prod", U'∏'), large("coprod", U'∐'), large("bigcup", U'⋃'),
    large("bigcap", U'⋂'), large("bigsqcup", U'⨆'), large("biguplus", U'⨄'), large("bigoplus", U'⨁'),
    large("bigotimes", U'⨂'), large("bigodot", U'⨀'), large("bigwedge", U'⋀'), large("bigvee", U'⋁'),
    integral("int", U'∫'), integral("iint", U'∬'), integral("iiint", U'∭'), integral("oint", U'∮'),
    named("sin"), named("cos"), named("tan"), named("cot"), named("sec"), named("csc"), named("arcsin"),
    named("arccos"), named("arctan"), named("sinh"), named("cosh"), named("tanh"), named("coth"),
    named("exp"), named("log"), named("ln"), named("lg"), named("dim"), named("ker"), named("deg"),
    named("arg"), named("hom"), limit("lim"), limit("max"), limit("min"), limit("sup"), limit("inf"),
    limit("det"), limit("gcd"), limit("Pr"), limit("limsup", "lim sup"), limit("injlim", "inj lim"),
    limit("projlim", "proj lim"), limit("liminf", "lim inf"),
    Command{.name = "bmod", .read = &readFunction, .atomClass = AtomClass::Bin, .text = "mod"},
    plain("operatorname", &readOperatorName), plain("pmod", &readModulo),
    // Dots
    Command{.name = "ldots", .read = &readDots, .character = U'.'},
    Command{.name = "dotsc", .read = &readDots, .character = U'.'},
    Command{.name = "cdots", .read = &readDots, .character = U'⋅'},
    Command{.name = "dotsb", .read = &readDots, .character = U'⋅'},
    Command{.name = "dotsm", .read = &readDots, .character = U'⋅'},
    Command{.name = "dotsi", .read = &readDots, .character = U'⋅'},
    Command{.name = "dotso", .read = &readDots, .character = U'.'}, plain("dots", &readDots),
    plain("ddots", &readDiagonalDots),
    // Accents, bars, braces, what stands above and below
    accented("vec", 0x20D7), accented("hat", 0x302), accented("bar", 0x304), accented("tilde", 0x303),
    accented("dot", 0x307), accented("ddot", 0x308), accented("dddot", 0x20DB), accented("check", 0x30C),
    accented("breve", 0x306), accented("acute", 0x301), accented("grave", 0x300), accented("mathring", 0x30A),
    wide("widehat", 0x302), wide("widetilde", 0x303), wide("widecheck", 0x30C),
    wide("overrightarrow", 0x20D7), wide("overleftarrow", 0x20D6), wide("overleftrightarrow", 0x20E1),
    Command{.name = "overline", .read = &readBar},
    Command{.name = "underline", .read = &readBar, .side = Side::Below},
    braced("overbrace", U'⏞', Side::Above), braced("underbrace", U'⏟', Side::Below),
    braced("overbracket", U'⎴', Side::Above), braced("underbracket", U'⎵', Side::Below),
    braced("overparen", U'⏜', Side::Above), braced("underparen", U'⏝', Side::Below),
    Command{.name = "overset", .read = &readStack},
    Command{.name = "underset", .read = &readStack, .side = Side::Below},
    Command{.name = "stackrel", .read = &readStack, .atomClass = AtomClass::Rel}, arrow("xrightarrow", U'→'),
    arrow("xleftarrow", U'←'), arrow("xleftrightarrow", U'↔'), arrow("xRightarrow", U'⇒'),
    arrow("xLeftarrow", U'⇐'), arrow("xLeftrightarrow", U'⇔'), arrow("xmapsto", U'↦'), plain("not", &readNot),
    // Alphabets and words
    alphabet("mathit", Alphabet::Italic), alphabet("mathnormal", Alphabet::Italic),
    alphabet("mathrm", Alphabet::Upright), alphabet("mathup", Alphabet::Upright),
    alphabet("mathbf", Alphabet::Bold), alphabet("mathbfup", Alphabet::Bold),
    alphabet("mathbfit", Alphabet::BoldItalic), alphabet("boldsymbol", Alphabet::BoldItalic),
    alphabet("bm", Alphabet::BoldItalic), alphabet("pmb", Alphabet::BoldItalic),
    alphabet("mathbb", Alphabet::Blackboard), alphabet("mathcal", Alphabet::Script),
    alphabet("mathscr", Alphabet::Script), alphabet("mathfrak", Alphabet::Fraktur),
    alphabet("mathsf", Alphabet::Sans), alphabet("mathtt", Alphabet::Mono),
    alphabetSwitch("rm", Alphabet::Upright), alphabetSwitch("bf", Alphabet::Bold),
    alphabetSwitch("it", Alphabet::Italic), alphabetSwitch("cal", Alphabet::Script),
    alphabetSwitch("sf", Alphabet::Sans), alphabetSwitch("tt", Alphabet::Mono),
    text("text", Alphabet::Upright), text("textrm", Alphabet::Upright), text("textnormal", Alphabet::Upright),
    text("textup", Alphabet::Upright), text("mbox", Alphabet::Upright), text("textbf", Alphabet::Bold),
    text("textit", Alphabet::Italic), text("emph", Alphabet::Italic), text("textsf", Alphabet::Sans),
    text("texttt", Alphabet::Mono),
    // Spaces and styles
    space(",", 3 * mu), space("thinspace", 3 * mu), space(":", 4 * mu), space(">", 4 * mu),
    space("medspace", 4 * mu), space(";", 5 * mu), space("thickspace", 5 * mu), space("!", -3 * mu),
    space("negthinspace", -3 * mu), space(" ", wordSpace), space("space", wordSpace),
    space("nobreakspace", wordSpace), space("enspace", 0.5), space("enskip", 0.5), space("quad", 1),
    space("qquad", 2), plain("hspace", &readGivenSpace), plain("mspace", &readGivenSpace),
    plain("kern", &readKern), plain("mkern", &readKern), plain("hskip", &readKern), plain("mskip", &readKern),
    styled("displaystyle", Style::Display), styled("textstyle", Style::Text),
    styled("scriptstyle", Style::Script), styled("scriptscriptstyle", Style::ScriptScript),
    // Fences
    plain("left", &readFenced), plain("middle", &readMiddle), fence("big", AtomClass::Ord, tall[0]),
    fence("Big", AtomClass::Ord, tall[1]), fence("bigg", AtomClass::Ord, tall[2]),
    fence("Bigg", AtomClass::Ord, tall[3]), fence("bigl", AtomClass::Open, tall[0]),
    fence("Bigl", AtomClass::Open, tall[1]), fence("biggl", AtomClass::Open, tall[2]),
    fence("Biggl", AtomClass::Open, tall[3]), fence("bigr", AtomClass::Close, tall[0]),
    fence("Bigr", AtomClass::Close, tall[1]), fence("biggr", AtomClass::Close, tall[2]),
    fence("Biggr", AtomClass::Close, tall[3]), fence("bigm", AtomClass::Rel, tall[0]),
    fence("Bigm", AtomClass::Rel, tall[1]), fence("biggm", AtomClass::Rel, tall[2]),
    fence("Biggm", AtomClass::Rel, tall[3]),
    // Structures
    plain("frac", &readFraction), fraction("dfrac", &readFraction, Style::Display),
    fraction("tfrac", &readFraction, Style::Text), plain("cfrac", &readContinuedFraction),
    plain("binom", &readBinomial), fraction("dbinom", &readBinomial, Style::Display),
    fraction("tbinom", &readBinomial, Style::Text), plain("over", &readOver), plain("atop", &readOver),
    plain("choose", &readOver), plain("sqrt", &readRoot), plain("begin", &readEnvironment),
    plain("substack", &readSubstack), plain("boxed", &readBoxed), plain("fbox", &readBoxed),
    plain("phantom", &readPhantom), plain("vphantom", &readPhantom), plain("hphantom", &readPhantom),
    plain("smash", &readPhantom), lap("mathrlap", Align::Left), lap("rlap", Align::Left),
    lap("mathclap", Align::Center), lap("mathllap", Align::Right), lap("llap", Align::Right),
    plain("rule", &readBlock), classed("mathord", AtomClass::Ord), classed("mathop", AtomClass::Op),
    classed("mathbin", AtomClass::Bin), classed("mathrel", AtomClass::Rel),
    classed("mathopen", AtomClass::Open), classed("mathclose", AtomClass::Close),
    classed("mathpunct", AtomClass::Punct), classed("mathinner", AtomClass::Inner), plain("mark", &readMark),
    plain("color", &readColor), plain("textcolor", &readColor), plain("tag", &readTag),
    // What changes nothing here, and what has its place elsewhere
    plain("nonumber", &readNothing), plain("notag", &readNothing), plain("label", &readLabel),
    plain("displaylimits", &readNothing), plain("strut", &readStrut), plain("mathstrut", &readStrut),
    plain("limits", &readMisplaced), plain("nolimits", &readMisplaced), plain("right", &readMisplaced),
    plain("end", &readMisplaced), plain("\\", &readMisplaced), plain("cr", &readMisplaced),
    plain("hline", &readMisplaced)};

constexpr auto allCommands = byName(std::to_array(listed));

} // namespace

std::span<const Command> commands() { return allCommands; }

const Command *commandNamed(std::string_view name) {
  const auto found =
      std::lower_bound(allCommands.begin(), allCommands.end(), name,
                       [](const Command &each, std::string_view wanted) { return each.name < wanted; });
  return found != allCommands.end() && found->name == name ? &*found : nullptr;
}

} // namespace halfspace::math
