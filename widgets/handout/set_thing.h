// What stands on the pages of a handout, set in type.
#pragma once

#include "widgets/exports/pdf_content.h"
#include "widgets/exports/pdf_document.h"

#include <memory>
#include <variant>

namespace halfspace {

struct RulePart {
  math::Rectangle box;
  Color color;
};

/// A figure with its left top corner at a place.
struct FigurePart {
  std::shared_ptr<const Drawing> drawing; ///< never null
  glm::dvec2 at{};
};

/// Something in its place, with the element of the document that it belongs to.
struct SetThing {
  using Content = std::variant<TextPart, FormulaPart, RulePart, FigurePart>;
  Content content;
  std::optional<std::size_t> element{}; ///< nothing: it says nothing, as a rule between rows
  std::size_t order = 0;                ///< see PdfElement
  std::string copied{}; ///< what is read and copied of it; empty: the characters of its glyphs
};

/// The same farther to the right and down.
[[nodiscard]] SetThing moved(SetThing thing, glm::dvec2 by);

/// A piece of a column that is not broken. Its things are in their places from its left top corner.
struct Chunk {
  double gapAbove = 0; ///< falls away at the top of a column
  double height = 0;
  bool keepsWithNext = false; ///< the next begins in the same column
  bool floats = false;        ///< where it finds no room in its column, what follows goes before it
  std::vector<SetThing> things{};
  std::string bookmark{}; ///< leads here; empty: none
};

/// Collects the elements of a document and counts their content in the order of reading.
class ReadingOrder {
public:
  std::size_t add(std::string role, std::optional<std::size_t> parent, std::string entries = {});
  [[nodiscard]] std::size_t next() { return m_next++; }
  [[nodiscard]] const std::vector<PdfElement> &elements() const { return m_elements; }

private:
  std::vector<PdfElement> m_elements;
  std::size_t m_next = 0;
};

} // namespace halfspace
