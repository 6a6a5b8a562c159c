// What a picture is made of: a closed set of shapes. Places and lengths in space are in units of the stage;
// what lies on the page is in pixels of the picture, from its top left corner.
#pragma once

#include "widgets/picture/camera.h"
#include "widgets/picture/labels/label_picture.h"
#include "widgets/picture/shapes/rhythm.h"

#include <glm/mat3x3.hpp>

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace halfspace {

/// How a line fades that goes on beyond what is drawn of it: evenly, down to `fadedStrength` of its own
/// colour in another.
struct LineFade {
  Color into;
  double length = 0;         ///< before the end
  bool isAtBothEnds = false; ///< else at its last place
  bool operator==(const LineFade &) const = default;
};
inline constexpr double fadedStrength = 0.12;

/// A round line in space, with flat ends.
struct LineShape {
  std::vector<Place> path;
  double radius = 0;
  Rhythm rhythm{};                ///< of each straight piece of the path; empty: it is whole
  bool isClosed = false;          ///< its last place is joined to the first
  std::optional<LineFade> fade{}; ///< of a line between two places
  bool operator==(const LineShape &) const = default;
};

/// A line with a head in proportion to its radius (see headOfArrow).
struct ArrowShape {
  Place from{};
  Place vector{};
  double radius = 0; ///< of its shaft
  Rhythm rhythm{};   ///< of its shaft
  bool operator==(const ArrowShape &) const = default;
};

struct BallShape {
  Place center{};
  double radius = 0;
  bool isOneOfMany = false; ///< of so many that nobody looks at each: they may be drawn coarsely
  bool operator==(const BallShape &) const = default;
};

/// The surface of a ball that is seen through.
struct Globe {
  Place center{};
  double radius = 0;
  bool operator==(const Globe &) const = default;
};

/// A flat convex polygon, seen from both sides.
struct FaceShape {
  std::vector<Place> corners;
  double opacity = 1;
  std::optional<Globe> globe{}; ///< that it is a piece of
  bool operator==(const FaceShape &) const = default;
};

/// A surface of very many triangles.
struct BodyShape {
  std::shared_ptr<const TriangleMesh> mesh; ///< in a space of its own
  glm::dmat3 axes{1};                       ///< that space's axes on the stage
  Place origin{};                           ///< and its origin
  std::size_t stride = 1;                   ///< one triangle in so many is drawn
  bool operator==(const BodyShape &) const = default;
};

/// A line in space that is as thin wherever it is, and has more or less of its colour along its path.
struct HairlineShape {
  std::vector<Place> path;
  std::vector<double> strengths; ///< at each of its places: 0, nothing of its colour, to 1
  double width = 1;              ///< in pixels of the picture
  bool operator==(const HairlineShape &) const = default;
};

/// A line on the page that leads from what is named to its label.
struct LeaderShape {
  glm::dvec2 from{};
  glm::dvec2 to{};
  double width = 1;
  bool operator==(const LeaderShape &) const = default;
};

/// A formula on the page, in the colours of its style.
struct LabelShape {
  std::string latex;
  LabelFormula formula; ///< the same, set in type; never null
  LabelStyle style;
  PixelBox box; ///< its room (see roomOf), in whole pixels
  double opacity = 1;
  std::optional<glm::dvec2> anchor{}; ///< the pixel that its place by hand counts from; only a mark's has one
  bool operator==(const LabelShape &) const = default;
};

using ShapeForm = std::variant<LineShape, ArrowShape, BallShape, FaceShape, BodyShape, HairlineShape,
                               LeaderShape, LabelShape>;

struct Shape {
  std::string mark; ///< the id of the mark that it is of; empty: of none
  Color color;
  ShapeForm form;
  bool operator==(const Shape &) const = default;
};

/// Calls `visit(shape, form)` for each shape of a form.
template <class Form, class Visit> void forEach(const std::vector<Shape> &shapes, Visit visit) {
  for (const Shape &shape : shapes)
    if (const auto *form = std::get_if<Form>(&shape.form))
      visit(shape, *form);
}

} // namespace halfspace
