// What is painted on a page of a PDF file.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/exports/pdf_fonts.h"

#include <map>
#include <set>
#include <utility>

namespace halfspace {

/// Words in one face and size on one baseline.
struct TextPart {
  struct Glyph {
    math::GlyphId glyph = 0;
    double x = 0; ///< from the start, in points; they go from left to right
  };

  const math::FontFace *face = nullptr; ///< never null where it is written
  double size = 0;                      ///< of its type: the length of an em
  std::vector<Glyph> glyphs{};
  glm::dvec2 start{}; ///< the left end of its baseline
  Color ink{};
};

/// Writes the content of a page. Places are those of drawings: in points, y down, from the left top corner of
/// the page or of what is begun on it.
class PdfContent {
public:
  /// Of a page so high, with faces that are embedded. `formulas` are those that formulas are set in. Both
  /// must outlive it.
  PdfContent(double height, const PdfFonts &embedded, const math::MathFonts &formulas)
      : m_height(height), m_embedded(embedded), m_formulas(formulas) {}

  void write(const PathPart &part);
  void write(const FormulaPart &part);
  void write(const TextPart &part);
  /// The parts of a drawing, cut off at its borders, with its left top corner at a place.
  void write(const Drawing &drawing, glm::dvec2 at);
  /// A formula on what is clear already: its halo is not painted. What is copied of it is for the mark around
  /// it to say.
  void writeWithoutHalo(const FormulaPart &part);
  void fill(const math::Rectangle &box, Color color);

  /// What is written until the end of the mark belongs together; `tag` says to what: `/Figure<</MCID 0>>`.
  void beginMark(const std::string &tag);
  void endMark();

  [[nodiscard]] const std::string &text() const { return m_text; }
  /// The opacities that the page uses, by their names in it.
  [[nodiscard]] std::map<std::string, std::string> opacities() const;

private:
  [[nodiscard]] std::string opacityText(double fill, double pen);
  /// The page's own y points up.
  [[nodiscard]] glm::dvec2 upward(glm::dvec2 spot) const;
  void writePath(const PagePath &path);
  /// What is shown until the mark's end is read and copied as this text.
  void beginSpan(const std::string &plain);
  void writeHalo(const FormulaPart &part);
  void writeInk(const FormulaPart &part);
  void writeLetters(const FormulaPart &part, bool isHalo);
  void writeRule(const math::Rule &rule, const FormulaPart &part, const char *paint);

  double m_height;
  const PdfFonts &m_embedded;
  const math::MathFonts &m_formulas;
  glm::dvec2 m_origin{}; ///< of what is begun on the page
  std::string m_text;
  std::set<std::pair<int, int>> m_opacities; ///< that the page uses, in percent
};

} // namespace halfspace
