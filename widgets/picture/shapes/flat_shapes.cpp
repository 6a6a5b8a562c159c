#include "widgets/picture/shapes/flat_shapes.h"

#include "widgets/picture/design_scale.h"
#include "widgets/picture/screen_shapes.h"
#include "widgets/picture/shapes/mark_outline.h"
#include "widgets/picture/shapes/mark_shapes.h"
#include "widgets/picture/shapes/mesh.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace halfspace {
namespace {

constexpr double highlightWidth = 1.55;
/// Nothing foreshortens a corner here: it may be smaller than in space.
constexpr double cornerSize = 0.6 * rightAngleSize;

/// Faces lie below lines, and lines below points.
int levelOf(const Mark &mark) {
  return std::holds_alternative<PolygonMark>(mark) ? 0 : std::holds_alternative<PointMark>(mark) ? 2 : 1;
}

/// Makes the shapes of one mark.
class MarkShapes {
public:
  MarkShapes(const Mark &mark, bool standsOut, const Theme &theme, const View &view,
             std::vector<FlatShape> &shapes)
      : m_mark(mark), m_theme(theme), m_shapes(shapes),
        m_scale(designScale(view.camera, view.size, view.pixelRatio)),
        m_pixels(view.size.height / view.camera.height) {
    const MarkBase &base = baseOf(mark);
    m_color = solidColor(base, theme, standsOut);
    m_thickness = 2 * thicknessOf(base, theme, m_scale) * m_pixels * (standsOut ? highlightWidth : 1);
    const auto path = projectAll(view.camera, view.size, outlineOf(mark, cornerSize * m_scale).path);
    if (path)
      m_path.assign(path->begin(), path->end());
  }

  void add() {
    if (m_path.empty())
      return;
    if (const auto *point = std::get_if<PointMark>(&m_mark))
      m_shapes.push_back({m_path, m_color, 1, ballRadius(*point) * m_thickness, {}, false, true});
    else if (std::holds_alternative<ArrowMark>(m_mark))
      addArrow();
    else if (std::holds_alternative<PolygonMark>(m_mark))
      addFace();
    else
      addLine(m_path);
  }

private:
  void addLine(std::vector<glm::dvec2> path, bool isClosed = false) {
    const bool isAngle =
        std::holds_alternative<ArcMark>(m_mark) || std::holds_alternative<RightAngleMark>(m_mark);
    Rhythm rhythm = isAngle ? Rhythm() : rhythmOf(baseOf(m_mark), m_scale * m_pixels);
    m_shapes.push_back(
        {std::move(path), m_color, 1, strokeRadius(m_mark) * m_thickness, std::move(rhythm), isClosed});
  }

  void addFace() {
    m_shapes.push_back({m_path, m_color, m_theme.polygonOpacity});
    addLine(m_path, true);
  }

  void addArrow() {
    const glm::dvec2 way = m_path.back() - m_path.front();
    const double length = glm::length(way);
    if (length == 0)
      return; // it points at the reader
    const glm::dvec2 along = way / length;
    const ArrowHead head = headOfArrow(length, strokeRadius(m_mark) * m_thickness / 2);
    const glm::dvec2 base = m_path.back() - along * head.length;
    const glm::dvec2 side = glm::dvec2(-along.y, along.x) * head.radius;
    addLine({m_path.front(), base});
    m_shapes.push_back({{base + side, m_path.back(), base - side}, m_color});
  }

  const Mark &m_mark;
  const Theme &m_theme;
  std::vector<FlatShape> &m_shapes;
  double m_scale;
  double m_pixels; ///< of a unit
  Color m_color;
  double m_thickness = 0; ///< the pixels of a radius of 1 at scale 1, doubled
  std::vector<glm::dvec2> m_path;
};

} // namespace

std::vector<FlatShape> flatShapes(const SceneContent &content, const Theme &theme, const View &view) {
  std::vector<const Mark *> marks;
  marks.reserve(content.figure.marks.size());
  for (const Mark &mark : content.figure.marks)
    marks.push_back(&mark);
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark *a, const Mark *b) { return levelOf(*a) < levelOf(*b); });
  std::vector<FlatShape> shapes;
  for (const Mark *mark : marks)
    MarkShapes(*mark, content.highlighted.contains(baseOf(*mark).id), theme, view, shapes).add();
  return shapes;
}

} // namespace halfspace
