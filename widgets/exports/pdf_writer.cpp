#include "widgets/exports/pdf_writer.h"

#include "widgets/exports/formula_outlines.h"
#include "widgets/exports/page_number.h"
#include "widgets/exports/pdf_fonts.h"

#include <cmath>
#include <set>

namespace halfspace {
namespace {

/// Channels of colours are told in these parts, which are finer than their 8 bits.
constexpr double channelParts = 1000;

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

/// Writes the content of a page.
class PdfContent {
public:
  PdfContent(double height, const PdfFonts &fonts) : m_height(height), m_fonts(fonts) {}

  void write(const PathPart &part) {
    m_text += "q\n" + opacityText(part.fill ? part.fill->opacity : 1, part.pen ? part.pen->opacity : 1);
    if (part.fill)
      m_text += colorText(part.fill->color, "rg");
    if (part.pen)
      m_text += penText(*part.pen);
    writePath(part.path);
    m_text += part.fill && part.pen ? "B\n" : part.fill ? "f\n" : part.pen ? "S\n" : "n\n";
    m_text += "Q\n";
  }

  void write(const FormulaPart &part) {
    m_text += "q\n" + opacityText(part.opacity, part.opacity);
    beginSpan("");
    writeHalo(part);
    m_text += "EMC\n";
    beginSpan(part.plain);
    writeLetters(part, false);
    for (const math::Rule &rule : part.formula->rules) {
      m_text += colorText(colorOf(rule.ink, part), "rg");
      writeRule(rule, part, "f");
    }
    m_text += "EMC\nQ\n";
  }

  void fillPage(Color color, glm::dvec2 size) {
    m_text += colorText(color, "rg") + "0 0 " + pageNumbers(size) + " re f\n";
  }

  [[nodiscard]] const std::string &text() const { return m_text; }
  /// What the opacities of the page are called, for its resources.
  [[nodiscard]] std::string opacities() const {
    std::string states;
    for (const auto &[fill, pen] : m_opacities)
      states += opacityName(fill, pen) + "<</ca " + pageNumber(fill / percent) + "/CA " +
                pageNumber(pen / percent) + ">>";
    return states;
  }

private:
  static constexpr double percent = 100;

  static std::string opacityName(int fill, int pen) {
    return "/O" + std::to_string(fill) + "_" + std::to_string(pen);
  }
  std::string opacityText(double fill, double pen) {
    const std::pair both(static_cast<int>(std::lround(fill * percent)),
                         static_cast<int>(std::lround(pen * percent)));
    if (both.first == percent && both.second == percent)
      return "";
    m_opacities.insert(both);
    return opacityName(both.first, both.second) + " gs\n";
  }

  static std::string penText(const Pen &pen) {
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

  /// The page's own y points up.
  [[nodiscard]] glm::dvec2 upward(glm::dvec2 spot) const { return {spot.x, m_height - spot.y}; }

  void writePath(const PagePath &path) {
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

  /// What is shown until the mark's end is read and copied as this text.
  void beginSpan(const std::string &plain) { m_text += "/Span<</ActualText" + pdfText(plain) + ">>BDC\n"; }

  void writeHalo(const FormulaPart &part) {
    m_text += colorText(part.halo, "RG") + colorText(part.halo, "rg") +
              pageNumber(2 * haloWidth * part.size) + " w 1 j 1 J\n2 Tr\n";
    writeLetters(part, true);
    m_text += "0 Tr\n";
    for (const math::Rule &rule : part.formula->rules)
      writeRule(rule, part, "B");
  }

  void writeLetters(const FormulaPart &part, bool isHalo) {
    m_text += "BT\n";
    std::optional<Color> ink;
    std::string font;
    for (const math::PlacedGlyph &glyph : part.formula->glyphs) {
      if (const Color next = colorOf(glyph.ink, part); !isHalo && ink != next) {
        m_text += colorText(next, "rg");
        ink = next;
      }
      std::string next = PdfFonts::nameOf(glyph.font) + " " + pageNumber(glyph.size * part.size) + " Tf\n";
      if (next != font) {
        m_text += next;
        font = std::move(next);
      }
      m_text +=
          "1 0 0 1 " + pageNumbers(upward(originOf(glyph, part))) + " Tm" + m_fonts.codeOf(glyph) + "Tj\n";
    }
    m_text += "ET\n";
  }

  void writeRule(const math::Rule &rule, const FormulaPart &part, const char *paint) {
    const math::Rectangle room = roomOf(rule, part);
    m_text += pageNumbers(upward({room.x, room.bottom()})) + " " + pageNumbers({room.width, room.height}) +
              " re " + paint + "\n";
  }

  double m_height;
  const PdfFonts &m_fonts;
  std::string m_text;
  std::set<std::pair<int, int>> m_opacities; ///< that the page uses, in percent
};

} // namespace

std::string pdfOf(const Drawing &drawing, const math::MathFonts &fonts) {
  PdfFile file;
  const PdfFonts embedded(drawing, fonts, file);
  PdfContent content(drawing.size.y, embedded);
  if (drawing.ground)
    content.fillPage(*drawing.ground, drawing.size);
  for (const DrawingPart &part : drawing.parts)
    std::visit([&](const auto &one) { content.write(one); }, part);
  const int stream = file.addStream("/Figure<</MCID 0>>BDC\n" + content.text() + "EMC");

  const std::string box = "[0 0 " + pageNumbers(drawing.size) + "]";
  const int pages = file.reserve();
  const int root = file.reserve();
  const int page = file.add("<</Type/Page/Parent " + pdfReference(pages) + "/MediaBox" + box + "/Contents " +
                            pdfReference(stream) +
                            "/StructParents 0/Group<</S/Transparency/CS/DeviceRGB>>/Resources<</Font<<" +
                            embedded.resources() + ">>/ExtGState<<" + content.opacities() + ">>>>>>");
  file.put(pages, "<</Type/Pages/Count 1/Kids[" + pdfReference(page) + "]>>");
  const int figure = file.add("<</Type/StructElem/S/Figure/P " + pdfReference(root) + "/Pg " +
                              pdfReference(page) + "/K 0/Alt" + pdfText(drawing.description) +
                              "/A<</O/Layout/Placement/Block/BBox" + box + ">>>>");
  file.put(root, "<</Type/StructTreeRoot/K " + pdfReference(figure) + "/ParentTree<</Nums[0[" +
                     pdfReference(figure) + "]]>>>>");
  const int catalog = file.add("<</Type/Catalog/Pages " + pdfReference(pages) + "/Lang(" + drawing.language +
                               ")/MarkInfo<</Marked true>>/StructTreeRoot " + pdfReference(root) +
                               "/ViewerPreferences<</DisplayDocTitle true>>>>");
  const int info = file.add("<</Title" + pdfText(drawing.title) + ">>");
  return file.bytes(catalog, info);
}

} // namespace halfspace
