// Whatever the bytes: a formula that can be laid out and broken, or an error with a column and a sentence.
#include "widgets/formula/break_lines.h"
#include "widgets/formula/lay_out.h"
#include "widgets/formula/read_latex.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

using namespace halfspace::math;

/// What random bytes seldom put together: control characters stand for these.
constexpr std::array<std::string_view, 32> scraps{"\\frac",
                                                  "\\left(",
                                                  "\\right)",
                                                  "\\begin{matrix}",
                                                  "\\end{matrix}",
                                                  "\\sqrt[",
                                                  "\\text{",
                                                  "$",
                                                  "\\mark{a}",
                                                  "\\A",
                                                  "\\B",
                                                  "\\middle|",
                                                  "\\\\",
                                                  "&",
                                                  "\\hline",
                                                  "\\over",
                                                  "^{",
                                                  "_{",
                                                  "'",
                                                  "\\vec",
                                                  "\\color{red}",
                                                  "\\not",
                                                  "\\underbrace{",
                                                  "\\limits",
                                                  "\\sum",
                                                  "{",
                                                  "}",
                                                  "\\substack{",
                                                  "\\begin{array}{c|c}",
                                                  "\\end{array}",
                                                  "\\kern1em",
                                                  "\\big"};

std::string withScraps(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes)
    if (const auto index = static_cast<unsigned char>(byte); index < scraps.size() && byte != '\n')
      text += scraps[index];
    else
      text += byte;
  return text;
}

void require(bool holds) {
  if (!holds)
    std::abort();
}

void requireFinite(const Layout &layout) {
  require(std::isfinite(layout.width) && std::isfinite(layout.ascent) && std::isfinite(layout.depth));
  for (const PlacedGlyph &glyph : layout.glyphs)
    require(std::isfinite(glyph.x) && std::isfinite(glyph.y) && glyph.size > 0 &&
            glyph.ink.tag < static_cast<int>(layout.tags.size()));
  for (const Rule &rule : layout.rules)
    require(std::isfinite(rule.box.x) && std::isfinite(rule.box.y) && rule.box.height >= 0);
  for (const TagBox &tagBox : layout.tagBoxes)
    require(std::isfinite(tagBox.box.x) && std::isfinite(tagBox.box.height));
}

/// All lines but the last are macros' bodies.
void readAndLayOut(std::string_view text) {
  static const auto fonts = readMathFonts(MATH_FONT, TEXT_FONT);
  Macros macros;
  for (char name = 'A'; name <= 'Z' && text.find('\n') != std::string_view::npos; ++name) {
    macros[std::string(1, name)] = {(name - 'A') % 3, std::string(text.substr(0, text.find('\n')))};
    text.remove_prefix(text.find('\n') + 1);
  }
  const auto result = readLatex(text, macros);
  if (const auto *error = std::get_if<ReadError>(&result)) {
    require(error->column >= 1 && error->column <= text.size() + 1 && !error->sentence.empty());
    return;
  }
  for (const Style style : {Style::Display, Style::Text}) {
    const Layout whole = layOut(std::get<Row>(result), fonts.value(), style);
    requireFinite(whole);
    LineRules rules;
    rules.width = whole.width / 3;
    const Layout broken = breakLines(whole, rules);
    requireFinite(broken);
    require(broken.glyphs.size() == whole.glyphs.size() && broken.rules.size() == whole.rules.size());
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char *>(data), size);
  readAndLayOut(bytes);
  readAndLayOut(withScraps(bytes));
  return 0;
}
