#include "widgets/handout/set_words.h"

#include "lessons/text.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace halfspace {
namespace {

/// Indices are so large beside their letters, and stand so many ems of these lower.
constexpr double indexScale = 0.72;
constexpr double indexDrop = 0.16;
/// What is raised stands so many ems higher.
constexpr double indexRise = 0.36;

/// The face that has a character: that of the look, or one of formulas. Where none has it, the first shows
/// that something is missing.
const math::FontFace &faceWith(char32_t character, const math::FontFace &wanted, const HandoutFonts &fonts) {
  const math::FontFace &formulas = fonts.formulas.math.face();
  const math::FontFace &other = fonts.formulas.face(math::FontIndex::Text);
  for (const math::FontFace *face : {&wanted, &formulas, &other})
    if (face->glyph(character) != 0)
      return *face;
  return wanted;
}

/// A character that is set as another one, smaller, and lower or higher.
struct SmallForm {
  char32_t character;
  char32_t setAs;
  bool isRaised;
};
/// Those that plain texts of formulas have, and that text faces lack.
constexpr std::array<SmallForm, 22> smallForms{
    {{U'₀', U'0', false}, {U'₁', U'1', false}, {U'₂', U'2', false}, {U'₃', U'3', false}, {U'₄', U'4', false},
     {U'₅', U'5', false}, {U'₆', U'6', false}, {U'₇', U'7', false}, {U'₈', U'8', false}, {U'₉', U'9', false},
     {U'ₓ', U'x', false}, {U'⁰', U'0', true},  {U'¹', U'1', true},  {U'²', U'2', true},  {U'³', U'3', true},
     {U'⁴', U'4', true},  {U'⁵', U'5', true},  {U'⁶', U'6', true},  {U'⁷', U'7', true},  {U'⁸', U'8', true},
     {U'⁹', U'9', true},  {U'⁻', U'−', true}}};

const SmallForm *smallFormOf(char32_t character) {
  const auto found = std::find_if(smallForms.begin(), smallForms.end(),
                                  [&](const SmallForm &form) { return form.character == character; });
  return found != smallForms.end() ? &*found : nullptr;
}

/// Puts a word together, run by run.
class WordMaker {
public:
  WordMaker(TextLook look, double size, const HandoutFonts &fonts)
      : m_wanted(faceOf(look, fonts)), m_size(size), m_fonts(fonts) {}

  SetWord make(std::string_view text) {
    while (!text.empty()) {
      const char32_t character = firstCharacter(text).code;
      const std::string_view bytes = text.substr(0, lengthOfFirst(text));
      text.remove_prefix(bytes.size());
      if (const SmallForm *form = smallFormOf(character)) {
        endRun();
        addSmall(*form, bytes);
        continue;
      }
      const math::FontFace *face = &faceWith(character, m_wanted, m_fonts);
      if (face != m_face)
        endRun();
      m_face = face;
      m_run += bytes;
    }
    endRun();
    return std::move(m_word);
  }

  /// All of it smaller and lower.
  SetWord makeIndex(std::string_view text, std::string copied) {
    const double drop = indexDrop * m_size;
    m_size *= indexScale;
    SetWord word = make(text);
    for (SetWord::Part &part : word.parts)
      part.text.start.y += drop;
    if (!word.parts.empty())
      word.parts.front().copied = std::move(copied);
    return word;
  }

private:
  void endRun() {
    if (!m_run.empty())
      add(m_run, *m_face, m_size, 0);
    m_run.clear();
  }

  void addSmall(const SmallForm &form, std::string_view copied) {
    const math::FontFace &face = faceWith(form.setAs, m_wanted, m_fonts);
    add(utf8(static_cast<unsigned>(form.setAs)), face, m_size * indexScale,
        (form.isRaised ? -indexRise : indexDrop) * m_size);
    m_word.parts.back().copied = copied;
  }

  void add(std::string_view text, const math::FontFace &face, double size, double drop) {
    const math::ShapedText shaped = face.shape(text);
    TextPart part{&face, size, {}, {m_word.width, drop}};
    for (const math::ShapedGlyph &glyph : shaped.glyphs)
      part.glyphs.push_back({glyph.glyph, glyph.x * size});
    m_word.parts.push_back({std::move(part)});
    m_word.width += shaped.width * size;
  }

  const math::FontFace &m_wanted;
  double m_size;
  const HandoutFonts &m_fonts;
  SetWord m_word;
  const math::FontFace *m_face = nullptr; ///< of the run
  std::string m_run;
};

} // namespace

const math::FontFace &faceOf(TextLook look, const HandoutFonts &fonts) {
  using math::TextFace;
  if (look.code)
    return fonts.words.face(TextFace::Typewriter);
  if (look.strong)
    return fonts.words.face(look.emphasized ? TextFace::BoldItalic : TextFace::Bold);
  return fonts.words.face(look.emphasized ? TextFace::Italic : TextFace::Regular);
}

SetWord setWord(std::string_view text, TextLook look, double size, const HandoutFonts &fonts,
                std::string copied) {
  WordMaker maker(look, size, fonts);
  return look.isIndex ? maker.makeIndex(text, std::move(copied)) : maker.make(text);
}

double spaceWidth(TextLook look, double size, const HandoutFonts &fonts) {
  const math::FontFace &face = faceOf(look, fonts);
  return face.metrics(face.glyph(U' ')).advance * size;
}

} // namespace halfspace
