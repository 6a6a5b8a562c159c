#include "widgets/exports/svg_writer.h"

#include "lessons/text.h"
#include "lessons/xml_text.h"
#include "widgets/exports/formula_outlines.h"
#include "widgets/exports/page_number.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Text as it stands in the file. Control characters have no place in XML at all.
std::string escaped(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return escapedForXml(text);
}

std::string attribute(const char *name, const std::string &value) {
  return std::string(" ") + name + "=\"" + escaped(value) + "\"";
}

std::string colorText(Color color) {
  constexpr const char *digits = "0123456789abcdef";
  std::string text = "#";
  for (const int channel : {color.red, color.green, color.blue}) {
    text += digits[channel / 16];
    text += digits[channel % 16];
  }
  return text;
}

std::string pathData(const PagePath &path) {
  std::string data;
  for (const PageStep &step : path.steps)
    switch (step.kind) {
    case PageStep::Kind::Move:
      data += "M" + pageNumbers(step.to);
      break;
    case PageStep::Kind::Line:
      data += "L" + pageNumbers(step.to);
      break;
    case PageStep::Kind::Curve:
      data += "C" + pageNumbers(step.first) + " " + pageNumbers(step.second) + " " + pageNumbers(step.to);
      break;
    case PageStep::Kind::Close:
      data += "Z";
      break;
    }
  return data;
}

std::string opacityAttribute(const char *name, double opacity) {
  return opacity < 1 ? attribute(name, pageNumber(opacity)) : "";
}

std::string fillAttributes(const std::optional<Fill> &fill) {
  return fill ? attribute("fill", colorText(fill->color)) + opacityAttribute("fill-opacity", fill->opacity)
              : attribute("fill", "none");
}

std::string penAttributes(const Pen &pen) {
  std::string attributes =
      attribute("stroke", colorText(pen.color)) + attribute("stroke-width", pageNumber(pen.width)) +
      attribute("stroke-linejoin", "round") + opacityAttribute("stroke-opacity", pen.opacity);
  if (pen.cap == Pen::Cap::Round)
    attributes += attribute("stroke-linecap", "round");
  if (!pen.dashes.empty()) {
    std::string dashes;
    for (const double dash : pen.dashes)
      dashes += (dashes.empty() ? "" : " ") + pageNumber(dash);
    attributes +=
        attribute("stroke-dasharray", dashes) + attribute("stroke-dashoffset", pageNumber(pen.dashStart));
  }
  return attributes;
}

std::string markAttribute(const std::string &mark) {
  return mark.empty() ? "" : attribute("data-mark", mark);
}

std::string pathElement(const PagePath &path, const std::string &attributes) {
  return "<path" + attribute("d", pathData(path)) + attributes + "/>\n";
}

class SvgWriter {
public:
  SvgWriter(const math::MathFonts &fonts, TextAs text) : m_fonts(fonts), m_text(text) {
    if (text == TextAs::Letters)
      m_characters.emplace(fonts.math.face());
  }

  std::string write(const PathPart &part) const {
    return pathElement(part.path, fillAttributes(part.fill) + (part.pen ? penAttributes(*part.pen) : "") +
                                      markAttribute(part.mark) +
                                      (part.isHidden ? attribute("class", "hidden") : ""));
  }

  std::string write(const FormulaPart &part) const {
    const std::vector<InkedOutline> outlines = outlinesOf(part, m_fonts);
    std::string group = "<g" + attribute("aria-label", part.plain) + markAttribute(part.mark) +
                        opacityAttribute("opacity", part.opacity) + ">\n";
    const Pen halo{part.halo, 2 * haloWidth * part.size};
    for (const InkedOutline &outline : outlines)
      group += pathElement(outline.path, fillAttributes(Fill{part.halo}) + penAttributes(halo));
    if (m_text == TextAs::Letters)
      group += letters(part);
    else
      for (const InkedOutline &outline : outlines)
        group += pathElement(outline.path, fillAttributes(Fill{outline.ink}));
    return group + "</g>\n";
  }

private:
  /// Each letter at its place; forms that have no character are drawn.
  [[nodiscard]] std::string letters(const FormulaPart &part) const {
    std::string elements;
    for (const math::PlacedGlyph &glyph : part.formula->glyphs) {
      const std::string fill = fillAttributes(Fill{colorOf(glyph.ink, part)});
      const auto character = glyph.font == math::FontIndex::Math ? m_characters->characterOf(glyph.glyph)
                                                                 : std::optional<char32_t>();
      if (!character) {
        elements += pathElement(outlineOf(glyph, part, m_fonts), fill);
        continue;
      }
      const glm::dvec2 origin = originOf(glyph, part);
      elements += "<text" + attribute("x", pageNumber(origin.x)) + attribute("y", pageNumber(origin.y)) +
                  attribute("font-family", "Latin Modern Math, STIX Two Math, Cambria Math, serif") +
                  attribute("font-size", pageNumber(glyph.size * part.size)) + fill + ">" +
                  escaped(utf8(*character)) + "</text>\n";
    }
    for (const math::Rule &rule : part.formula->rules)
      elements +=
          pathElement(rectanglePath(roomOf(rule, part)), fillAttributes(Fill{colorOf(rule.ink, part)}));
    return elements;
  }

  const math::MathFonts &m_fonts;
  TextAs m_text;
  std::optional<GlyphCharacters> m_characters;
};

} // namespace

std::string svgOf(const Drawing &drawing, const math::MathFonts &fonts, TextAs text) {
  const std::string width = pageNumber(drawing.size.x);
  const std::string height = pageNumber(drawing.size.y);
  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"" +
                    attribute("width", width + "pt") + attribute("height", height + "pt") +
                    attribute("viewBox", "0 0 " + width + " " + height) + attribute("role", "img") +
                    attribute("aria-label", drawing.title + " – " + drawing.description) + ">\n<title>" +
                    escaped(drawing.title) + "</title>\n<desc>" + escaped(drawing.description) + "</desc>\n";
  if (drawing.ground)
    svg += pathElement(rectanglePath({0, 0, drawing.size.x, drawing.size.y}),
                       fillAttributes(Fill{*drawing.ground}));
  const SvgWriter writer(fonts, text);
  for (const DrawingPart &part : drawing.parts)
    svg += std::visit([&](const auto &one) { return writer.write(one); }, part);
  return svg + "</svg>\n";
}

} // namespace halfspace
