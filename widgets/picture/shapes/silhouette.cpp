#include "widgets/picture/shapes/silhouette.h"

#include "widgets/picture/shapes/mark_shapes.h"
#include "widgets/picture/shapes/mesh.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace halfspace {
namespace {

constexpr double lineRadius = 1.1; ///< in design pixels
constexpr double highlightedWidth = 1.6;
constexpr int corners = 96;

} // namespace

std::optional<Silhouette> silhouetteOf(const SphereMark &ball, const Camera &camera) {
  if (camera.orthographic)
    return Silhouette{ball.center, -camera.viewDirection(), ball.radius};
  const Place toEye = camera.eye() - ball.center;
  const double distance = glm::length(toEye);
  // A line of sight that touches, the radius to where it does, and the way to the centre: a right triangle.
  const double cosine = ball.radius / distance;
  if (!(cosine < 1))
    return {};
  const Place axis = toEye / distance;
  return Silhouette{ball.center + axis * (ball.radius * cosine), axis,
                    ball.radius * std::sqrt(1 - cosine * cosine)};
}

std::vector<Shape> silhouettesOf(const Figure &figure, const std::set<std::string> &highlighted,
                                 const Arrival &arrival, const Theme &theme, const View &view) {
  std::vector<Shape> outlines;
  for (const Mark &mark : figure.marks) {
    const auto *ball = std::get_if<SphereMark>(&mark);
    const auto circle = ball ? silhouetteOf(*ball, view.camera) : std::nullopt;
    const double unit = circle ? view.unitsPerDesignPixel(circle->center) : 0;
    const double presence = circle ? arrival.presenceOf(*ball) : 0;
    if (!(unit > 0 && presence > 0))
      continue;
    const bool standsOut = highlighted.contains(ball->id);
    const double width = lineRadius * theme.lineScale * (standsOut ? highlightedWidth : 1) * unit * presence;
    outlines.push_back(
        {ball->id, mix(theme.backgroundBottom, solidColor(*ball, theme, standsOut), presence),
         LineShape{circleAround(circle->center, circle->axis, circle->radius, corners), width, {}, true}});
  }
  return outlines;
}

} // namespace halfspace
