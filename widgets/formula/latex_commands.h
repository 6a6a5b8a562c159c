// The commands that are more than one symbol: what they read and make.
#pragma once

#include "widgets/formula/math_tree.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace halfspace::math {

class LatexReader;

struct Command;

/// A command that stands in a formula.
struct CommandCall {
  const Command &command;
  std::size_t column = 1; ///< of its backslash
};

/// What a command reads and makes (latex_command_readers.h).
using ReadCommand = void (*)(LatexReader &reader, Row &row, const CommandCall &call);

/// A command by its name. Which of the other fields mean something, `read` knows.
struct Command {
  std::string_view name;
  ReadCommand read = nullptr;
  char32_t character = 0;
  double amount = 0; ///< em
  AtomClass atomClass = AtomClass::Ord;
  ScriptPlace scriptPlace = ScriptPlace::Beside;
  Alphabet alphabet = Alphabet::Upright;
  Side side = Side::Above;
  Align align = Align::Left;
  std::optional<Style> style = std::nullopt;
  std::string_view text = {}; ///< of a function, where it differs from the name
};

/// In the order of their names.
[[nodiscard]] std::span<const Command> commands();
/// Null: there is none of this name.
[[nodiscard]] const Command *commandNamed(std::string_view name);

} // namespace halfspace::math
