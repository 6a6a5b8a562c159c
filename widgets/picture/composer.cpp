#include "widgets/picture/composer.h"

#include "widgets/picture/design_scale.h"
#include "widgets/picture/drop_lines.h"
#include "widgets/picture/hand/label_hand.h"
#include "widgets/picture/hand/mark_picker.h"
#include "widgets/picture/screen_shapes.h"
#include "widgets/picture/shapes/mark_outline.h"
#include "widgets/picture/shapes/mark_shapes.h"
#include "widgets/picture/shapes/silhouette.h"
#include "widgets/picture/shapes/surface_layers.h"
#include "widgets/picture/shapes/tool_shapes.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace halfspace {
namespace {

/// How pale the shadows of translucent faces are beside those of what is solid.
constexpr double faceShadowPaleness = 0.55;

/// All corners and ends of a figure's marks.
std::vector<Place> outlinesOf(const Figure &figure, double scale) {
  std::vector<Place> places;
  for (const Mark &mark : figure.marks) {
    const MarkOutline outline = outlineOf(mark, rightAngleSize * scale);
    places.insert(places.end(), outline.path.begin(), outline.path.end());
  }
  return places;
}

} // namespace

Composer::Composer(LabelSetter set) : m_set(std::move(set)), m_theme(themes().front()) {
  m_list.layers.fill(std::make_shared<const std::vector<Shape>>());
}

void Composer::setTheme(const Theme &theme) {
  m_changes.theme = m_changes.theme || !(theme == m_theme);
  m_theme = theme;
}

void Composer::setBackgroundVisible(bool visible) { m_isBackgroundVisible = visible; }

void Composer::setContent(SceneContent content) {
  m_content = std::move(content);
  if (m_content.shown.dropLines && m_content.stage.hasGround())
    addDropLines(m_content.figure);
  m_changes.content = true;
}

void Composer::setTools(std::optional<Gizmo> gizmo, std::vector<Knob> knobs) {
  if (gizmo == m_content.gizmo && knobs == m_content.knobs)
    return;
  m_content.gizmo = std::move(gizmo);
  m_content.knobs = std::move(knobs);
  m_changes.tools = true;
}

bool Composer::setView(View view) {
  view.size = {std::max(view.size.width, 1), std::max(view.size.height, 1)};
  if (view == m_view)
    return false;
  m_view = std::move(view);
  m_changes.view = true;
  return true;
}

void Composer::forgetLabels() {
  m_page = {};
  m_changes.view = true;
}

const ShapeList &Composer::compose() {
  const Changes changes = std::exchange(m_changes, {false, false, false, false});
  const bool lookChanged = changes.theme || changes.content || changes.view;
  if (changes.theme)
    m_grid.reset();
  if (changes.content)
    workOutContent();
  if (changes.theme || changes.content || m_worked.scale != scale())
    composeFigure();
  if (lookChanged) {
    composeFaces();
    composeGround();
    composeAxes();
    m_list.view = m_view;
    m_list.depths = depthsOf(m_worked.places, m_worked.axes, m_content, m_view.camera);
  }
  if (lookChanged || changes.tools) {
    put(Layer::Tools, toolsOf(m_content, m_theme, m_view));
    composeLabels();
  }
  m_list.background = {m_theme.backgroundBottom, m_theme.backgroundTop, m_isBackgroundVisible};
  m_list.shadows = shadows();
  return m_list;
}

std::string Composer::markAt(glm::dvec2 pixel) const {
  if (const Shape *label = labelUnder(pixel, m_list))
    return label->mark;
  return markUnder(pixel, m_content.figure, m_view.camera, m_view.size, m_view.pixelRatio);
}

void Composer::put(Layer layer, std::vector<Shape> shapes) {
  ShapeLayer &there = m_list.layer(layer);
  if (*there != shapes)
    there = std::make_shared<const std::vector<Shape>>(std::move(shapes));
}

double Composer::scale() const { return designScale(m_view.camera, m_view.size, m_view.pixelRatio); }

