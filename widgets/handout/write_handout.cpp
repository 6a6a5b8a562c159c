#include "widgets/handout/write_handout.h"

#include "lessons/figure/mark.h"
#include "widgets/exports/pdf_writer.h"
#include "widgets/handout/fill_pages.h"
#include "widgets/handout/set_blocks.h"
#include "widgets/picture/camera.h"

#include <glm/common.hpp>

#include <map>
#include <string>
#include <utility>

namespace halfspace {
namespace {

/// Size of head and foot, as part of running text, and how far they are from it, in parts of the leading.
constexpr double marginType = 0.85;
constexpr double headGap = 1.6;
constexpr double footGap = 2.2;

/// What turns the pages in their margins: it is none of the document.
constexpr const char *pagination = "/Artifact<</Type/Pagination>>";
constexpr const char *decoration = "/Artifact<</Type/Layout>>";

/// Writes set pages into a file.
class HandoutWriter {
public:
  HandoutWriter(const HandoutText &handout, const HandoutLook &look, const HandoutFonts &fonts)
      : m_handout(handout), m_look(look), m_fonts(fonts) {}

  std::string write() {
    setPages();
    m_document.title = m_handout.title;
    m_document.elements = m_order.elements();
    PdfFile file;
    useFonts();
    m_embedded.embed(file);
    for (std::size_t page = 0; page < m_pages.size(); ++page)
      writePage(page);
    return pdfOf(m_document, m_embedded, std::move(file));
  }

private:
  void setPages() {
    const std::size_t root = m_order.add("Document", {});
    auto front = setBlocks(m_handout.front, m_look.textWidth(), m_look, m_fonts, m_order, root);
    auto body = setBlocks(m_handout.body, m_look.columnWidth(), m_look, m_fonts, m_order, root);
    m_pages = fillPages(std::move(front), std::move(body), m_look);
    for (std::size_t i = 0; i < m_pages.size(); ++i)
      m_margins.push_back(marginsOf(i));
  }

  /// Words in the margins: the title above all pages but the first, and the page's number below.
  [[nodiscard]] std::vector<TextPart> marginsOf(std::size_t page) const {
    const double size = marginType * m_look.typeSize;
    std::vector<TextPart> parts;
    const auto put = [&](const SetWord &word, glm::dvec2 at) {
      for (const SetWord::Part &part : word.parts) {
        parts.push_back(part.text);
        parts.back().start += at;
      }
    };
    if (page > 0)
      put(setWord(m_handout.title, {.emphasized = true}, size, m_fonts),
          {m_look.side, m_look.top - headGap * m_look.leading()});
    const SetWord number = setWord(std::to_string(page + 1), {}, size, m_fonts);
    put(number,
        {(m_look.page.x - number.width) / 2, m_look.page.y - m_look.bottom + footGap * m_look.leading()});
    return parts;
  }

  void use(const TextPart &part) {
    for (const TextPart::Glyph &glyph : part.glyphs)
      m_embedded.use(*part.face, glyph.glyph);
  }

  void useFonts() {
    const Overloaded useThing{
        [&](const TextPart &text) { use(text); },
        [&](const FormulaPart &formula) { m_embedded.use(*formula.formula, m_fonts.formulas); },
        [](const RulePart &) {},
        [&](const FigurePart &figure) { m_embedded.use(*figure.drawing, m_fonts.formulas); }};
    for (const FilledPage &page : m_pages)
      for (const PlacedChunk &placed : page)
        for (const SetThing &thing : placed.chunk.things)
          std::visit(useThing, thing.content);
    for (const auto &margins : m_margins)
      for (const TextPart &part : margins)
        use(part);
  }

  void writePage(std::size_t page) {
    PdfContent content(m_look.page.y, m_embedded, m_fonts.formulas);
    for (const PlacedChunk &placed : m_pages[page]) {
      if (!placed.chunk.bookmark.empty())
        m_document.bookmarks.push_back(
            {placed.chunk.bookmark, page, m_look.page.y - placed.at.y + m_look.leading()});
      for (const SetThing &thing : placed.chunk.things)
        write(moved(thing, placed.at), page, content);
    }
    endMark(content);
    content.beginMark(pagination);
    for (const TextPart &part : m_margins[page])
      content.write(part);
    content.endMark();
    m_document.pages.push_back({m_look.page, content.text(), content.opacities()});
    m_marks = 0;
  }

  /// Things of one element that follow one another on a page are one piece of it, but for what is copied as
  /// something else.
  void write(const SetThing &thing, std::size_t page, PdfContent &content) {
    const bool goesOn =
        m_mark && m_mark->element == thing.element && !m_mark->isCopied && thing.copied.empty();
    if (!goesOn) {
      endMark(content);
      beginMark(thing, page, content);
    }
    std::visit(Overloaded{[&](const TextPart &text) { content.write(text); },
                          [&](const FormulaPart &formula) { content.writeWithoutHalo(formula); },
                          [&](const RulePart &rule) { content.fill(rule.box, rule.color); },
                          [&](const FigurePart &figure) { writeFigure(figure, *thing.element, content); }},
               thing.content);
  }

  void beginMark(const SetThing &thing, std::size_t page, PdfContent &content) {
    m_mark = OpenMark{thing.element, !thing.copied.empty()};
    if (!thing.element)
      return content.beginMark(decoration);
    // Readers look for what is copied in spans alone.
    const std::string tag = m_mark->isCopied ? "Span" : m_document.elements[*thing.element].role;
    content.beginMark("/" + tag + "<</MCID " + std::to_string(m_marks) +
                      (m_mark->isCopied ? "/ActualText" + pdfText(thing.copied) : "") + ">>");
    m_document.contents.push_back({*thing.element, page, m_marks++, thing.order});
  }

  void endMark(PdfContent &content) {
    if (std::exchange(m_mark, {}))
      content.endMark();
  }

  void writeFigure(const FigurePart &figure, std::size_t element, PdfContent &content) {
    content.write(*figure.drawing, figure.at);
    const glm::dvec2 low{figure.at.x, m_look.page.y - figure.at.y - figure.drawing->size.y};
    PixelBox &box = m_figures.try_emplace(element, PixelBox{low, low}).first->second;
    box = {glm::min(box.low, low), glm::max(box.high, low + figure.drawing->size)};
    m_document.elements[element].entries =
        figureEntries(figure.drawing->description, pdfBox(box.low, box.high));
  }

  /// A mark that is begun and not ended.
  struct OpenMark {
    std::optional<std::size_t> element;
    bool isCopied; ///< as something else than its glyphs
  };

  const HandoutText &m_handout;
  const HandoutLook &m_look;
  const HandoutFonts &m_fonts;
  ReadingOrder m_order;
  std::vector<FilledPage> m_pages;
  std::vector<std::vector<TextPart>> m_margins; ///< by pages
  PdfFonts m_embedded;
  PdfDocument m_document;
  std::optional<OpenMark> m_mark;
  int m_marks = 0;                           ///< of the page
  std::map<std::size_t, PixelBox> m_figures; ///< the boxes of figures, by their elements, in points, y up
};

} // namespace

std::string writeHandout(const HandoutText &handout, const HandoutLook &look, const HandoutFonts &fonts) {
  return HandoutWriter(handout, look, fonts).write();
}

} // namespace halfspace
