#include "widgets/exports/pdf_fonts.h"

#include "widgets/exports/formula_outlines.h"
#include "widgets/exports/page_number.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace halfspace {
namespace {

/// Lengths of a font's glyphs are told in these parts of an em.
constexpr double partsOfEm = 1000;
/// Symbolic: no alphabet that readers know.
constexpr const char *symbolic = "4";
/// How thick stems are, as the format asks: who has the font itself does not look at it.
constexpr const char *stemWidth = "80";

std::string inParts(double em) { return std::to_string(std::lround(em * partsOfEm)); }

/// Six letters that tell parts of one font apart, as the format asks: they follow from the glyphs.
std::string prefixFor(const std::set<math::GlyphId> &glyphs) {
  std::uint64_t number = 0;
  for (const math::GlyphId glyph : glyphs)
    number = number * 31 + glyph;
  std::string letters;
  for (int i = 0; i < 6; ++i, number /= 26)
    letters += static_cast<char>('A' + number % 26);
  return letters + "+";
}

/// The glyphs of a subset in the order of its own numbers.
std::map<math::GlyphId, math::GlyphId> byCode(const FontSubset &subset) {
  std::map<math::GlyphId, math::GlyphId> glyphs;
  for (const auto &[glyph, code] : subset.glyphs)
    glyphs[code] = glyph;
  return glyphs;
}

std::string widthsOf(const FontSubset &subset, const math::FontFace &face) {
  std::string widths;
  for (const auto &[code, glyph] : byCode(subset))
    widths += std::to_string(code) + "[" + inParts(face.metrics(glyph).advance) + "]";
  return "[" + widths + "]";
}

/// What a character is copied as: the letters of a ligature.
std::string copiedDigits(char32_t character) {
  constexpr char32_t firstLigature = 0xFB00;
  constexpr std::array<std::u32string_view, 5> ligatures{U"ff", U"fi", U"fl", U"ffi", U"ffl"};
  if (character < firstLigature || character >= firstLigature + ligatures.size())
    return utf16Digits(character);
  std::string digits;
  for (const char32_t letter : ligatures.at(character - firstLigature))
    digits += utf16Digits(letter);
  return digits;
}

/// Which characters stand for the glyphs, in the language that the format has for it.
std::string characterMap(const FontSubset &subset, const math::FontFace &face) {
  const GlyphCharacters characters(face);
  constexpr int mostInABlock = 100; // that the format allows
  std::string map =
      "/CIDInit/ProcSet findresource begin 12 dict begin begincmap/CIDSystemInfo<</Registry(Adobe)/"
      "Ordering(UCS)/Supplement 0>>def/CMapName/Adobe-Identity-UCS def/CMapType 2 def 1 "
      "begincodespacerange<0000><FFFF>endcodespacerange\n";
  std::string block;
  int inBlock = 0;
  const auto endBlock = [&] {
    if (inBlock > 0)
      map += std::to_string(inBlock) + " beginbfchar\n" + block + "endbfchar\n";
    block.clear();
    inBlock = 0;
  };
  for (const auto &[code, glyph] : byCode(subset))
    if (const auto character = characters.characterOf(glyph)) {
      block += "<" + hexDigits(code, 4) + "><" + copiedDigits(*character) + ">\n";
      if (++inBlock == mostInABlock)
        endBlock();
    }
  endBlock();
  return map + "endcmap CMapName currentdict/CMap defineresource pop end end";
}

std::string fontName(std::size_t index) { return "/F" + std::to_string(index); }

/// The box around all glyphs of the subset, and how high they reach.
std::string descriptorOf(const FontSubset &subset, const math::FontFace &face, const std::string &name,
                         const std::string &program) {
  double left = 0;
  double right = 0;
  double height = 0;
  double depth = 0;
  for (const auto &[glyph, code] : subset.glyphs) {
    const math::GlyphMetrics &metrics = face.metrics(glyph);
    left = std::min(left, metrics.left);
    right = std::max(right, metrics.left + metrics.width);
    height = std::max(height, metrics.height);
    depth = std::max(depth, metrics.depth);
  }
  return "<</Type/FontDescriptor/FontName/" + name + "/Flags " + symbolic + "/FontBBox[" + inParts(left) +
         " " + inParts(-depth) + " " + inParts(right) + " " + inParts(height) + "]/ItalicAngle 0/Ascent " +
         inParts(height) + "/Descent " + inParts(-depth) + "/CapHeight " + inParts(height) + "/StemV " +
         stemWidth + program + ">>";
}

} // namespace

