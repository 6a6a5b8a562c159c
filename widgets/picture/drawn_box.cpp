#include "widgets/picture/drawn_box.h"

#include "geometry/triangle_mesh.h"
#include "widgets/picture/shapes/mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace halfspace {
namespace {

/// Collects what is drawn on a view.
class BoxOnView {
public:
  explicit BoxOnView(PixelSize size) : m_view{{}, {size.width, size.height}} {}

  void add(const PixelBox &box) {
    m_box = m_box ? PixelBox{glm::min(m_box->low, box.low), glm::max(m_box->high, box.high)} : box;
  }
  void add(glm::dvec2 pixel, double radius) { add({pixel - radius, pixel + radius}); }

  [[nodiscard]] std::optional<PixelBox> box() const {
    if (!m_box)
      return {};
    const PixelBox onView{glm::clamp(m_box->low, m_view.low, m_view.high),
                          glm::clamp(m_box->high, m_view.low, m_view.high)};
    const glm::dvec2 extent = onView.extent();
    return extent.x > 0 && extent.y > 0 ? std::optional(onView) : std::nullopt;
  }

private:
  PixelBox m_view;
  std::optional<PixelBox> m_box;
};

/// The box of shapes in space, as a view shows them.
class SpaceBox {
public:
  explicit SpaceBox(const View &view) : m_view(view), m_box(view.size) {}

  void add(const Shape &shape) {
    std::visit([this](const auto &form) { addForm(form); }, shape.form);
  }
  [[nodiscard]] std::optional<PixelBox> box() const { return m_box.box(); }

private:
  /// A ball around a place; what lies behind the eye is not seen.
  void add(const Place &place, double radius) {
    const auto seen = m_view.camera.project(place, m_view.size);
    if (seen)
      m_box.add(glm::dvec2(*seen), radius / m_view.camera.unitsPerPixel(place, m_view.size));
  }
  void add(const std::vector<Place> &places, double radius) {
    for (const Place &place : places)
      add(place, radius);
  }

  void addForm(const LineShape &line) { add(line.path, line.radius); }
  void addForm(const ArrowShape &arrow) {
    const ArrowHead head = headOfArrow(glm::length(arrow.vector), arrow.radius);
    add(arrow.from, arrow.radius);
    add(arrow.from + arrow.vector, head.radius);
  }
  void addForm(const BallShape &ball) { add(ball.center, ball.radius); }
  void addForm(const FaceShape &face) { add(face.corners, 0); }
  void addForm(const BodyShape &body) {
    for (const Place &corner : body.mesh->corners)
      add(body.origin + body.axes * corner, 0);
  }
  void addForm(const HairlineShape &hairline) { add(hairline.path, 0); }
  void addForm(const LeaderShape &leader) {
    m_box.add(leader.from, leader.width / 2);
    m_box.add(leader.to, leader.width / 2);
  }
  void addForm(const LabelShape &label) { m_box.add(label.box); }

  const View &m_view;
  BoxOnView m_box;
};

} // namespace

std::optional<PixelBox> drawnBox(const ShapeList &shapes) {
  SpaceBox box(shapes.view);
  for (const Layer layer : {Layer::Solids, Layer::Axes, Layer::Bodies, Layer::Faces, Layer::Labels})
    for (const Shape &shape : *shapes.layer(layer))
      box.add(shape);
  return box.box();
}

std::optional<PixelBox> drawnBox(const std::vector<FlatShape> &shapes, const std::vector<Shape> &labels,
                                 PixelSize size) {
  BoxOnView box(size);
  for (const FlatShape &shape : shapes)
    for (const glm::dvec2 &pixel : shape.path)
      box.add(pixel, shape.width / 2);
  forEach<LabelShape>(labels, [&](const Shape &, const LabelShape &label) { box.add(label.box); });
  return box.box();
}

} // namespace halfspace