void Composer::workOutContent() {
  m_worked.thinned = thinned(m_content.figure, m_content.highlighted);
  m_worked.axes = m_content.showsAxes() ? std::optional(axesAround(m_content.figure)) : std::nullopt;
}

void Composer::composeFigure() {
  m_worked.scale = scale();
  m_worked.places = outlinesOf(m_content.figure, scale());
  m_worked.faces = FaceOrder(facesOf(drawn(), m_content.highlighted, m_theme, m_content.arrival));
  put(Layer::Solids, solidsOf(drawn(), m_content.highlighted, m_theme, scale(), m_content.arrival));
  composeBodies();
}

void Composer::composeBodies() {
  std::vector<Shape> bodies = bodiesOf(m_content.figure, m_content.highlighted, m_theme, m_content.arrival);
  m_list.leavesOutSurfaces = m_worked.thinned.has_value();
  std::map<SharedMesh, std::size_t> strides;
  for (Shape &shape : bodies) {
    auto &body = std::get<BodyShape>(shape.form);
    const auto known = m_strides.find(body.mesh);
    body.stride = known != m_strides.end() ? known->second : strideFor(meshLayersOf(*body.mesh));
    strides.emplace(body.mesh, body.stride);
    m_list.leavesOutSurfaces = m_list.leavesOutSurfaces || body.stride > 1;
  }
  m_strides = std::move(strides);
  put(Layer::Bodies, std::move(bodies));
}

void Composer::composeFaces() {
  const Camera &camera = m_view.camera;
  const glm::dvec4 eye =
      camera.orthographic ? glm::dvec4(-camera.viewDirection(), 0) : glm::dvec4(camera.eye(), 1);
  const std::vector<const Face *> inOrder = m_worked.faces.backToFront(eye);
  std::vector<Shape> faces;
  faces.reserve(inOrder.size());
  for (const Face *face : inOrder)
    faces.push_back({baseOf(drawn().marks[face->mark]).id, face->color,
                     FaceShape{face->corners, face->opacity, face->globe}});
  put(Layer::Faces, std::move(faces));
}

void Composer::composeGround() {
  if (!m_content.stage.hasGround() || !m_content.shown.grid) {
    m_grid.reset();
    return put(Layer::Ground, {});
  }
  // Turning the camera changes no grid.
  const GridKey key{m_view.camera.target, m_view.camera.height, m_theme.lineScale * m_view.pixelRatio};
  if (std::exchange(m_grid, key) != key)
    put(Layer::Ground, shapesOf(gridAround(m_view.camera), m_theme, key.lineWidth));
}

void Composer::composeAxes() {
  std::vector<Shape> shapes;
  if (m_worked.axes)
    shapes = axesOf(*m_worked.axes, m_view.camera, m_theme, scale());
  std::vector<Shape> outlines =
      silhouettesOf(drawn(), m_content.highlighted, m_content.arrival, m_theme, m_view);
  std::move(outlines.begin(), outlines.end(), std::back_inserter(shapes));
  put(Layer::Axes, std::move(shapes));
}

void Composer::composeLabels() {
  std::vector<AxisLabel> ofAxes;
  if (m_worked.axes)
    ofAxes = axisLabels(*m_worked.axes, m_view.camera, m_content.stage.exponent, scale());
  const auto labels = m_page.place(writtenLabels(m_content, ofAxes, m_theme, m_view),
                                   obstaclesOf(m_content, m_worked.axes, m_theme, m_view), m_set, m_view);
  put(Layer::Labels, shapesOf(labels, m_theme.mutedInk, leaderWidth * m_view.pixelRatio));
}

std::optional<Shadows> Composer::shadows() const {
  // Seen from below, shadows on the ground would only cover what casts them. Their colour is that of a
  // darkened background: where there is none they would be patches on whatever lies behind the picture.
  const bool areWanted = m_content.hasShadows && m_content.shown.shadows;
  if (!areWanted || !m_content.stage.hasGround() || !m_isBackgroundVisible || m_view.camera.eye().z <= 0)
    return {};
  return Shadows{m_theme.shadow, mix(m_theme.shadow, m_theme.backgroundBottom, faceShadowPaleness)};
}

} // namespace halfspace
