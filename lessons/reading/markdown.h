// Markdown with `$…$` formulas and live values as a tree of blocks, for whatever shows a lesson's words.
// Nothing is loaded, followed or filled in here: links, pictures and values are named. HTML stands as it is
// written.
#pragma once

#include "lessons/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

/// What stands between dollars, or a live value: `{name}`. A `$` between marks of code or after a backslash
/// is no formula, nor is one without a partner in its paragraph. Braces are a live value where neither code
/// nor a formula nor the address of a link has them, and they hold the name of a value.
struct MarkdownFormula {
  /// What stands before a relation, or behind it.
  struct Side {
    std::size_t place;   ///< in bytes of the text that was read
    std::string text;    ///< LaTeX as it was written, without spaces at its ends; of a live value its name
    bool isLive = false; ///< its value is filled in when it is shown
    bool operator==(const Side &) const = default;
  };

  std::vector<Side> sides{}; ///< one, or two as in `$t$ = $3$` or `$t$ = {t}`: no line shall end between them
  std::string relation{};    ///< of two sides: =, < or >; empty where the second begins with its own, or may
  bool large = false;        ///< it was in `$$…$$` or alone in its paragraph; else it is set as in a line
  std::string punctuation{}; ///< what follows and no line shall begin with, of , . ; : ! ? and )
};

/// The sides with their relation, each as it was written, a live value in braces.
[[nodiscard]] std::string writtenIn(const MarkdownFormula &formula);

/// A piece of a line.
struct MarkdownSpan {
  enum class Kind { Text, Formula, LineBreak, Picture };
  struct Face {
    bool strong = false;
    bool emphasized = false;
    bool struck = false;
    bool code = false;
    std::string link{}; ///< the address that a click leads to; empty: to none
    bool operator==(const Face &) const = default;
  };

  Kind kind = Kind::Text;
  std::string text{};      ///< of a text; not empty, and without ends of lines. Of a picture: its description
  std::size_t formula = 0; ///< of a formula: its index
  Face face{};
  std::string picture{}; ///< of a picture: what it is called by
  bool operator==(const MarkdownSpan &) const = default;
};

struct MarkdownBlock {
  enum class Kind { Paragraph, Heading, Code, Rule, Quote, List, Item, Table, Row, Cell };
  enum class Side { Left, Middle, Right };

  Kind kind = Kind::Paragraph;
  int level = 0; ///< of a heading: from 1 to 6
  char mark = 0; ///< of a list: its bullet - + or *, or what stands behind its numbers: . or )
  std::optional<unsigned> number{}; ///< of an item of a numbered list
  std::optional<bool> ticked{};     ///< of an item with a box
  Side side = Side::Left;           ///< of a cell: where its words stand
  bool heading = false;             ///< of a row: its cells name the columns
  std::vector<MarkdownSpan>
      spans{}; ///< of a paragraph, a heading, a cell or code, with breaks between its lines
  std::vector<MarkdownBlock>
      children{}; ///< of a quote, a list (its items), an item, a table (its rows) or a row
  bool operator==(const MarkdownBlock &) const = default;
};

struct Markdown {
  std::vector<MarkdownBlock> blocks;
  std::vector<MarkdownFormula> formulas{}; ///< in the order of the text, also those that no span shows
  std::vector<std::size_t> loneDollars{};  ///< the places in the text of those without a partner
};

inline constexpr std::size_t maxMarkdownBytes = 1U << 16U;
/// So many quotes, lists and items in each other are read.
inline constexpr std::size_t maxMarkdownDepth = 32;
/// So many cells in all tables together: two short lines can ask for millions of empty ones.
inline constexpr std::size_t maxMarkdownCells = 1000;

/// So many pictures: each takes memory, however often it is named.
inline constexpr std::size_t maxMarkdownPictures = 16;

/// Whether an address is one that a learner may be led to: of the web, or of somebody to write to.
[[nodiscard]] bool isOpenable(std::string_view address);

/// Reads a text in UTF-8. A problem, without a place, where it is larger or nested deeper than the bounds.
/// Links to what is not openable lead nowhere.
[[nodiscard]] Result<Markdown> readMarkdown(std::string_view text);

} // namespace halfspace
