// Words set in type, one at a time.
#pragma once

#include "widgets/exports/pdf_content.h"
#include "widgets/formula/text_faces.h"
#include "widgets/handout/styled_text.h"

namespace halfspace {

/// What a handout is set in. Both must outlive whoever has it.
struct HandoutFonts {
  const math::MathFonts &formulas;
  const math::TextFaces &words;
};

/// A word in its place on a line: the origin is the left end of its baseline.
struct SetWord {
  struct Part {
    TextPart text;
    std::string copied{}; ///< what is read and copied of it; empty: the characters of its glyphs
  };
  std::vector<Part> parts;
  double width = 0;
};

/// The face of a look.
[[nodiscard]] const math::FontFace &faceOf(TextLook look, const HandoutFonts &fonts);

/// A text on one line, kerned. What the look's face does not have is taken from the fonts of formulas. Of an
/// index `copied` is read and copied, unless that is empty.
[[nodiscard]] SetWord setWord(std::string_view text, TextLook look, double size, const HandoutFonts &fonts,
                              std::string copied = {});

/// The space between two words.
[[nodiscard]] double spaceWidth(TextLook look, double size, const HandoutFonts &fonts);

} // namespace halfspace
