#include "widgets/exports/pdf_writer.h"

#include "widgets/exports/pdf_content.h"
#include "widgets/exports/pdf_document.h"

namespace halfspace {

std::string figureEntries(const std::string &description, const std::string &box) {
  return "/Alt" + pdfText(description) + "/A<</O/Layout/Placement/Block/BBox" + box + ">>";
}

std::string pdfOf(const Drawing &drawing, const math::MathFonts &fonts) {
  PdfFile file;
  PdfFonts embedded;
  embedded.use(drawing, fonts);
  embedded.embed(file);
  PdfContent content(drawing.size.y, embedded, fonts);
  content.beginMark("/Figure<</MCID 0>>");
  content.write(drawing, {});
  content.endMark();

  PdfDocument document;
  document.title = drawing.title;
  document.language = drawing.language;
  document.pages.push_back({drawing.size, content.text(), content.opacities()});
  document.elements.push_back({"Figure", {}, figureEntries(drawing.description, pdfBox({}, drawing.size))});
  document.contents.push_back({});
  return pdfOf(document, embedded, std::move(file));
}

} // namespace halfspace
