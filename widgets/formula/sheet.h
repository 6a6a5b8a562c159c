// What a formula's layout is made on: the shapes placed so far, and what all rooms of the layout need.
#pragma once

#include "widgets/formula/layout.h"
#include "widgets/formula/math_font.h"

#include <optional>
#include <string>

namespace halfspace::math {

/// TeX's eight styles: four sizes, each also cramped, which raises superscripts less.
struct SetStyle {
  Style size = Style::Display;
  bool isCramped = false;

  [[nodiscard]] bool isDisplay() const { return size == Style::Display; }
  [[nodiscard]] bool isScript() const { return size >= Style::Script; }
  [[nodiscard]] SetStyle cramped() const { return {size, true}; }
  [[nodiscard]] SetStyle superscript() const {
    return {isScript() ? Style::ScriptScript : Style::Script, isCramped};
  }
  [[nodiscard]] SetStyle subscript() const { return superscript().cramped(); }
  [[nodiscard]] SetStyle numerator() const { return {smaller(), isCramped}; }
  [[nodiscard]] SetStyle denominator() const { return {smaller(), true}; }
  /// Another size, as cramped as before.
  [[nodiscard]] SetStyle sized(Style to) const { return {to, isCramped}; }

private:
  [[nodiscard]] Style smaller() const {
    return size == Style::Display ? Style::Text : size == Style::Text ? Style::Script : Style::ScriptScript;
  }
};

/// How many shapes of each kind there are.
struct ShapeCounts {
  std::size_t glyphs = 0;
  std::size_t rules = 0;
  std::size_t tagBoxes = 0;
};

/// A piece of the formula with its shapes, which lie around the piece's own origin until it is placed.
struct Box {
  double width = 0;
  double ascent = 0;
  double depth = 0;
  double italics = 0;                 ///< the correction of its slant; the width is without it
  std::optional<double> accentMiddle; ///< where an accent's middle goes; none: at the middle of the width
  std::optional<GlyphId> character;   ///< of a single character of the math font
  ShapeCounts begin;
  ShapeCounts end;

  [[nodiscard]] double fullWidth() const { return width + italics; }
  [[nodiscard]] double height() const { return ascent + depth; }
};

class Sheet {
public:
  explicit Sheet(const MathFonts &fonts);

  [[nodiscard]] const MathFonts &fonts() const { return m_fonts; }
  [[nodiscard]] const MathFont &font() const { return m_fonts.math; }
  /// The em of a style, in em of the formula.
  [[nodiscard]] double em(SetStyle style) const { return m_sizes[static_cast<std::size_t>(style.size)]; }
  /// A length of the font in a style.
  [[nodiscard]] double constant(hb_ot_math_constant_t which, SetStyle style) const {
    return font().constant(which) * em(style);
  }
  /// How high above the baseline the middle of + and of fractions lies.
  [[nodiscard]] double axis(SetStyle style) const { return constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT, style); }

  /// An empty box that what is put from now on can be taken into.
  [[nodiscard]] Box begin() const;
  /// Moves a box's shapes right and up.
  void move(const Box &box, double right, double up);
  /// Moves a part to its place in a box, and lets the box reach around it. Its width is the part's full
  /// width.
  void place(Box &into, const Box &part, double right, double up);
  /// Takes all that was put since the box began into it.
  void close(Box &box) const { box.end = counts(); }
  /// Takes away all that was put since the box began.
  void forget(const Box &box);

  /// One glyph with its origin at (x, y up), in the em of a style.
  void putGlyph(FontIndex font, GlyphId glyph, double x, double up, SetStyle style);
  /// A rule by its left end and its top, y up.
  void putRule(double x, double top, double width, double height);

  /// Opens a tag and makes it the current one; returns the index of its box, which is still empty.
  std::size_t openTag(const TagId &id);
  void setTagBox(std::size_t tagBox, const Rectangle &box) { m_layout.tagBoxes[tagBox].box = box; }
  [[nodiscard]] Ink ink() const { return m_ink; }
  void setInk(const Ink &ink) { m_ink = ink; }

  [[nodiscard]] ShapeCounts counts() const;
  [[nodiscard]] Layout &layout() { return m_layout; }

  /// Counts how deep rows are nested; false: too deep.
  [[nodiscard]] bool descend();
  void ascend() { --m_depth; }

private:
  const MathFonts &m_fonts;
  std::array<double, 4> m_sizes;
  Layout m_layout;
  Ink m_ink;
  int m_depth = 0;
};

} // namespace halfspace::math
