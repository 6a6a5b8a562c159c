#include "widgets/formula/lay_out.h"

#include "widgets/formula/set.h"

namespace halfspace::math {

Layout layOut(const Row &formula, const MathFonts &fonts, Style style) {
  Sheet sheet(fonts);
  const Box box = setRow(sheet, formula, {style}, {.isOutermost = true});
  Layout layout = std::move(sheet.layout());
  layout.width = box.fullWidth();
  layout.ascent = box.ascent;
  layout.depth = box.depth;
  layout.lines = {{0, 0, layout.width, layout.ascent, layout.depth}};
  return layout;
}

} // namespace halfspace::math
