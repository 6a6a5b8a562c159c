// The part of a font that a drawing needs, to be embedded in a file.
#pragma once

#include "widgets/formula/math_font.h"

#include <map>
#include <set>

namespace halfspace {

struct FontSubset {
  enum class Outlines { Cff, TrueType };

  std::string program; ///< a bare CFF table, or a TrueType font
  Outlines outlines = Outlines::Cff;
  std::string name;                              ///< as PostScript has it
  std::map<math::GlyphId, math::GlyphId> glyphs; ///< from the numbers in the face to those in the program
};

/// Nothing where the face cannot be taken apart.
[[nodiscard]] std::optional<FontSubset> subsetOf(const math::FontFace &face,
                                                 const std::set<math::GlyphId> &glyphs);

} // namespace halfspace
