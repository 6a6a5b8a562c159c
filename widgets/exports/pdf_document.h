// A PDF file of pages with what their content means: its structure, and a way to its parts.
#pragma once

#include "widgets/exports/pdf_fonts.h"

#include <glm/vec2.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace halfspace {

struct PdfPage {
  glm::dvec2 size{};                              ///< in points
  std::string content{};                          ///< as PdfContent writes it
  std::map<std::string, std::string> opacities{}; ///< likewise
};

/// A part of the document as the format has it: a paragraph, a figure.
struct PdfElement {
  std::string role;                    ///< P, H1, Figure …
  std::optional<std::size_t> parent{}; ///< that it stands in, which comes before it; nothing: the document
  std::string entries{};               ///< of its dictionary besides: /Alt and its like
  std::size_t order = 0;               ///< its place among all elements and content, in the order of reading
};

/// What stands on a page between the beginning and the end of a mark with a number, and is a piece of an
/// element.
struct PdfMarkedContent {
  std::size_t element = 0;
  std::size_t page = 0;
  int mark = 0; ///< those of a page count from 0
  std::size_t order = 0;
};

struct PdfBookmark {
  std::string title;
  std::size_t page = 0;
  double top = 0; ///< the y that it leads to, in points from the page's lower end
};

struct PdfDocument {
  std::string title{};
  std::string language = "en";
  std::vector<PdfPage> pages{};
  std::vector<PdfElement> elements{};
  std::vector<PdfMarkedContent> contents{};
  std::vector<PdfBookmark> bookmarks{};
};

/// The whole file; `file` has the fonts of all pages already. The same document gives the same bytes.
[[nodiscard]] std::string pdfOf(const PdfDocument &document, const PdfFonts &embedded, PdfFile file);

/// `[0 0 595 842]`: a rectangle by two of its corners.
[[nodiscard]] std::string pdfBox(glm::dvec2 low, glm::dvec2 high);

} // namespace halfspace
