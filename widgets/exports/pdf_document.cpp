#include "widgets/exports/pdf_document.h"

#include "widgets/exports/page_number.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Puts a document into its file, part by part.
class DocumentWriter {
public:
  DocumentWriter(const PdfDocument &document, const PdfFonts &embedded, PdfFile file)
      : m_document(document), m_embedded(embedded), m_file(std::move(file)) {}

  std::string write() {
    writePages();
    writeElements();
    const std::string outlines = outlinesEntry();
    const int catalog =
        m_file.add("<</Type/Catalog/Pages " + pdfReference(m_tree) + "/Lang(" + m_document.language +
                   ")/MarkInfo<</Marked true>>/StructTreeRoot " + pdfReference(m_structure) + outlines +
                   "/ViewerPreferences<</DisplayDocTitle true>>>>");
    const int info = m_file.add("<</Title" + pdfText(m_document.title) + ">>");
    return m_file.bytes(catalog, info);
  }

private:
  void writePages() {
    m_tree = m_file.reserve();
    std::string kids;
    for (const PdfPage &page : m_document.pages) {
      const int content = m_file.addStream(page.content);
      m_pages.push_back(m_file.add(
          "<</Type/Page/Parent " + pdfReference(m_tree) + "/MediaBox" + pdfBox({}, page.size) + "/Contents " +
          pdfReference(content) + "/StructParents " + std::to_string(m_pages.size()) +
          "/Tabs/S/Group<</S/Transparency/CS/DeviceRGB>>/Resources<</Font<<" + m_embedded.resources() +
          ">>/ExtGState<<" + opacityEntries(page) + ">>>>>>"));
      kids += pdfReference(m_pages.back()) + " ";
    }
    m_file.put(m_tree, "<</Type/Pages/Count " + std::to_string(m_pages.size()) + "/Kids[" + kids + "]>>");
  }

  /// Objects of their own, each once: LibreOffice loses those that stand within the page.
  std::string opacityEntries(const PdfPage &page) {
    std::string entries;
    for (const auto &[name, content] : page.opacities) {
      const auto [known, isNew] = m_opacities.try_emplace(name, 0);
      if (isNew)
        known->second = m_file.add(content);
      entries += name + " " + pdfReference(known->second);
    }
    return entries;
  }

  /// What an element has in it, by its place in the order of reading.
  struct Kid {
    std::size_t order;
    std::string text;
  };

  void writeElements() {
    m_structure = m_file.reserve();
    for (std::size_t i = 0; i < m_document.elements.size(); ++i)
      m_elements.push_back(m_file.reserve());
    std::vector<std::vector<Kid>> kids(m_elements.size());
    std::string roots;
    for (std::size_t i = 0; i < m_elements.size(); ++i)
      if (const auto parent = m_document.elements[i].parent)
        kids[*parent].push_back({m_document.elements[i].order, pdfReference(m_elements[i])});
      else
        roots += pdfReference(m_elements[i]) + " ";
    for (const PdfMarkedContent &content : m_document.contents)
      kids[content.element].push_back({content.order, "<</Type/MCR/Pg " +
                                                          pdfReference(m_pages[content.page]) + "/MCID " +
                                                          std::to_string(content.mark) + ">>"});
    for (std::size_t i = 0; i < m_elements.size(); ++i)
      writeElement(i, std::move(kids[i]));
    m_file.put(m_structure,
               "<</Type/StructTreeRoot/K[" + roots + "]/ParentTree<</Nums[" + parentsOfMarks() + "]>>>>");
  }

  void writeElement(std::size_t index, std::vector<Kid> kids) {
    std::stable_sort(kids.begin(), kids.end(), [](const Kid &a, const Kid &b) { return a.order < b.order; });
    std::string list;
    for (const Kid &kid : kids)
      list += (list.empty() ? "" : " ") + kid.text;
    const PdfElement &element = m_document.elements[index];
    m_file.put(m_elements[index],
               "<</Type/StructElem/S/" + element.role + "/P " +
                   pdfReference(element.parent ? m_elements[*element.parent] : m_structure) + "/K[" + list +
                   "]" + element.entries + ">>");
  }

  /// For each page the elements of its marks.
  [[nodiscard]] std::string parentsOfMarks() const {
    std::vector<std::vector<PdfMarkedContent>> marks(m_pages.size());
    for (const PdfMarkedContent &content : m_document.contents)
      marks[content.page].push_back(content);
    std::string parents;
    for (std::size_t page = 0; page < marks.size(); ++page) {
      std::sort(marks[page].begin(), marks[page].end(),
                [](const PdfMarkedContent &a, const PdfMarkedContent &b) { return a.mark < b.mark; });
      parents += std::to_string(page) + "[";
      for (const PdfMarkedContent &content : marks[page])
        parents += pdfReference(m_elements[content.element]) + " ";
      parents += "]";
    }
    return parents;
  }

  /// The catalog's entry for the bookmarks; empty without any.
  [[nodiscard]] std::string outlinesEntry() {
    if (m_document.bookmarks.empty())
      return {};
    const int root = m_file.reserve();
    std::vector<int> items;
    for (std::size_t i = 0; i < m_document.bookmarks.size(); ++i)
      items.push_back(m_file.reserve());
    for (std::size_t i = 0; i < items.size(); ++i) {
      const PdfBookmark &bookmark = m_document.bookmarks[i];
      m_file.put(items[i], "<</Title" + pdfText(bookmark.title) + "/Parent " + pdfReference(root) +
                               (i > 0 ? "/Prev " + pdfReference(items[i - 1]) : "") +
                               (i + 1 < items.size() ? "/Next " + pdfReference(items[i + 1]) : "") +
                               "/Dest[" + pdfReference(m_pages[bookmark.page]) + "/XYZ null " +
                               pageNumber(bookmark.top) + " null]>>");
    }
    m_file.put(root, "<</Type/Outlines/First " + pdfReference(items.front()) + "/Last " +
                         pdfReference(items.back()) + "/Count " + std::to_string(items.size()) + ">>");
    return "/Outlines " + pdfReference(root) + "/PageMode/UseOutlines";
  }

  const PdfDocument &m_document;
  const PdfFonts &m_embedded;
  PdfFile m_file;
  int m_tree = 0;                         ///< the object of the pages
  int m_structure = 0;                    ///< the object that all elements hang on
  std::vector<int> m_pages;               ///< their objects
  std::map<std::string, int> m_opacities; ///< the objects of these, by name
  std::vector<int> m_elements;            ///< likewise
};

} // namespace

std::string pdfBox(glm::dvec2 low, glm::dvec2 high) {
  return "[" + pageNumbers(low) + " " + pageNumbers(high) + "]";
}

std::string pdfOf(const PdfDocument &document, const PdfFonts &embedded, PdfFile file) {
  return DocumentWriter(document, embedded, std::move(file)).write();
}

} // namespace halfspace
