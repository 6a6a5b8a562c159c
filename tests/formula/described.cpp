#include "tests/formula/described.h"

#include "widgets/formula/latex_tokens.h"

#include <array>
#include <sstream>

namespace halfspace::math {
namespace {

std::string utf8(char32_t character) {
  if (character == 0)
    return ".";
  std::string text;
  if (isAsciiLetter(character))
    text = "upright ";
  // Mathematical italic letters, so that a test can be read.
  if (character >= 0x1D434 && character < 0x1D44E)
    character = character - 0x1D434 + U'A';
  else if (character >= 0x1D44E && character < 0x1D468)
    character = character - 0x1D44E + U'a';
  else if (character == 0x210E)
    character = U'h';
  appendUtf8(text, character);
  return text;
}

std::string call(const std::string &name, std::initializer_list<std::string> parts) {
  std::string text = name + "(";
  bool isFirst = true;
  for (const std::string &part : parts) {
    text += (isFirst ? "" : "|") + part;
    isFirst = false;
  }
  return text + ")";
}

std::string number(double value) {
  std::ostringstream stream;
  stream.precision(3);
  stream << value;
  return stream.str();
}

std::string number(Style style) { return number(static_cast<int>(style)); }

struct Describe {
  std::string operator()(const Symbol &symbol) const {
    return (symbol.isLarge ? "large " : "") + utf8(symbol.character);
  }
  std::string operator()(const Words &words) const { return "\"" + words.text + "\""; }
  std::string operator()(const Group &group) const { return "{" + described(group.row) + "}"; }
  std::string operator()(const Tagged &tagged) const {
    return call("tag", {std::get<std::string>(tagged.tag), described(tagged.row)});
  }
  std::string operator()(const Colored &colored) const {
    const Color &color = colored.color;
    return call("color", {number(color.red) + "," + number(color.green) + "," + number(color.blue),
                          described(colored.row)});
  }
  std::string operator()(const StyleSwitch &to) const { return call("style", {number(to.style)}); }
  std::string operator()(const Space &space) const { return call("space", {number(space.width)}); }
  std::string operator()(const Scripts &scripts) const {
    return call("scripts", {described(scripts.base), described(scripts.above), described(scripts.below)});
  }
  std::string operator()(const Fraction &fraction) const {
    const std::string name =
        std::string(fraction.hasBar ? "frac" : "over") + (fraction.style ? number(*fraction.style) : "");
    return call(name, {described(fraction.numerator), described(fraction.denominator)});
  }
  std::string operator()(const Root &root) const {
    return call("root", {described(root.radicand), described(root.degree)});
  }
  std::string operator()(const Fenced &fenced) const {
    return call("fenced", {utf8(fenced.open), described(fenced.row), utf8(fenced.close)});
  }
  std::string operator()(const MiddleFence &middle) const { return "middle" + utf8(middle.character); }
  std::string operator()(const TallFence &fence) const {
    return "tall" + number(fence.height) + utf8(fence.character);
  }
  std::string operator()(const Accent &accent) const {
    return call(accent.isWide ? "wide" : "accent",
                {std::to_string(static_cast<unsigned>(accent.character)), described(accent.base)});
  }
  std::string operator()(const Bar &bar) const {
    return call(bar.side == Side::Above ? "overline" : "underline", {described(bar.base)});
  }
  std::string operator()(const Brace &brace) const {
    return call("brace" + utf8(brace.character), {described(brace.base)});
  }
  std::string operator()(const Stack &stack) const {
    return call("stack", {described(stack.base), described(stack.above), described(stack.below)});
  }
  std::string operator()(const LongArrow &arrow) const {
    return call("arrow" + utf8(arrow.character), {described(arrow.above), described(arrow.below)});
  }
  std::string operator()(const Negated &negated) const { return call("not", {described(negated.base)}); }
  std::string operator()(const Boxed &boxed) const { return call("boxed", {described(boxed.row)}); }
  std::string operator()(const Phantom &phantom) const { return call("phantom", {described(phantom.row)}); }
  std::string operator()(const Block &block) const {
    return call("block", {number(block.width), number(block.height)});
  }
  std::string operator()(const Room &room) const {
    return call("room", {number(room.width), number(room.ascent), number(room.depth)});
  }
  std::string operator()(const Table &table) const {
    std::string text = "table";
    for (const TableRow &row : table.rows) {
      text += std::string("[") + std::string(static_cast<std::size_t>(row.rulesAbove), '-');
      for (std::size_t i = 0; i < row.cells.size(); ++i)
        text += (i > 0 ? " & " : "") + described(row.cells[i]);
      text += "]";
    }
    return text + std::string(static_cast<std::size_t>(table.rulesBelow), '-');
  }
};

} // namespace

std::string described(const Row &row) {
  constexpr std::array<const char *, 8> classes{"",      ":Op",    ":Bin",   ":Rel",
                                                ":Open", ":Close", ":Punct", ":Inner"};
  std::string text;
  for (const Node &node : row)
    text += (text.empty() ? "" : " ") + std::visit(Describe(), node.content) +
            classes[static_cast<std::size_t>(node.atomClass)];
  return text;
}

std::string read(std::string_view latex, const Macros &macros) {
  const auto result = readLatex(latex, macros);
  if (const auto *error = std::get_if<ReadError>(&result))
    return "error " + std::to_string(error->column) + ": " + error->sentence;
  return described(std::get<Row>(result));
}

} // namespace halfspace::math
