// A formula as a tree of atoms, the way TeX sees it. The reader of LaTeX makes it, and so may any code, with
// the small functions at the end; `layOut` says where its glyphs go.
//
//   // t = d·n / 3, with d tagged
//   const Row formula = row(letter('t'), symbol('=', AtomClass::Rel),
//                           fraction(row(tagged("d", row(letter('d'))), symbol(U'⋅', AtomClass::Bin),
//                                        vector(row(letter('n')))), number("3")));
#pragma once

#include "widgets/formula/alphabets.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace halfspace::math {

/// TeX's classes of atoms. The space between two atoms follows from their classes (The TeXbook, chapter 18).
/// A sign that has nothing to combine is given as `Bin` all the same: the layout sees from its neighbours
/// that it is none.
enum class AtomClass : std::uint8_t { Ord, Op, Bin, Rel, Open, Close, Punct, Inner };

/// How large and how roomy a formula is set.
enum class Style : std::uint8_t { Display, Text, Script, ScriptScript };

/// Where the scripts of an atom go.
enum class ScriptPlace : std::uint8_t {
  Beside,
  LimitsInDisplay, ///< above and below in display style, as with ∑
  Limits           ///< always above and below, as with a brace
};

enum class Side : std::uint8_t { Above, Below };

enum class Align : std::uint8_t { Left, Center, Right };

/// A colour that the formula itself asks for.
struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  [[nodiscard]] bool operator==(const Color &) const = default;
};

struct Node;
/// Atoms from left to right; may be empty.
using Row = std::vector<Node>;

/// One character, by its code point: an italic x is U+1D465 (see `letter`), a minus U+2212.
struct Symbol {
  char32_t character = 0;
  bool isLarge = false; ///< centred on the axis, and larger in display style: ∑, ∫
};

/// Words or the name of a function. The text is UTF-8.
struct Words {
  std::string text;
  Alphabet alphabet = Alphabet::Upright;
};

/// A row that is one atom for what stands around it: braces in LaTeX.
struct Group {
  Row row;
  bool isInline = false; ///< display style becomes text style
};

/// Tags what is left out of the formula, for something else to stand in its place.
struct LeftOut {
  bool operator==(const LeftOut &) const = default;
};

/// By what a piece of the formula is found again: a name, or an index into what was kept beside the formula
/// when it was built.
using TagId = std::variant<std::string, std::size_t, LeftOut>;

/// A piece of the formula to be found again. For spaces and line breaks it is as if its atoms stood in the
/// row around it.
struct Tagged {
  TagId tag;
  Row row;
};

/// As `Tagged`, for a colour.
struct Colored {
  Color color;
  Row row;
};

/// Sets the style for the rest of the row (of the innermost Tagged or Colored, when inside one).
struct StyleSwitch {
  Style style = Style::Display;
};

/// Room, in em of the style it stands in; may be negative.
struct Space {
  double width = 0;
};

/// A base with what is raised and lowered; either may be empty. Where they go, the base's `scriptPlace` says.
struct Scripts {
  Row base;
  Row above;
  Row below;
};

struct Fraction {
  Row numerator;
  Row denominator;
  bool hasBar = true;         ///< false: a binomial coefficient without its parentheses
  std::optional<Style> style; ///< of the fraction as a whole; none: as around it
};

struct Root {
  Row radicand;
  Row degree; ///< empty: a square root
};

/// A row between two fences as tall as it is. Fence 0: none, but a little room.
struct Fenced {
  char32_t open = 0;
  char32_t close = 0;
  Row row;
};

/// Inside a `Fenced`'s row: a fence as tall as its two.
struct MiddleFence {
  char32_t character = 0;
};

/// A fence of a height that is given, in em.
struct TallFence {
  char32_t character = 0;
  double height = 0;
};

/// A combining character over a base.
struct Accent {
  char32_t character = 0;
  bool isWide = false; ///< as wide as the base, as far as the font can
  Row base;
};

/// A rule over or under a base.
struct Bar {
  Side side = Side::Above;
  Row base;
};

/// A horizontal brace over or under a base.
struct Brace {
  char32_t character = 0;
  Side side = Side::Above;
  Row base;
};

/// Small rows over and under a base; either may be empty.
struct Stack {
  Row base;
  Row above;
  Row below;
};

/// An arrow as long as the small rows over and under it; either may be empty.
struct LongArrow {
  char32_t character = 0;
  Row above;
  Row below;
};

/// A base struck through by a slash: what has no negated character of its own.
struct Negated {
  Row base;
};

struct Boxed {
  Row row;
};

/// Room for a row, without showing it; or a row that shows without taking room.
struct Phantom {
  Row row;
  bool isShown = false;
  bool keepsWidth = true;
  bool keepsHeight = true;
  Align align = Align::Left; ///< without width: what of it stands at its place, the left end, the middle or
                             ///< the right end
};

