#include "widgets/formula/latex_symbols.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace halfspace::math {
namespace {

constexpr SymbolCommand ord(std::string_view name, char32_t character) {
  return {name, character, AtomClass::Ord};
}
constexpr SymbolCommand bin(std::string_view name, char32_t character) {
  return {name, character, AtomClass::Bin};
}
constexpr SymbolCommand rel(std::string_view name, char32_t character) {
  return {name, character, AtomClass::Rel};
}
constexpr SymbolCommand open(std::string_view name, char32_t character) {
  return {name, character, AtomClass::Open};
}
constexpr SymbolCommand close(std::string_view name, char32_t character) {
  return {name, character, AtomClass::Close};
}

constexpr auto byName(auto commands) {
  std::sort(commands.begin(), commands.end(), [](const auto &a, const auto &b) { return a.name < b.name; });
  return commands;
}

/// Several names of one character stand in the order in which the first says the character's class when
/// typed.
constexpr SymbolCommand listed[]{
    // Greek capitals that lessons/term/greek.h does not have
    ord("Xi", U'Ξ'), ord("Upsilon", U'Υ'), ord("varGamma", 0x1D6E4), ord("varDelta", 0x1D6E5),
    ord("varTheta", 0x1D6E9), ord("varLambda", 0x1D6EC), ord("varXi", 0x1D6EF), ord("varPi", 0x1D6F1),
    ord("varSigma", 0x1D6F4), ord("varPhi", 0x1D6F7), ord("varPsi", 0x1D6F9), ord("varOmega", 0x1D6FA),
    // Letters and signs
    ord("imath", 0x1D6A4), ord("jmath", 0x1D6A5), ord("ell", U'ℓ'), ord("hbar", U'ℏ'), ord("Re", U'ℜ'),
    ord("Im", U'ℑ'), ord("aleph", U'ℵ'), ord("beth", U'ℶ'), ord("wp", U'℘'), ord("partial", 0x1D715),
    ord("nabla", U'∇'), ord("emptyset", U'∅'), ord("varnothing", U'∅'), ord("forall", U'∀'),
    ord("exists", U'∃'), ord("nexists", U'∄'), ord("neg", U'¬'), ord("lnot", U'¬'), ord("complement", U'∁'),
    ord("angle", U'∠'), ord("measuredangle", U'∡'), ord("sphericalangle", U'∢'), ord("triangle", U'△'),
    ord("square", U'□'), ord("Box", U'□'), ord("blacksquare", U'■'), ord("blacktriangle", U'▲'),
    ord("Diamond", U'◊'), ord("lozenge", U'◊'), ord("degree", U'°'), ord("prime", U'′'), ord("top", U'⊤'),
    ord("bot", U'⊥'), ord("surd", U'√'), ord("vdots", U'⋮'), ord("checkmark", U'✓'), ord("dag", U'†'),
    ord("S", U'§'), ord("P", U'¶'), ord("pounds", U'£'), ord("copyright", U'©'), ord("flat", U'♭'),
    ord("natural", U'♮'), ord("sharp", U'♯'), ord("clubsuit", U'♣'), ord("diamondsuit", U'♢'),
    ord("heartsuit", U'♡'), ord("spadesuit", U'♠'), ord("%", U'%'), ord("$", U'$'), ord("#", U'#'),
    ord("&", U'&'), ord("_", U'_'),
    // Operations
    bin("cdot", U'⋅'), bin("times", U'×'), bin("pm", U'±'), bin("mp", U'∓'), bin("div", U'÷'),
    bin("ast", U'∗'), bin("star", U'⋆'), bin("circ", U'∘'), bin("bullet", U'∙'), bin("oplus", U'⊕'),
    bin("ominus", U'⊖'), bin("otimes", U'⊗'), bin("oslash", U'⊘'), bin("odot", U'⊙'), bin("wedge", U'∧'),
    bin("land", U'∧'), bin("vee", U'∨'), bin("lor", U'∨'), bin("cap", U'∩'), bin("cup", U'∪'),
    bin("sqcap", U'⊓'), bin("sqcup", U'⊔'), bin("uplus", U'⊎'), bin("setminus", U'∖'),
    bin("smallsetminus", U'∖'), bin("ltimes", U'⋉'), bin("rtimes", U'⋊'), bin("dagger", U'†'),
    bin("ddagger", U'‡'), bin("amalg", U'⨿'), bin("wr", U'≀'), bin("diamond", U'⋄'),
    bin("bigtriangleup", U'△'), bin("boxplus", U'⊞'), bin("boxtimes", U'⊠'), bin("barwedge", U'⊼'),
    bin("veebar", U'⊻'), bin("dotplus", U'∔'), bin("intercal", U'⊺'),
    // Relations
    rel("approx", U'≈'), rel("leq", U'≤'), rel("le", U'≤'), rel("leqslant", U'⩽'), rel("geq", U'≥'),
    rel("ge", U'≥'), rel("geqslant", U'⩾'), rel("leqq", U'≦'), rel("geqq", U'≧'), rel("neq", U'≠'),
    rel("ne", U'≠'), rel("equiv", U'≡'), rel("sim", U'∼'), rel("simeq", U'≃'), rel("cong", U'≅'),
    rel("ncong", U'≇'), rel("nsim", U'≁'), rel("approxeq", U'≊'), rel("asymp", U'≍'), rel("propto", U'∝'),
    rel("varpropto", U'∝'), rel("ll", U'≪'), rel("gg", U'≫'), rel("lesssim", U'≲'), rel("gtrsim", U'≳'),
    rel("nless", U'≮'), rel("ngtr", U'≯'), rel("nleq", U'≰'), rel("ngeq", U'≱'), rel("in", U'∈'),
    rel("notin", U'∉'), rel("ni", U'∋'), rel("owns", U'∋'), rel("subset", U'⊂'), rel("subseteq", U'⊆'),
    rel("subsetneq", U'⊊'), rel("nsubseteq", U'⊈'), rel("supset", U'⊃'), rel("supseteq", U'⊇'),
    rel("supsetneq", U'⊋'), rel("sqsubseteq", U'⊑'), rel("sqsupseteq", U'⊒'), rel("perp", U'⟂'),
    rel("parallel", U'∥'), rel("nparallel", U'∦'), rel("mid", U'∣'), rel("nmid", U'∤'), rel("coloneqq", U'≔'),
    rel("coloneq", U'≔'), rel("eqqcolon", U'≕'), rel("triangleq", U'≜'), rel("doteq", U'≐'),
    rel("prec", U'≺'), rel("preceq", U'⪯'), rel("succ", U'≻'), rel("succeq", U'⪰'), rel("models", U'⊨'),
    rel("vDash", U'⊨'), rel("vdash", U'⊢'), rel("dashv", U'⊣'), rel("Vdash", U'⊩'), rel("lt", U'<'),
    rel("gt", U'>'), rel("triangleleft", U'⊲'), rel("triangleright", U'⊳'), rel("trianglelefteq", U'⊴'),
    rel("trianglerighteq", U'⊵'), rel("gtrless", U'≷'), rel("lessgtr", U'≶'), rel("smile", U'⌣'),
    rel("frown", U'⌢'), rel("upharpoonright", U'↾'), rel("restriction", U'↾'), rel("bowtie", U'⋈'),
    rel("therefore", U'∴'), rel("because", U'∵'), rel("vcentcolon", U':'),
    // Arrows
    rel("to", U'→'), rel("rightarrow", U'→'), rel("leftarrow", U'←'), rel("gets", U'←'),
    rel("leftrightarrow", U'↔'), rel("Rightarrow", U'⇒'), rel("Leftarrow", U'⇐'), rel("Leftrightarrow", U'⇔'),
    rel("longrightarrow", U'⟶'), rel("longleftarrow", U'⟵'), rel("longleftrightarrow", U'⟷'),
    rel("Longrightarrow", U'⟹'), rel("implies", U'⟹'), rel("Longleftarrow", U'⟸'), rel("impliedby", U'⟸'),
    rel("Longleftrightarrow", U'⟺'), rel("iff", U'⟺'), rel("mapsto", U'↦'), rel("longmapsto", U'⟼'),
    rel("hookrightarrow", U'↪'), rel("hookleftarrow", U'↩'), rel("twoheadrightarrow", U'↠'),
    rel("rightarrowtail", U'↣'), rel("rightharpoonup", U'⇀'), rel("rightharpoondown", U'⇁'),
    rel("leftharpoonup", U'↼'), rel("leftharpoondown", U'↽'), rel("rightleftharpoons", U'⇌'),
    rel("leftrightharpoons", U'⇋'), rel("rightrightarrows", U'⇉'), rel("leadsto", U'⇝'),
    rel("rightsquigarrow", U'⇝'), rel("nrightarrow", U'↛'), rel("nleftarrow", U'↚'), rel("nRightarrow", U'⇏'),
    rel("uparrow", U'↑'), rel("downarrow", U'↓'), rel("updownarrow", U'↕'), rel("Uparrow", U'⇑'),
    rel("Downarrow", U'⇓'), rel("Updownarrow", U'⇕'), rel("nearrow", U'↗'), rel("searrow", U'↘'),
    rel("swarrow", U'↙'), rel("nwarrow", U'↖'), rel("circlearrowleft", U'↺'), rel("circlearrowright", U'↻'),
    rel("curvearrowleft", U'↶'), rel("curvearrowright", U'↷'),
    // Punctuation and fences
    SymbolCommand{"colon", U':', AtomClass::Punct}, SymbolCommand{"ldotp", U'.', AtomClass::Punct},
    SymbolCommand{"cdotp", U'⋅', AtomClass::Punct}, open("{", U'{'), close("}", U'}'), open("lbrace", U'{'),
    close("rbrace", U'}'), open("lbrack", U'['), close("rbrack", U']'), open("lparen", U'('),
    close("rparen", U')'), open("lvert", U'|'), close("rvert", U'|'), open("lVert", U'‖'),
    close("rVert", U'‖'), ord("|", U'‖'), ord("vert", U'|'), ord("Vert", U'‖'), open("langle", U'⟨'),
    close("rangle", U'⟩'), open("lfloor", U'⌊'), close("rfloor", U'⌋'), open("lceil", U'⌈'),
    close("rceil", U'⌉'), open("llbracket", U'⟦'), close("rrbracket", U'⟧'), open("lgroup", U'⟮'),
    close("rgroup", U'⟯'), ord("backslash", U'\\')};

constexpr auto named = byName(std::to_array(listed));

/// Characters whose meaning no command says, or another one when they are typed.
constexpr std::array<std::pair<char32_t, TypedSymbol>, 29> typed{{
    {U'+', {U'+', AtomClass::Bin}},
    {U'-', {U'−', AtomClass::Bin}},
    {U'−', {U'−', AtomClass::Bin}},
    {U'*', {U'∗', AtomClass::Bin}},
    {U'·', {U'⋅', AtomClass::Bin}},
    {U'∙', {U'⋅', AtomClass::Bin}},
    {U'=', {U'=', AtomClass::Rel}},
    {U'<', {U'<', AtomClass::Rel}},
    {U'>', {U'>', AtomClass::Rel}},
    {U':', {U':', AtomClass::Rel}},
    {U'(', {U'(', AtomClass::Open}},
    {U'[', {U'[', AtomClass::Open}},
    {U')', {U')', AtomClass::Close}},
    {U']', {U']', AtomClass::Close}},
    {U'!', {U'!', AtomClass::Close}},
    {U'?', {U'?', AtomClass::Close}},
    {U',', {U',', AtomClass::Punct}},
    {U';', {U';', AtomClass::Punct}},
    {U'∂', {0x1D715}},
    {U'⊥', {U'⊥', AtomClass::Rel}},
    {U'‖', {U'‖'}},
    {U'|', {U'|'}},
    {U'⌊', {U'⌊', AtomClass::Open}},
    {U'…', {U'…', AtomClass::Inner}},
    {U'⋯', {U'⋯', AtomClass::Inner}},
    {U'△', {U'△'}},
    {U'\\', {U'\\'}},
    {U'†', {U'†', AtomClass::Bin}},
    {U'∖', {U'∖', AtomClass::Bin}},
}};

constexpr std::u32string_view scriptsAbove = U"⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿⁱᵀ";
constexpr std::u32string_view plainAbove = U"0123456789+−=()niT";
constexpr std::u32string_view scriptsBelow = U"₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₒₓₕₖₗₘₙₚₛₜᵢⱼᵣᵤᵥ";
constexpr std::u32string_view plainBelow = U"0123456789+−=()aeoxhklmnpstijruv";
static_assert(scriptsAbove.size() == plainAbove.size() && scriptsBelow.size() == plainBelow.size());

constexpr std::u32string_view fences = U"()[]{}|/\\‖⟨⟩⌈⌉⌊⌋⟦⟧⟮⟯↑↓↕⇑⇓⇕";

constexpr std::array<std::pair<char32_t, char32_t>, 22> negations{
    {{U'=', U'≠'}, {U'∈', U'∉'}, {U'∋', U'∌'}, {U'∥', U'∦'}, {U'∣', U'∤'}, {U'≡', U'≢'},
     {U'∼', U'≁'}, {U'≃', U'≄'}, {U'≅', U'≇'}, {U'≈', U'≉'}, {U'<', U'≮'}, {U'>', U'≯'},
     {U'≤', U'≰'}, {U'≥', U'≱'}, {U'⊂', U'⊄'}, {U'⊃', U'⊅'}, {U'⊆', U'⊈'}, {U'⊇', U'⊉'},
     {U'∃', U'∄'}, {U'→', U'↛'}, {U'⇒', U'⇏'}, {U'⇔', U'⇎'}}};

} // namespace

