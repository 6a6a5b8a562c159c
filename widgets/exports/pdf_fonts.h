// The fonts of a PDF file: embedded in part, with the characters of their glyphs.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/exports/font_subset.h"
#include "widgets/exports/pdf_file.h"

#include <array>

namespace halfspace {

/// The fonts that a drawing's formulas are set in.
class PdfFonts {
public:
  /// Puts them into the file.
  PdfFonts(const Drawing &drawing, const math::MathFonts &fonts, PdfFile &file);

  /// Their names and objects, for the page's resources.
  [[nodiscard]] const std::string &resources() const { return m_resources; }
  /// /F0, as the content of the page calls it.
  [[nodiscard]] static std::string nameOf(math::FontIndex font);
  /// A glyph as it is shown: <0007>.
  [[nodiscard]] std::string codeOf(const math::PlacedGlyph &glyph) const;

private:
  void embed(math::FontIndex index, const math::FontFace &face, const std::set<math::GlyphId> &glyphs,
             PdfFile &file);

  std::array<std::map<math::GlyphId, math::GlyphId>, 2> m_glyphs; ///< by FontIndex
  std::string m_resources;
};

} // namespace halfspace
