// Words and formulas of a handout before they are set in type.
#pragma once

#include "widgets/formula/layout.h"

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace halfspace {

struct TextLook {
  bool strong = false;
  bool emphasized = false;
  bool code = false;
  bool struck = false;
  bool isIndex = false; ///< smaller and lower, as the index of a letter
};

/// Words of one look, in UTF-8. Lines may end at their spaces.
struct StyledWords {
  std::string text;
  TextLook look{};
  std::string copied{}; ///< of an index: what is read and copied of it; empty: the text
};

/// A formula, with what follows it.
struct InlineFormula {
  std::shared_ptr<const math::Layout> layout; ///< never null
  std::string plain;                          ///< the same in one line of plain text
};

/// The line ends here.
struct LineEnd {};

using InlinePiece = std::variant<StyledWords, InlineFormula, LineEnd>;
/// Pieces of a paragraph in the order of reading.
using InlineText = std::vector<InlinePiece>;

/// A plain text, with the indices of its letters.
[[nodiscard]] InlineText inlineText(std::string_view plain, TextLook look = {});

} // namespace halfspace
