#include "widgets/scene/figure_scene.h"

#include "widgets/picture/design_scale.h"
#include "widgets/picture/hand/mark_picker.h"
#include "widgets/picture/shapes/mark_mesh.h"
#include "widgets/picture/shapes/mark_outline.h"
#include "widgets/picture/shapes/silhouette.h"
#include "widgets/picture/shapes/surface_layers.h"
#include "widgets/scene/label_overlay.h"
#include "widgets/scene/scene_actors.h"
#include "widgets/scene/vtk_mesh.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// Near and far clipping planes keep this distance, in parts of the depth, from what they enclose …
constexpr double clippingMargin = 0.02;
/// … and the near one is never nearer than this part of the far one: depth values are too coarse otherwise.
constexpr double leastNearPerFar = 1e-4;
/// What lies farther away than so many times the distance of the target is cut off, so that the near plane
/// never cuts off what the camera looks at.
constexpr double farthestPerDistance = 1000;

/// All corners and ends of a figure's marks.
std::vector<Place> placesOf(const Figure &figure, double scale) {
  std::vector<Place> places;
  for (const Mark &mark : figure.marks) {
    const MarkOutline outline = outlineOf(mark, rightAngleSize * scale);
    places.insert(places.end(), outline.path.begin(), outline.path.end());
  }
  return places;
}

} // namespace

class FigureScene::Impl {
public:
  explicit Impl(LabelPainter painter) : labels(actors.renderer(), std::move(painter)) {}

  void prepare();
  void showStrip(int top, int height);
  [[nodiscard]] bool leavesOutSurfaces() const { return m_thinned || actors.bodies().leaveOutTriangles(); }

  SceneActors actors;
  LabelOverlay labels;
  Theme theme = themes().front();
  SceneContent content;
  View view;
  bool backgroundVisible = true;
  bool themeChanged = true;
  bool contentChanged = true;
  bool toolsChanged = true;
  bool viewChanged = true;

private:
  [[nodiscard]] double scale() const { return designScale(view.camera, view.size, view.pixelRatio); }
  void prepareFigure();
  [[nodiscard]] const Figure &drawn() const { return m_thinned ? *m_thinned : content.figure; }
  void prepareFaceOrder();
  void prepareGround();
  void prepareTools();
  void prepareCamera();
  [[nodiscard]] std::vector<AxisLabel> labelsOfAxes() const;

  /// What the grid depends on.
  struct GridKey {
    Place target{};
    double height = 0;
    bool ground = true;
    bool operator==(const GridKey &) const = default;
  };

  /// What the axes' mesh depends on: their ticks turn to the camera.
  struct AxesKey {
    std::optional<AxesReach> reach;
    Camera camera;
    double scale = 0;
    bool operator==(const AxesKey &) const = default;
  };

  std::optional<Figure> m_thinned; ///< drawn instead of a figure with too many faces
  FaceOrder m_faces;
  std::optional<AxesReach> m_axes;    ///< where there are any
  std::optional<GridKey> m_grid;      ///< what it was made for
  std::optional<AxesKey> m_shownAxes; ///< likewise
  std::optional<double> m_solidScale; ///< what the solids were made for
  std::vector<Place> m_places;        ///< of the figure
};

void FigureScene::Impl::prepare() {
  const bool sizesChanged = m_solidScale != scale();
  if (themeChanged)
    actors.applyTheme(theme);
  if (contentChanged) {
    m_thinned = thinned(content.figure, content.highlighted);
    m_axes = content.stage.hasAxes() ? std::optional(axesAround(content.figure)) : std::nullopt;
  }
  if (themeChanged || contentChanged || sizesChanged)
    prepareFigure();
  const bool lookChanged = themeChanged || contentChanged || viewChanged;
  if (lookChanged) {
    prepareFaceOrder();
    prepareGround();
    prepareCamera();
  }
  if (lookChanged || toolsChanged)
    prepareTools();
  if (lookChanged || toolsChanged)
    labels.show(labelTexts(content, labelsOfAxes(), theme, view), obstaclesOf(content, m_axes, theme, view),
                theme, view);
  themeChanged = contentChanged = toolsChanged = viewChanged = false;
  showStrip(0, view.size.height);
}

std::vector<AxisLabel> FigureScene::Impl::labelsOfAxes() const {
  return m_axes ? axisLabels(*m_axes, view.camera, content.stage.exponent, scale())
                : std::vector<AxisLabel>();
}

void FigureScene::Impl::showStrip(int top, int height) {
  const double part = static_cast<double>(height) / view.size.height;
  const double middle = top + height / 2.0;
  const int below = view.size.height - top - height;
  vtkCamera *vtk = actors.renderer()->GetActiveCamera();
  vtk->SetViewAngle(glm::degrees(2 * std::atan(std::tan(Camera::viewAngle / 2) * part)));
  vtk->SetParallelScale(view.camera.height / 2 * part);
  vtk->SetWindowCenter(0, (view.size.height / 2.0 - middle) / (height / 2.0));
  labels.lowerBy(below);
  actors.showBackground(theme, backgroundVisible, static_cast<double>(below) / view.size.height,
                        1 - static_cast<double>(top) / view.size.height);
}

