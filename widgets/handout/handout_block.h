// What a handout says, from top to bottom, before anything is set in type.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/handout/styled_text.h"

#include <vector>

namespace halfspace {

struct HandoutBlock;
using HandoutBlocks = std::vector<HandoutBlock>;

struct HeadingBlock {
  int level = 1;        ///< 1: the title; 2: a step, which has a bookmark; from 3: within a step
  std::string number{}; ///< before it; may be empty
  InlineText title;
  std::string plain; ///< the title in plain text
};

enum class TextSize : std::uint8_t { Normal, Small };

struct ParagraphBlock {
  InlineText text;
  TextSize size = TextSize::Normal;
};

/// A formula in a row of its own.
struct FormulaBlock {
  InlineFormula formula;
};

struct CodeBlock {
  std::vector<std::string> lines;
};

/// A thematic break.
struct RuleBlock {};

struct QuoteBlock {
  HandoutBlocks blocks;
};

struct ListItem {
  std::string mark; ///< a bullet, a number, a box
  HandoutBlocks blocks;
};

struct ListBlock {
  std::vector<ListItem> items;
};

struct TableCell {
  enum class Side : std::uint8_t { Left, Middle, Right };
  InlineText text;
  Side side = Side::Left;
};

struct TableRow {
  bool isHeading = false;
  std::vector<TableCell> cells;
};

/// Rows may have different numbers of cells.
struct TableBlock {
  std::vector<TableRow> rows;
};

/// Drawings of one thing, beside each other where there is room, else below each other, with what is said
/// below them. They stand near their place in the text, where a column has room for them.
struct FigureBlock {
  std::vector<Drawing> drawings;
  std::string description; ///< what is to be seen, for those who do not see it
  InlineText caption;
};

/// Words beside the text, for those whom they concern.
struct NoteBlock {
  InlineText title;
  HandoutBlocks blocks;
};

/// Room for the learner to write.
struct RoomBlock {
  int lines = 1;
};

struct HandoutBlock {
  using Content = std::variant<HeadingBlock, ParagraphBlock, FormulaBlock, CodeBlock, RuleBlock, QuoteBlock,
                               ListBlock, TableBlock, FigureBlock, NoteBlock, RoomBlock>;
  Content content;
  bool keepsWithNext = false; ///< the next block begins in the same column
};

/// A handout as a whole.
struct HandoutText {
  std::string title;   ///< in plain text
  HandoutBlocks front; ///< title and what belongs to it, as wide as the page
  HandoutBlocks body;  ///< in columns
};

} // namespace halfspace
