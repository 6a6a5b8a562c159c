#include "widgets/exports/ground_parts.h"

#include "widgets/exports/append.h"
#include "widgets/exports/page_polygon.h"
#include "widgets/exports/paper_look.h"
#include "widgets/picture/shapes/mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <tuple>

namespace halfspace {
namespace {

/// A line of the grid fades in so many steps, and is not drawn where less than half a step is left of it.
constexpr int gridSteps = 5;
/// On paper the grid needs this part of its width on a screen.
constexpr double gridPen = 0.7;
/// The corners of a ball's shadow.
constexpr int ballCorners = 24;

/// Where the light casts a place onto the ground.
Place onGround(const Place &place) { return place - shadowLight * (place.z / shadowLight.z); }

/// Collects paths that are drawn alike: each look has one part.
class AlikePaths {
public:
  PagePath &pathOf(const Color &color, double width, double opacity) {
    const auto key = std::tuple(color.red, color.green, color.blue, width, opacity);
    const auto known = m_numbers.find(key);
    if (known != m_numbers.end())
      return m_parts[known->second].path;
    m_numbers.emplace(key, m_parts.size());
    m_parts.push_back({{}, {}, Pen{color, width, {}, 0, Pen::Cap::Flat, opacity}});
    return m_parts.back().path;
  }
  [[nodiscard]] std::vector<PathPart> take() { return std::move(m_parts); }

private:
  std::map<std::tuple<int, int, int, double, double>, std::size_t> m_numbers;
  std::vector<PathPart> m_parts;
};

/// A straight piece as far as it is seen; goes on with the path where it begins at its end.
void addPiece(PagePath &path, const Place &from, const Place &to, const Paper &paper) {
  const auto seen = paper.seenPart(from, to);
  if (!seen)
    return;
  const glm::dvec2 begin = paper.spotOf(glm::mix(from, to, seen->first)).at;
  if (path.steps.empty() || path.steps.back().to != begin)
    path.moveTo(begin);
  path.lineTo(paper.spotOf(glm::mix(from, to, seen->second)).at);
}

int stepOf(double strength) { return static_cast<int>(std::lround(strength * gridSteps)); }

/// The pieces of a straight line that have more or less of its colour.
void addHairline(AlikePaths &grid, const Shape &shape, const HairlineShape &line, const Paper &paper) {
  const double width = line.width * gridPen * paper.pointsPerPixel();
  const auto stepAt = [&](std::size_t i) { return stepOf((line.strengths[i] + line.strengths[i + 1]) / 2); };
  for (std::size_t i = 0; i + 1 < line.path.size();) {
    std::size_t end = i + 1;
    while (end + 1 < line.path.size() && stepAt(end) == stepAt(i))
      ++end;
    if (const int step = stepAt(i); step > 0)
      addPiece(grid.pathOf(shape.color, width, static_cast<double>(step) / gridSteps), line.path[i],
               line.path[end], paper);
    i = end;
  }
}

/// The shadows of one colour.
class ShadowPainter {
public:
  ShadowPainter(const Paper &paper, Color color) : m_paper(paper), m_color(color) {}

  void paint(const LineShape &line) { addLine(line.path, line.isClosed, line.radius); }
  void paint(const ArrowShape &arrow) {
    const double length = glm::length(arrow.vector);
    if (!(length > 0))
      return;
    const Place tip = arrow.from + arrow.vector;
    const ArrowHead head = headOfArrow(length, arrow.radius * penPerTube);
    const Place neck = tip - arrow.vector * (head.length / length);
    addLine({arrow.from, neck}, false, arrow.radius);
    std::vector<Place> outline = circleAround(neck, arrow.vector / length, head.radius, ballCorners);
    outline.push_back(tip);
    addOutline(outline);
  }
  void paint(const BallShape &ball) {
    const Place light = glm::normalize(shadowLight);
    addOutline(circleAround(ball.center, light, ball.radius * discPerBall, ballCorners));
  }
  void paint(const FaceShape &face) { addOutline(face.corners); }
  // These cast none here.
  void paint(const BodyShape &) {}
  void paint(const HairlineShape &) {}
  void paint(const LeaderShape &) {}
  void paint(const LabelShape &) {}

  [[nodiscard]] std::vector<PathPart> take() {
    std::vector<PathPart> parts = m_lines.take();
    if (!m_outlines.steps.empty())
      parts.push_back({std::move(m_outlines), Fill{m_color}});
    return parts;
  }

private:
  void addLine(const std::vector<Place> &path, bool isClosed, double radius) {
    PagePath &lines = m_lines.pathOf(m_color, 2 * radius * penPerTube * m_paper.pointsPerUnit(), 1);
    const std::size_t pieces = path.size() - (isClosed || path.empty() ? 0 : 1);
    for (std::size_t i = 0; i < pieces; ++i)
      addPiece(lines, onGround(path[i]), onGround(path[(i + 1) % path.size()]), m_paper);
  }

  /// All outlines turn one way, so that none takes another away.
  void addOutline(std::vector<Place> places) {
    std::transform(places.begin(), places.end(), places.begin(), onGround);
    std::vector<glm::dvec2> spots;
    for (const Place &place : m_paper.seenPart(std::move(places)))
      spots.push_back(m_paper.spotOf(place).at);
    if (spots.size() > 2)
      m_outlines.append(straightPath(hullOf(std::move(spots)), true));
  }

  const Paper &m_paper;
  Color m_color;
  AlikePaths m_lines;
  PagePath m_outlines;
};

std::vector<PathPart> shadowsOf(const std::vector<Shape> &shapes, Color color, const Paper &paper) {
  ShadowPainter painter(paper, color);
  for (const Shape &shape : shapes)
    std::visit([&](const auto &form) { painter.paint(form); }, shape.form);
  return painter.take();
}

} // namespace

std::vector<PathPart> groundParts(const ShapeList &list, const Paper &paper) {
  std::vector<PathPart> parts;
  if (list.shadows) {
    append(parts, shadowsOf(*list.layer(Layer::Faces), list.shadows->ofFaces, paper));
    append(parts, shadowsOf(*list.layer(Layer::Solids), list.shadows->ofSolids, paper));
  }
  AlikePaths grid;
  forEach<HairlineShape>(*list.layer(Layer::Ground), [&](const Shape &shape, const HairlineShape &line) {
    addHairline(grid, shape, line, paper);
  });
  append(parts, grid.take());
  return parts;
}

} // namespace halfspace