std::size_t PdfFonts::indexOf(const math::FontFace &face) const {
  const auto known =
      std::find_if(m_faces.begin(), m_faces.end(), [&](const UsedFace &used) { return used.face == &face; });
  return static_cast<std::size_t>(known - m_faces.begin());
}

void PdfFonts::use(const math::FontFace &face, math::GlyphId glyph) {
  const std::size_t index = indexOf(face);
  if (index == m_faces.size())
    m_faces.push_back({&face});
  m_faces[index].glyphs.insert(glyph);
}

void PdfFonts::use(const math::Layout &formula, const math::MathFonts &fonts) {
  for (const math::PlacedGlyph &glyph : formula.glyphs)
    use(fonts.face(glyph.font), glyph.glyph);
}

void PdfFonts::use(const Drawing &drawing, const math::MathFonts &fonts) {
  for (const DrawingPart &part : drawing.parts)
    if (const auto *formula = std::get_if<FormulaPart>(&part))
      use(*formula->formula, fonts);
}

void PdfFonts::embed(PdfFile &file) {
  for (std::size_t i = 0; i < m_faces.size(); ++i)
    embed(i, file);
}

std::string PdfFonts::nameOf(const math::FontFace &face) const { return fontName(indexOf(face)); }

std::string PdfFonts::codeOf(const math::FontFace &face, math::GlyphId glyph) const {
  constexpr int digits = 4;
  const std::size_t index = indexOf(face);
  if (index == m_faces.size())
    return hexDigits(0, digits);
  const auto &codes = m_faces[index].codes;
  const auto known = codes.find(glyph);
  return hexDigits(known != codes.end() ? known->second : 0, digits);
}

void PdfFonts::embed(std::size_t index, PdfFile &file) {
  UsedFace &used = m_faces[index];
  const math::FontFace &face = *used.face;
  const auto subset = subsetOf(face, used.glyphs);
  if (!subset)
    return;
  const bool isCff = subset->outlines == FontSubset::Outlines::Cff;
  const std::string name = prefixFor(used.glyphs) + subset->name;
  const int program =
      file.addStream(subset->program,
                     isCff ? "/Subtype/CIDFontType0C" : "/Length1 " + std::to_string(subset->program.size()));
  const int descriptor = file.add(
      descriptorOf(*subset, face, name, (isCff ? "/FontFile3 " : "/FontFile2 ") + pdfReference(program)));
  const int descendant =
      file.add(std::string("<</Type/Font/Subtype/") +
               (isCff ? "CIDFontType0" : "CIDFontType2/CIDToGIDMap/Identity") + "/BaseFont/" + name +
               "/CIDSystemInfo<</Registry(Adobe)/Ordering(Identity)/Supplement 0>>/FontDescriptor " +
               pdfReference(descriptor) + "/DW 0/W" + widthsOf(*subset, face) + ">>");
  const int characters = file.addStream(characterMap(*subset, face));
  const int font =
      file.add("<</Type/Font/Subtype/Type0/BaseFont/" + name + "/Encoding/Identity-H/DescendantFonts[" +
               pdfReference(descendant) + "]/ToUnicode " + pdfReference(characters) + ">>");
  m_resources += fontName(index) + " " + pdfReference(font);
  used.codes = subset->glyphs;
}

} // namespace halfspace