/// A black box, in em, standing on the baseline.
struct Block {
  double width = 0;
  double height = 0;
};

/// Nothing, in em of the formula, whatever the style: room for what is not part of it.
struct Room {
  double width = 0;
  double ascent = 0;
  double depth = 0;
};

/// What a table is for: spaces between its rows and columns follow from it.
enum class TableKind : std::uint8_t {
  Matrix,
  SmallMatrix, ///< fits into a line of text
  Cases,
  Aligned,  ///< columns in pairs: the first ends where the second, a relation, begins
  Gathered, ///< formulas below each other
  Stacked   ///< rows of script size, for limits
};

struct TableRow {
  std::vector<Row> cells;
  int rulesAbove = 0;
  double roomBelow = 0; ///< in em, on top of what is usual
};

/// Rows may have different numbers of cells.
struct Table {
  TableKind kind = TableKind::Matrix;
  std::vector<Align> columns; ///< further columns: as the last one, in `Aligned` as the first two by turns
  std::vector<int>
      columnRules; ///< how many rules stand before each column, and behind the last; may be shorter
  std::vector<TableRow> rows;
  int rulesBelow = 0;
};

using Content = std::variant<Symbol, Words, Group, Tagged, Colored, StyleSwitch, Space, Scripts, Fraction,
                             Root, Fenced, MiddleFence, TallFence, Accent, Bar, Brace, Stack, LongArrow,
                             Negated, Boxed, Phantom, Block, Room, Table>;

/// One atom of a row.
struct Node {
  Content content;
  AtomClass atomClass = AtomClass::Ord; ///< has no meaning for Tagged, Colored, StyleSwitch and Space
  ScriptPlace scriptPlace = ScriptPlace::Beside;
};

// Builders. Each makes one atom of the class that TeX would give it.

namespace detail {
inline void append(Row &row, Node node) { row.push_back(std::move(node)); }
void append(Row &row, Row more);
} // namespace detail

/// Nodes and rows one after the other as one row.
template <class... Parts> [[nodiscard]] Row row(Parts &&...parts) {
  Row all;
  (detail::append(all, std::forward<Parts>(parts)), ...);
  return all;
}

[[nodiscard]] Node symbol(char32_t character, AtomClass atomClass = AtomClass::Ord);
/// A Latin or Greek letter or a digit in an alphabet.
[[nodiscard]] Node letter(char32_t character, Alphabet alphabet = Alphabet::Italic);
/// The digits of a number; the point and a minus (`-`) may stand among them. A minus is a sign to the layout.
[[nodiscard]] Row number(std::string_view digits);
/// ∑, ∫ and their like.
[[nodiscard]] Node largeOperator(char32_t character, ScriptPlace scriptPlace = ScriptPlace::LimitsInDisplay);
[[nodiscard]] Node words(std::string text, Alphabet alphabet = Alphabet::Upright);
/// The name of a function, as cos or max.
[[nodiscard]] Node function(std::string name, ScriptPlace scriptPlace = ScriptPlace::Beside);
[[nodiscard]] Node group(Row content);
[[nodiscard]] Node tagged(TagId tag, Row content);
[[nodiscard]] Node colored(Color color, Row content);
[[nodiscard]] Node space(double em);
[[nodiscard]] Node styleSwitch(Style style);
/// The base's class and `scriptPlace` are kept where it is one atom.
[[nodiscard]] Node scripts(Row base, Row above, Row below);
[[nodiscard]] Node scripts(Node base, Row above, Row below);
[[nodiscard]] Node fraction(Row numerator, Row denominator, std::optional<Style> style = {});
[[nodiscard]] Node root(Row radicand, Row degree = {});
[[nodiscard]] Node fenced(char32_t open, Row content, char32_t close);
[[nodiscard]] Node accent(char32_t character, Row base);
[[nodiscard]] Node wideAccent(char32_t character, Row base);
/// A vector's arrow.
[[nodiscard]] Node vector(Row base);
[[nodiscard]] Node bar(Side side, Row base);
/// Its scripts are what is written beyond the brace.
[[nodiscard]] Node brace(Side side, Row base);
[[nodiscard]] Node stack(Row base, Row above, Row below);
[[nodiscard]] Node boxed(Row content);
[[nodiscard]] Node table(Table content);
/// Centred columns between two fences (0: none).
[[nodiscard]] Node matrix(char32_t open, std::vector<std::vector<Row>> rows, char32_t close);

/// A row's only atom, seen through tags and colours; null when there is not exactly one.
[[nodiscard]] const Node *onlyAtom(const Row &row);
/// The class of a row that is to be one atom: that of its only atom; else Ord.
[[nodiscard]] AtomClass classOf(const Row &row);
/// The same for where scripts go.
[[nodiscard]] ScriptPlace scriptPlaceOf(const Row &row);

} // namespace halfspace::math
