// The fonts of a PDF file: embedded in part, with the characters of their glyphs.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/exports/font_subset.h"
#include "widgets/exports/pdf_file.h"

#include <vector>

namespace halfspace {

/// Faces that a file shows glyphs of: all glyphs are told first, then the faces are embedded, and after that
/// the glyphs have codes. The faces must outlive it.
class PdfFonts {
public:
  /// The file will show a glyph.
  void use(const math::FontFace &face, math::GlyphId glyph);
  /// It will show those of a formula.
  void use(const math::Layout &formula, const math::MathFonts &fonts);
  /// It will show those of a drawing's formulas.
  void use(const Drawing &drawing, const math::MathFonts &fonts);

  /// Puts the parts of the faces that are used into the file.
  void embed(PdfFile &file);

  /// Their names and objects, for the resources of pages.
  [[nodiscard]] const std::string &resources() const { return m_resources; }
  /// /F0, as the content of pages calls a face that is used.
  [[nodiscard]] std::string nameOf(const math::FontFace &face) const;
  /// A glyph as it is shown, in hexadecimal digits: 0007. That of a glyph which is not used is 0000.
  [[nodiscard]] std::string codeOf(const math::FontFace &face, math::GlyphId glyph) const;

private:
  struct UsedFace {
    const math::FontFace *face;
    std::set<math::GlyphId> glyphs{};
    std::map<math::GlyphId, math::GlyphId> codes{};
  };

  [[nodiscard]] std::size_t indexOf(const math::FontFace &face) const;
  void embed(std::size_t index, PdfFile &file);

  std::vector<UsedFace> m_faces; ///< in the order in which they were told
  std::string m_resources;
};

} // namespace halfspace