void FigureScene::Impl::prepareFigure() {
  m_solidScale = scale();
  m_places = placesOf(content.figure, scale());
  write(meshOf(drawn(), content.highlighted, theme, scale(), content.arrival), actors.solids());
  actors.bodies().show(content.figure, content.highlighted, theme, content.arrival);
  m_faces = FaceOrder(facesOf(drawn(), content.highlighted, theme, content.arrival));
}

void FigureScene::Impl::prepareFaceOrder() {
  const glm::dvec4 eye = view.camera.orthographic ? glm::dvec4(-view.camera.viewDirection(), 0)
                                                  : glm::dvec4(view.camera.eye(), 1);
  write(m_faces.backToFront(eye), actors.faces());
}

void FigureScene::Impl::prepareGround() {
  // Turning the camera changes no grid.
  const bool ground = content.stage.hasGround();
  const GridKey key{view.camera.target, view.camera.height, ground};
  if (themeChanged || m_grid != key) {
    m_grid = key;
    write(ground ? gridAround(view.camera) : Grid(), theme, actors.grid());
  }
  actors.setGridLineWidth(theme.lineScale * view.pixelRatio);
  const AxesKey axesKey{m_axes, view.camera, scale()};
  if (themeChanged || m_shownAxes != axesKey) {
    m_shownAxes = axesKey;
    write(m_axes ? axesMesh(*m_axes, view.camera, theme, scale()) : Mesh(), actors.axes());
  }
  // Seen from below, shadows on the ground would only cover what casts them. Their colour is that of a
  // darkened background: where there is none they would be patches on whatever lies behind the picture.
  actors.setShadowsVisible(ground && content.hasShadows && backgroundVisible && view.camera.eye().z > 0);
}

void FigureScene::Impl::prepareTools() {
  Mesh mesh = toolsMesh(content, theme, view);
  addSilhouettes(mesh, drawn(), content.highlighted, content.arrival, theme, view);
  write(mesh, actors.tools());
}

void FigureScene::Impl::prepareCamera() {
  const Camera &camera = view.camera;
  vtkCamera *vtk = actors.renderer()->GetActiveCamera();
  const Place eye = camera.eye();
  const Place up = camera.up();
  vtk->SetPosition(eye.x, eye.y, eye.z);
  vtk->SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
  vtk->SetViewUp(up.x, up.y, up.z);
  vtk->SetParallelProjection(camera.orthographic);

  // Everything from the nearest to the farthest place, with room for thicknesses, the grid and what a hand
  // holds.
  double nearest = camera.distance();
  double farthest = nearest;
  const double around = camera.height;
  const auto enclose = [&](Place place, double margin) {
    const double depth = glm::dot(place - eye, camera.viewDirection());
    nearest = std::min(nearest, depth - margin);
    farthest = std::max(farthest, depth + margin);
  };
  enclose(Place(camera.target.x, camera.target.y, 0), around);
  if (m_axes) {
    enclose(m_axes->low, around / 4);
    enclose(m_axes->high, around / 4);
    enclose(Place(0), std::max({m_axes->high.x, m_axes->high.y, m_axes->high.z}));
  }
  for (const Place &place : m_places) {
    enclose(place, around / 8);
    enclose({place.x, place.y, 0}, around / 8);
  }
  for (const Knob &knob : content.knobs)
    enclose(knob.at, around / 4);
  if (content.gizmo)
    enclose(content.gizmo->at, around / 4);
  farthest = std::min(farthest * (1 + clippingMargin), camera.distance() * farthestPerDistance);
  vtk->SetClippingRange(std::max(nearest * (1 - clippingMargin), farthest * leastNearPerFar), farthest);
}

FigureScene::FigureScene(LabelPainter labels) : m_impl(std::make_unique<Impl>(std::move(labels))) {}
FigureScene::~FigureScene() = default;

vtkRenderer *FigureScene::renderer() const { return m_impl->actors.renderer(); }

void FigureScene::setTheme(const Theme &theme) {
  m_impl->themeChanged = m_impl->themeChanged || !(theme == m_impl->theme);
  m_impl->theme = theme;
}

void FigureScene::setBackgroundVisible(bool visible) {
  m_impl->backgroundVisible = visible; // showStrip, which always runs, takes it up
}

void FigureScene::setContent(SceneContent content) {
  m_impl->content = std::move(content);
  m_impl->contentChanged = true;
}

void FigureScene::setTools(std::optional<Gizmo> gizmo, std::vector<Knob> knobs) {
  SceneContent &content = m_impl->content;
  if (gizmo == content.gizmo && knobs == content.knobs)
    return;
  content.gizmo = std::move(gizmo);
  content.knobs = std::move(knobs);
  m_impl->toolsChanged = true;
}

void FigureScene::setView(View view) {
  view.size = {std::max(view.size.width, 1), std::max(view.size.height, 1)};
  m_impl->viewChanged = m_impl->viewChanged || !(view == m_impl->view);
  m_impl->view = std::move(view);
}

void FigureScene::prepare() { m_impl->prepare(); }

bool FigureScene::leavesOutSurfaces() const { return m_impl->leavesOutSurfaces(); }

void FigureScene::showStrip(int top, int height) { m_impl->showStrip(top, height); }

std::string FigureScene::markAt(glm::dvec2 pixel) const {
  const std::string labelled = m_impl->labels.markAt(pixel);
  if (!labelled.empty())
    return labelled;
  const View &view = m_impl->view;
  return markUnder(pixel, m_impl->content.figure, view.camera, view.size, view.pixelRatio);
}

} // namespace halfspace
