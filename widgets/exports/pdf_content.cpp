#include "widgets/exports/pdf_content.h"

#include "widgets/exports/formula_outlines.h"
#include "widgets/exports/page_number.h"

#include <cmath>

namespace halfspace {
namespace {

/// Channels of colours are told in these parts, which are finer than their 8 bits.
constexpr double channelParts = 1000;
/// Opacities are told in these parts.
constexpr double percent = 100;
/// How far a glyph is moved from where the one before ends is told in these parts of an em.
constexpr double movesPerEm = 1000;

std::string channelText(int channel) {
  const int parts = static_cast<int>(std::lround(channel * channelParts / 255));
  if (parts % static_cast<int>(channelParts) == 0)
    return parts > 0 ? "1" : "0";
  std::string digits = std::to_string(parts);
  return "." + std::string(3 - digits.size(), '0') + digits;
}

/// The operators that set a colour are rg (to fill) and RG (for pens).
std::string colorText(Color color, const char *setColor) {
  return channelText(color.red) + " " + channelText(color.green) + " " + channelText(color.blue) + " " +
         setColor + "\n";
}

std::string opacityName(int fill, int pen) { return "/O" + std::to_string(fill) + "_" + std::to_string(pen); }

std::string penText(const Pen &pen) {
  std::string text = colorText(pen.color, "RG") + pageNumber(pen.width) + " w 1 j" +
                     (pen.cap == Pen::Cap::Round ? " 1 J" : "");
  if (!pen.dashes.empty()) {
    text += " [";
    for (const double dash : pen.dashes)
      text += pageNumber(dash) + " ";
    text.back() = ']';
    text += " " + pageNumber(pen.dashStart) + " d";
  }
  return text + "\n";
}

} // namespace

void PdfContent::write(const PathPart &part) {
  m_text += "q\n" + opacityText(part.fill ? part.fill->opacity : 1, part.pen ? part.pen->opacity : 1);
  if (part.fill)
    m_text += colorText(part.fill->color, "rg");
  if (part.pen)
    m_text += penText(*part.pen);
  writePath(part.path);
  m_text += part.fill && part.pen ? "B\n" : part.fill ? "f\n" : part.pen ? "S\n" : "n\n";
  m_text += "Q\n";
}

void PdfContent::write(const FormulaPart &part) {
  m_text += "q\n" + opacityText(part.opacity, part.opacity);
  beginSpan("");
  writeHalo(part);
  endMark();
  beginSpan(part.plain);
  writeInk(part);
  endMark();
  m_text += "Q\n";
}

void PdfContent::writeWithoutHalo(const FormulaPart &part) {
  m_text += "q\n" + opacityText(part.opacity, part.opacity);
  writeInk(part);
  m_text += "Q\n";
}

void PdfContent::write(const TextPart &part) {
  if (part.glyphs.empty())
    return;
  m_text += "BT\n" + colorText(part.ink, "rg") + m_embedded.nameOf(*part.face) + " " + pageNumber(part.size) +
            " Tf\n1 0 0 1 " + pageNumbers(upward(part.start)) + " Tm[<";
  double pen = 0; // where the next glyph would stand by itself, in ems
  for (const TextPart::Glyph &glyph : part.glyphs) {
    const double place = glyph.x / part.size;
    if (const long move = std::lround((pen - place) * movesPerEm); move != 0) {
      m_text += ">" + std::to_string(move) + "<";
      pen -= static_cast<double>(move) / movesPerEm;
    }
    m_text += m_embedded.codeOf(*part.face, glyph.glyph);
    pen += part.face->metrics(glyph.glyph).advance;
  }
  m_text += ">]TJ\nET\n";
}

void PdfContent::write(const Drawing &drawing, glm::dvec2 at) {
  m_text += "q\n";
  m_origin = at;
  m_text += pageNumbers(upward({0, drawing.size.y})) + " " + pageNumbers(drawing.size) + " re W n\n";
  if (drawing.ground)
    fill({0, 0, drawing.size.x, drawing.size.y}, *drawing.ground);
  for (const DrawingPart &part : drawing.parts)
    std::visit([&](const auto &one) { write(one); }, part);
  m_origin = {};
  m_text += "Q\n";
}

void PdfContent::fill(const math::Rectangle &box, Color color) {
  m_text += colorText(color, "rg") + pageNumbers(upward({box.x, box.bottom()})) + " " +
            pageNumbers({box.width, box.height}) + " re f\n";
}

void PdfContent::beginMark(const std::string &tag) { m_text += tag + "BDC\n"; }

void PdfContent::endMark() { m_text += "EMC\n"; }

std::map<std::string, std::string> PdfContent::opacities() const {
  std::map<std::string, std::string> states;
  for (const auto &[fill, pen] : m_opacities)
    states[opacityName(fill, pen)] =
        "<</ca " + pageNumber(fill / percent) + "/CA " + pageNumber(pen / percent) + ">>";
  return states;
}

std::string PdfContent::opacityText(double fill, double pen) {
  const std::pair both(static_cast<int>(std::lround(fill * percent)),
                       static_cast<int>(std::lround(pen * percent)));
  if (both.first == percent && both.second == percent)
    return "";
  m_opacities.insert(both);
  return opacityName(both.first, both.second) + " gs\n";
}

glm::dvec2 PdfContent::upward(glm::dvec2 spot) const {
  return {m_origin.x + spot.x, m_height - m_origin.y - spot.y};
}

void PdfContent::writePath(const PagePath &path) {
  for (const PageStep &step : path.steps)
    switch (step.kind) {
    case PageStep::Kind::Move:
      m_text += pageNumbers(upward(step.to)) + " m\n";
      break;
    case PageStep::Kind::Line:
      m_text += pageNumbers(upward(step.to)) + " l\n";
      break;
    case PageStep::Kind::Curve:
      m_text += pageNumbers(upward(step.first)) + " " + pageNumbers(upward(step.second)) + " " +
                pageNumbers(upward(step.to)) + " c\n";
      break;
    case PageStep::Kind::Close:
      m_text += "h\n";
      break;
    }
}

void PdfContent::beginSpan(const std::string &plain) {
  beginMark("/Span<</ActualText" + pdfText(plain) + ">>");
}

void PdfContent::writeHalo(const FormulaPart &part) {
  m_text += colorText(part.halo, "RG") + colorText(part.halo, "rg") + pageNumber(2 * haloWidth * part.size) +
            " w 1 j 1 J\n2 Tr\n";
  writeLetters(part, true);
  m_text += "0 Tr\n";
  for (const math::Rule &rule : part.formula->rules)
    writeRule(rule, part, "B");
}

void PdfContent::writeInk(const FormulaPart &part) {
  writeLetters(part, false);
  for (const math::Rule &rule : part.formula->rules) {
    m_text += colorText(colorOf(rule.ink, part), "rg");
    writeRule(rule, part, "f");
  }
}

void PdfContent::writeLetters(const FormulaPart &part, bool isHalo) {
  m_text += "BT\n";
  std::optional<Color> ink;
  std::string font;
  for (const math::PlacedGlyph &glyph : part.formula->glyphs) {
    if (const Color next = colorOf(glyph.ink, part); !isHalo && ink != next) {
      m_text += colorText(next, "rg");
      ink = next;
    }
    const math::FontFace &face = m_formulas.face(glyph.font);
    std::string next = m_embedded.nameOf(face) + " " + pageNumber(glyph.size * part.size) + " Tf\n";
    if (next != font) {
      m_text += next;
      font = std::move(next);
    }
    m_text += "1 0 0 1 " + pageNumbers(upward(originOf(glyph, part))) + " Tm<" +
              m_embedded.codeOf(face, glyph.glyph) + ">Tj\n";
  }
  m_text += "ET\n";
}

void PdfContent::writeRule(const math::Rule &rule, const FormulaPart &part, const char *paint) {
  const math::Rectangle room = roomOf(rule, part);
  m_text += pageNumbers(upward({room.x, room.bottom()})) + " " + pageNumbers({room.width, room.height}) +
            " re " + paint + "\n";
}

} // namespace halfspace
