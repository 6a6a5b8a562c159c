// A figure on paper: a plain value that writers turn into files. Lengths are in points (1/72 inch), y points
// down, the origin is the top left corner of the page.
#pragma once

#include "widgets/exports/page_path.h"
#include "widgets/picture/labels/label_picture.h"
#include "widgets/picture/shapes/rhythm.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace halfspace {

struct Fill {
  Color color;
  double opacity = 1;
  bool operator==(const Fill &) const = default;
};

/// Corners are round.
struct Pen {
  enum class Cap { Flat, Round };

  Color color;
  double width = 1;
  Rhythm dashes{};      ///< empty: the line is whole
  double dashStart = 0; ///< how far into the rhythm the line begins
  Cap cap = Cap::Round;
  double opacity = 1;
};

/// A path that is filled (by the nonzero rule), drawn with a pen, or both.
struct PathPart {
  PagePath path;
  std::optional<Fill> fill{};
  std::optional<Pen> pen{};
  std::string mark{};    ///< the id of the mark that it is of; empty: of none
  bool isHidden = false; ///< something stands before it
};

/// A formula in its ink on its halo.
struct FormulaPart {
  std::string latex;
  std::string plain;    ///< the same in one line of plain text
  LabelFormula formula; ///< the same, set in type; never null
  glm::dvec2 start{};   ///< the left end of its baseline
  double size = 0;      ///< of its type: the length of an em
  Color ink;
  Color halo; ///< reaches `haloWidth` around the strokes
  double opacity = 1;
  std::string mark{};
};

using DrawingPart = std::variant<PathPart, FormulaPart>;

struct Drawing {
  glm::dvec2 size{}; ///< of the page
  std::optional<Color> ground{};
  std::vector<DrawingPart> parts{}; ///< in the order in which they are painted
  bool leavesOutSurfaces = false;   ///< as `ShapeList` has it
  std::string title{};
  std::string description{};   ///< what is to be seen, in a sentence
  std::string language = "en"; ///< that both are written in
};

/// The part of a drawing that lies on a smaller page, which has this corner and size on its own.
[[nodiscard]] Drawing partOf(Drawing drawing, glm::dvec2 corner, glm::dvec2 size);

} // namespace halfspace
