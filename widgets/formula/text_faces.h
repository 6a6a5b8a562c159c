// The faces that running words are set in beside formulas.
#pragma once

#include "widgets/formula/font_face.h"

#include <array>
#include <optional>
#include <string>

namespace halfspace::math {

enum class TextFace : std::uint8_t { Regular, Bold, Italic, BoldItalic, Typewriter };
inline constexpr std::size_t textFaceCount = 5;

/// The files of the faces in their folder, by TextFace: those of Latin Modern, which go with its formulas.
inline constexpr std::array<const char *, textFaceCount> textFaceFiles{
    "lmroman10-regular.otf", "lmroman10-bold.otf", "lmroman10-italic.otf", "lmroman10-bolditalic.otf",
    "lmmono10-regular.otf"};

/// For one thread at a time, as its faces are.
struct TextFaces {
  std::vector<FontFace> faces; ///< by TextFace

  [[nodiscard]] const FontFace &face(TextFace which) const { return faces[static_cast<std::size_t>(which)]; }
};

/// All faces from a folder. None: one of them is missing or is no font.
[[nodiscard]] std::optional<TextFaces> readTextFaces(const std::string &folder);

} // namespace halfspace::math
