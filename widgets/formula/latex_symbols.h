// The commands and characters that are one symbol each.
#pragma once

#include "widgets/formula/math_tree.h"

#include <optional>
#include <span>
#include <string_view>

namespace halfspace::math {

/// A command that is one symbol: `\cdot`.
struct SymbolCommand {
  std::string_view name;
  char32_t character = 0;
  AtomClass atomClass = AtomClass::Ord;
};

/// In the order of their names.
[[nodiscard]] std::span<const SymbolCommand> symbolCommands();
/// Null: there is none of this name.
[[nodiscard]] const SymbolCommand *symbolNamed(std::string_view name);

/// What a character means that is typed directly: `-` is the binary operation U+2212, `≤` a relation.
struct TypedSymbol {
  char32_t character = 0;
  AtomClass atomClass = AtomClass::Ord;
};
[[nodiscard]] TypedSymbol typedSymbol(char32_t character);

/// What ² and ₀ stand for: a script of a plain character.
struct TypedScript {
  char32_t character = 0;
  bool isAbove = false;
};
[[nodiscard]] std::optional<TypedScript> typedScript(char32_t character);

/// Whether a character can be a fence for \left, \right and \big.
[[nodiscard]] bool isFence(char32_t character);

/// The character with a stroke through it, as ≠ for =; 0: Unicode has none.
[[nodiscard]] char32_t negated(char32_t character);

} // namespace halfspace::math
