// The formats in which drawings are written.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/formula/math_font.h"

#include <functional>

namespace halfspace {

/// How formulas are written where a format leaves the choice.
enum class TextAs {
  Shapes, ///< looks the same everywhere
  Letters ///< can be searched and edited where the reader has the font
};

/// One file in formats/, and a word in this room's CMakeLists.txt.
struct ExportFormat {
  std::string name;   ///< for people
  std::string ending; ///< of files, with its dot, in small letters
  /// The whole file; the same for the same drawing. The fonts are those that its formulas are set in.
  std::function<std::string(const Drawing &drawing, const math::MathFonts &fonts, TextAs text)> write;
  bool choosesText = false; ///< else it has its own way with formulas, whatever is asked
};

[[nodiscard]] const std::vector<ExportFormat> &exportFormats();

/// How a file's name ends, with its dot, in small letters.
[[nodiscard]] std::string endingOf(const std::string &file);

/// That of a file, by how its name ends; null for none of them.
[[nodiscard]] const ExportFormat *formatOfFile(const std::string &file);

} // namespace halfspace
