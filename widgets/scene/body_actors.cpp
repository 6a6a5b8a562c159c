#include "widgets/scene/body_actors.h"

#include "geometry/triangle_mesh.h"
#include "widgets/picture/shapes/mark_mesh.h"
#include "widgets/picture/shapes/surface_layers.h"
#include "widgets/scene/depthless_mapper.h"
#include "widgets/scene/vtk_mesh.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// Whole surfaces in the colour of lines would be too dark: they take so much of it.
constexpr double bodyInk = 0.55;

void write(const MeshMark &mark, vtkMatrix4x4 *matrix) {
  for (glm::length_t column = 0; column < 3; ++column)
    for (glm::length_t row = 0; row < 3; ++row)
      matrix->SetElement(row, column, mark.axes[column][row]);
  for (glm::length_t row = 0; row < 3; ++row)
    matrix->SetElement(row, 3, mark.place[row]);
}

void setColor(vtkActor *actor, Color color) {
  actor->GetProperty()->SetColor(color.red / 255.0, color.green / 255.0, color.blue / 255.0);
}

/// The renderer draws in the order of its list, whose end is where it adds.
void addBefore(vtkProp &next, vtkActor *actor, vtkRenderer &renderer) {
  renderer.AddActor(actor);
  vtkPropCollection *inOrder = renderer.GetViewProps();
  inOrder->RemoveItem(actor);
  const int place = inOrder->IsItemPresent(&next) - 1;
  inOrder->InsertItem(place - 1, actor); // behind the one before
}

} // namespace

struct BodyActors::Body {
  Body() {
    mapper->SetInputData(data);
    shadowMapper->SetInputData(data);
    actor->SetMapper(mapper);
    shadow->SetMapper(shadowMapper);
    actor->SetUserMatrix(placement);
    shadow->SetUserMatrix(shadowPlacement);
    // Flat faces: a hit is in one of them.
    actor->GetProperty()->SetInterpolationToFlat();
    actor->GetProperty()->SetAmbient(0.42);
    actor->GetProperty()->SetDiffuse(0.70);
    shadow->GetProperty()->LightingOff();
    shadow->ForceOpaqueOn();
  }

  void take(const std::shared_ptr<const TriangleMesh> &shown) {
    if (std::exchange(mesh, shown) == shown)
      return;
    stride = strideFor(meshLayersOf(*mesh));
    halfspace::write(*mesh, stride, data);
  }

  std::shared_ptr<const TriangleMesh> mesh;
  std::size_t stride = 1; ///< one triangle in so many is drawn
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  vtkNew<vtkMatrix4x4> placement;
  vtkNew<DepthlessMapper> shadowMapper;
  vtkNew<vtkActor> shadow;
  vtkNew<vtkMatrix4x4> shadowPlacement;
};

BodyActors::BodyActors(vtkRenderer &renderer, vtkMatrix4x4 &ontoGround, vtkProp &aboveShadows)
    : m_renderer(renderer), m_ontoGround(ontoGround), m_aboveShadows(aboveShadows) {}
BodyActors::~BodyActors() = default;

void BodyActors::show(const Figure &figure, const std::set<std::string> &highlighted, const Theme &theme,
                      const Arrival &arrival) {
  std::map<std::string, std::unique_ptr<Body>> shown;
  for (const Mark &mark : figure.marks) {
    const auto *body = std::get_if<MeshMark>(&mark);
    if (!body || arrival.presenceOf(*body) <= 0)
      continue;
    std::unique_ptr<Body> &actors = shown[body->id];
    actors = std::exchange(m_bodies[body->id], nullptr);
    if (!actors) {
      actors = std::make_unique<Body>();
      addBefore(m_aboveShadows, actors->shadow, m_renderer);
      m_renderer.AddActor(actors->actor);
    }
    actors->take(body->mesh);
    write(*body, actors->placement);
    vtkMatrix4x4::Multiply4x4(&m_ontoGround, actors->placement, actors->shadowPlacement);
    actors->shadowPlacement->Modified(); // which Multiply4x4 does not tell
    setColor(actors->actor,
             mix(theme.backgroundBottom, solidColor(*body, theme, highlighted.contains(body->id)),
                 bodyInk * arrival.presenceOf(*body)));
    setColor(actors->shadow, theme.shadow);
    actors->shadow->SetVisibility(m_shadowsVisible);
  }
  for (const auto &[id, gone] : m_bodies)
    if (gone) {
      m_renderer.RemoveActor(gone->actor);
      m_renderer.RemoveActor(gone->shadow);
    }
  m_bodies = std::move(shown);
}

bool BodyActors::leaveOutTriangles() const {
  return std::any_of(m_bodies.begin(), m_bodies.end(),
                     [](const auto &body) { return body.second->stride > 1; });
}

void BodyActors::setShadowsVisible(bool visible) {
  m_shadowsVisible = visible;
  for (const auto &[id, body] : m_bodies)
    body->shadow->SetVisibility(visible);
}

} // namespace halfspace
