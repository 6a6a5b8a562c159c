// Where the glyphs and rules of a formula go. Lengths are in em of the formula's type size, y points down,
// the origin is the left end of the baseline (of the first line, where there are several).
#pragma once

#include "widgets/formula/math_tree.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace halfspace::math {

using GlyphId = std::uint32_t;

/// Which face of a `MathFonts` a glyph is of.
enum class FontIndex : std::uint8_t { Math, Text };

inline constexpr int noTag = -1;

/// What a shape is to be painted with.
struct Ink {
  int tag = noTag;            ///< index into `Layout::tags` of the innermost tag around it
  std::optional<Color> color; ///< of the innermost colour around it; none: the painter's
};

/// A glyph with its origin at (x, y); `size` is the length of its em.
struct PlacedGlyph {
  GlyphId glyph = 0; ///< 0: neither face has the character
  FontIndex font = FontIndex::Math;
  double x = 0;
  double y = 0;
  double size = 1;
  Ink ink;
};

/// A rectangle by its left top corner.
struct Rectangle {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;

  [[nodiscard]] double right() const { return x + width; }
  [[nodiscard]] double bottom() const { return y + height; }
};

/// A filled rectangle.
struct Rule {
  Rectangle box;
  Ink ink;
};

/// One use of a tag.
struct Tag {
  TagId id;
  int parent = noTag; ///< index of the tag around it, which stands before it
};

/// The room of a tag. A tag broken across lines has one for each line.
struct TagBox {
  int tag = 0;
  Rectangle box;
};

/// What may begin a line. The better, the smaller.
enum class Break : std::uint8_t {
  Statement,     ///< behind a wide space, which sets statements apart
  Relation,      ///< before a relation
  Sign,          ///< before + or −
  Product,       ///< before · or another operation
  Entry,         ///< behind a comma inside parentheses
  Inside,        ///< before a relation, + or − there
  InsideProduct, ///< before an operation there
  Never
};

/// One atom of the outermost row: where lines can be broken.
struct Piece {
  Break before = Break::Never;
  double x = 0;
  double right = 0;
  double ascent = 0;
  double depth = 0;
  /// Its first shapes; those up to the next piece's are its own.
  std::size_t glyphs = 0;
  std::size_t rules = 0;
  std::size_t tagBoxes = 0;
};

/// A tag of the outermost row by its pieces [begin, end), and its box.
struct TaggedPieces {
  std::size_t tagBox = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// A line of text, as `breakLines` makes it.
struct Line {
  double baseline = 0; ///< y
  double left = 0;
  double right = 0;
  double ascent = 0; ///< above its baseline
  double depth = 0;  ///< below it
};

struct Layout {
  double width = 0;
  double ascent = 0; ///< above the (first) baseline
  double depth = 0;  ///< below it, further lines included
  std::vector<PlacedGlyph> glyphs;
  std::vector<Rule> rules;
  std::vector<Tag> tags;        ///< in the order of reading; a tag inside another comes after it
  std::vector<TagBox> tagBoxes; ///< likewise
  std::vector<Line> lines;      ///< one, until `breakLines`

  /// For `breakLines`; empty in its result.
  std::vector<Piece> pieces;
  std::vector<TaggedPieces> taggedPieces;
};

} // namespace halfspace::math