std::span<const SymbolCommand> symbolCommands() { return named; }

const SymbolCommand *symbolNamed(std::string_view name) {
  const auto found =
      std::lower_bound(named.begin(), named.end(), name,
                       [](const SymbolCommand &each, std::string_view wanted) { return each.name < wanted; });
  return found != named.end() && found->name == name ? &*found : nullptr;
}

TypedSymbol typedSymbol(char32_t character) {
  const auto own = std::find_if(typed.begin(), typed.end(),
                                [character](const auto &each) { return each.first == character; });
  if (own != typed.end())
    return own->second;
  // Letters and digits have no command.
  if (character < 0x80)
    return {character};
  const auto command =
      std::find_if(std::begin(listed), std::end(listed),
                   [character](const SymbolCommand &each) { return each.character == character; });
  return {character, command == std::end(listed) ? AtomClass::Ord : command->atomClass};
}

std::optional<TypedScript> typedScript(char32_t character) {
  if (character < 0x80)
    return std::nullopt;
  if (const auto at = scriptsAbove.find(character); at != std::u32string_view::npos)
    return TypedScript{plainAbove[at], true};
  if (const auto at = scriptsBelow.find(character); at != std::u32string_view::npos)
    return TypedScript{plainBelow[at], false};
  return std::nullopt;
}

bool isFence(char32_t character) { return fences.find(character) != std::u32string_view::npos; }

char32_t negated(char32_t character) {
  const auto found = std::find_if(negations.begin(), negations.end(),
                                  [character](const auto &pair) { return pair.first == character; });
  return found == negations.end() ? 0 : found->second;
}

} // namespace halfspace::math
