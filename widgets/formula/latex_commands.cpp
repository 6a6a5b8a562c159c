#include "widgets/formula/latex_commands.h"

#include "widgets/formula/latex_reader.h"

#include <algorithm>
#include <array>

namespace halfspace::math {
namespace {

using Reader = LatexReader;

/// TeX's unit of spaces in mathematics.
constexpr double mu = 1.0 / 18;
constexpr double wordSpace = 1.0 / 3;
/// How tall \big, \Big, \bigg and \Bigg are at least. LaTeX's are 1.2, 1.8, 2.4 and 3 em; fonts' differ by a
/// hair.
constexpr std::array<double, 4> tall{1.19, 1.79, 2.39, 2.98};

constexpr Command letter(std::string_view name, char32_t character) {
  return {.name = name, .read = &Reader::readLetter, .character = character};
}
constexpr Command large(std::string_view name, char32_t character,
                        ScriptPlace scriptPlace = ScriptPlace::LimitsInDisplay) {
  return {.name = name,
          .read = &Reader::readLargeOperator,
          .character = character,
          .atomClass = AtomClass::Op,
          .scriptPlace = scriptPlace};
}
constexpr Command integral(std::string_view name, char32_t character) {
  return large(name, character, ScriptPlace::Beside);
}
constexpr Command named(std::string_view name, std::string_view text = {}) {
  return {.name = name, .read = &Reader::readFunction, .atomClass = AtomClass::Op, .text = text};
}
constexpr Command limit(std::string_view name, std::string_view text = {}) {
  Command command = named(name, text);
  command.scriptPlace = ScriptPlace::LimitsInDisplay;
  return command;
}
constexpr Command accented(std::string_view name, char32_t character) {
  return {.name = name, .read = &Reader::readAccent, .character = character};
}
constexpr Command wide(std::string_view name, char32_t character) {
  return {.name = name, .read = &Reader::readWideAccent, .character = character};
}
constexpr Command braced(std::string_view name, char32_t character, Side side) {
  return {.name = name, .read = &Reader::readBrace, .character = character, .side = side};
}
constexpr Command arrow(std::string_view name, char32_t character) {
  return {.name = name, .read = &Reader::readArrow, .character = character};
}
constexpr Command alphabet(std::string_view name, Alphabet alphabet) {
  return {.name = name, .read = &Reader::readAlphabet, .alphabet = alphabet};
}
constexpr Command alphabetSwitch(std::string_view name, Alphabet alphabet) {
  return {.name = name, .read = &Reader::readAlphabetSwitch, .alphabet = alphabet};
}
constexpr Command text(std::string_view name, Alphabet alphabet) {
  return {.name = name, .read = &Reader::readText, .alphabet = alphabet};
}
constexpr Command space(std::string_view name, double em) {
  return {.name = name, .read = &Reader::readSpace, .amount = em};
}
constexpr Command styled(std::string_view name, Style style) {
  return {.name = name, .read = &Reader::readStyle, .style = style};
}
constexpr Command fence(std::string_view name, AtomClass atomClass, double height) {
  return {.name = name, .read = &Reader::readTallFence, .amount = height, .atomClass = atomClass};
}
constexpr Command classed(std::string_view name, AtomClass atomClass) {
  return {.name = name,
          .read = &Reader::readClass,
          .atomClass = atomClass,
          .scriptPlace = atomClass == AtomClass::Op ? ScriptPlace::LimitsInDisplay : ScriptPlace::Beside};
}
constexpr Command lap(std::string_view name, Align align) {
  return {.name = name, .read = &Reader::readLap, .align = align};
}
constexpr Command plain(std::string_view name, void (Reader::*read)(Row &, const Command &)) {
  return {.name = name, .read = read};
}
constexpr Command fraction(std::string_view name, void (Reader::*read)(Row &, const Command &), Style style) {
  return {.name = name, .read = read, .style = style};
}

constexpr auto byName(auto commands) {
  std::sort(commands.begin(), commands.end(), [](const auto &a, const auto &b) { return a.name < b.name; });
  return commands;
}

constexpr Command listed[]{
    // Small Greek letters
    letter("alpha", U'α'), letter("beta", U'β'), letter("gamma", U'γ'), letter("delta", U'δ'),
    letter("epsilon", U'ϵ'), letter("varepsilon", U'ε'), letter("zeta", U'ζ'), letter("eta", U'η'),
    letter("theta", U'θ'), letter("vartheta", U'ϑ'), letter("iota", U'ι'), letter("kappa", U'κ'),
    letter("varkappa", U'ϰ'), letter("lambda", U'λ'), letter("mu", U'μ'), letter("nu", U'ν'),
    letter("xi", U'ξ'), letter("omicron", U'ο'), letter("pi", U'π'), letter("varpi", U'ϖ'),
    letter("rho", U'ρ'), letter("varrho", U'ϱ'), letter("sigma", U'σ'), letter("varsigma", U'ς'),
    letter("tau", U'τ'), letter("upsilon", U'υ'), letter("phi", U'ϕ'), letter("varphi", U'φ'),
    letter("chi", U'χ'), letter("psi", U'ψ'), letter("omega", U'ω'),
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
    Command{.name = "bmod", .read = &Reader::readFunction, .atomClass = AtomClass::Bin, .text = "mod"},
    plain("operatorname", &Reader::readOperatorName), plain("pmod", &Reader::readModulo),
    // Dots
    Command{.name = "ldots", .read = &Reader::readDots, .character = U'.'},
    Command{.name = "dotsc", .read = &Reader::readDots, .character = U'.'},
    Command{.name = "cdots", .read = &Reader::readDots, .character = U'⋅'},
    Command{.name = "dotsb", .read = &Reader::readDots, .character = U'⋅'},
    Command{.name = "dotsm", .read = &Reader::readDots, .character = U'⋅'},
    Command{.name = "dotsi", .read = &Reader::readDots, .character = U'⋅'},
    Command{.name = "dotso", .read = &Reader::readDots, .character = U'.'}, plain("dots", &Reader::readDots),
    plain("ddots", &Reader::readDiagonalDots),
    // Accents, bars, braces, what stands above and below
    accented("vec", 0x20D7), accented("hat", 0x302), accented("bar", 0x304), accented("tilde", 0x303),
    accented("dot", 0x307), accented("ddot", 0x308), accented("dddot", 0x20DB), accented("check", 0x30C),
    accented("breve", 0x306), accented("acute", 0x301), accented("grave", 0x300), accented("mathring", 0x30A),
    wide("widehat", 0x302), wide("widetilde", 0x303), wide("widecheck", 0x30C),
    wide("overrightarrow", 0x20D7), wide("overleftarrow", 0x20D6), wide("overleftrightarrow", 0x20E1),
    Command{.name = "overline", .read = &Reader::readBar},
    Command{.name = "underline", .read = &Reader::readBar, .side = Side::Below},
    braced("overbrace", U'⏞', Side::Above), braced("underbrace", U'⏟', Side::Below),
    braced("overbracket", U'⎴', Side::Above), braced("underbracket", U'⎵', Side::Below),
    braced("overparen", U'⏜', Side::Above), braced("underparen", U'⏝', Side::Below),
    Command{.name = "overset", .read = &Reader::readStack},
    Command{.name = "underset", .read = &Reader::readStack, .side = Side::Below},
    Command{.name = "stackrel", .read = &Reader::readStack, .atomClass = AtomClass::Rel},
    arrow("xrightarrow", U'→'), arrow("xleftarrow", U'←'), arrow("xleftrightarrow", U'↔'),
    arrow("xRightarrow", U'⇒'), arrow("xLeftarrow", U'⇐'), arrow("xLeftrightarrow", U'⇔'),
    arrow("xmapsto", U'↦'), plain("not", &Reader::readNot),
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
    space("qquad", 2), plain("hspace", &Reader::readGivenSpace), plain("mspace", &Reader::readGivenSpace),
    plain("kern", &Reader::readKern), plain("mkern", &Reader::readKern), plain("hskip", &Reader::readKern),
    plain("mskip", &Reader::readKern), styled("displaystyle", Style::Display),
    styled("textstyle", Style::Text), styled("scriptstyle", Style::Script),
    styled("scriptscriptstyle", Style::ScriptScript),
    // Fences
    plain("left", &Reader::readFenced), plain("middle", &Reader::readMiddle),
    fence("big", AtomClass::Ord, tall[0]), fence("Big", AtomClass::Ord, tall[1]),
    fence("bigg", AtomClass::Ord, tall[2]), fence("Bigg", AtomClass::Ord, tall[3]),
    fence("bigl", AtomClass::Open, tall[0]), fence("Bigl", AtomClass::Open, tall[1]),
    fence("biggl", AtomClass::Open, tall[2]), fence("Biggl", AtomClass::Open, tall[3]),
    fence("bigr", AtomClass::Close, tall[0]), fence("Bigr", AtomClass::Close, tall[1]),
    fence("biggr", AtomClass::Close, tall[2]), fence("Biggr", AtomClass::Close, tall[3]),
    fence("bigm", AtomClass::Rel, tall[0]), fence("Bigm", AtomClass::Rel, tall[1]),
    fence("biggm", AtomClass::Rel, tall[2]), fence("Biggm", AtomClass::Rel, tall[3]),
    // Structures
    plain("frac", &Reader::readFraction), fraction("dfrac", &Reader::readFraction, Style::Display),
    fraction("tfrac", &Reader::readFraction, Style::Text), plain("cfrac", &Reader::readContinuedFraction),
    plain("binom", &Reader::readBinomial), fraction("dbinom", &Reader::readBinomial, Style::Display),
    fraction("tbinom", &Reader::readBinomial, Style::Text), plain("over", &Reader::readOver),
    plain("atop", &Reader::readOver), plain("choose", &Reader::readOver), plain("sqrt", &Reader::readRoot),
    plain("begin", &Reader::readEnvironment), plain("substack", &Reader::readSubstack),
    plain("boxed", &Reader::readBoxed), plain("fbox", &Reader::readBoxed),
    plain("phantom", &Reader::readPhantom), plain("vphantom", &Reader::readPhantom),
    plain("hphantom", &Reader::readPhantom), plain("smash", &Reader::readPhantom),
    lap("mathrlap", Align::Left), lap("rlap", Align::Left), lap("mathclap", Align::Center),
    lap("mathllap", Align::Right), lap("llap", Align::Right), plain("rule", &Reader::readBlock),
    classed("mathord", AtomClass::Ord), classed("mathop", AtomClass::Op), classed("mathbin", AtomClass::Bin),
    classed("mathrel", AtomClass::Rel), classed("mathopen", AtomClass::Open),
    classed("mathclose", AtomClass::Close), classed("mathpunct", AtomClass::Punct),
    classed("mathinner", AtomClass::Inner), plain("mark", &Reader::readMark),
    plain("color", &Reader::readColor), plain("textcolor", &Reader::readColor),
    plain("tag", &Reader::readTag),
    // What changes nothing here, and what has its place elsewhere
    plain("nonumber", &Reader::readNothing), plain("notag", &Reader::readNothing),
    plain("label", &Reader::readLabel), plain("displaylimits", &Reader::readNothing),
    plain("strut", &Reader::readStrut), plain("mathstrut", &Reader::readStrut),
    plain("limits", &Reader::readMisplaced), plain("nolimits", &Reader::readMisplaced),
    plain("right", &Reader::readMisplaced), plain("end", &Reader::readMisplaced),
    plain("\\", &Reader::readMisplaced), plain("cr", &Reader::readMisplaced),
    plain("hline", &Reader::readMisplaced)};

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
