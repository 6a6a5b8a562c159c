#include "widgets/scene/body_actors.h"

#include "geometry/triangle_mesh.h"
#include "widgets/picture/shapes/light.h"
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

void writePlacement(const BodyShape &body, vtkMatrix4x4 *matrix) {
  for (glm::length_t column = 0; column < 3; ++column)
    for (glm::length_t row = 0; row < 3; ++row)
      matrix->SetElement(row, column, body.axes[column][row]);
  for (glm::length_t row = 0; row < 3; ++row)
    matrix->SetElement(row, 3, body.origin[row]);
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
    actor->GetProperty()->SetAmbient(ambientPart);
    actor->GetProperty()->SetDiffuse(diffusePart);
    shadow->GetProperty()->LightingOff();
    shadow->ForceOpaqueOn();
  }

  void take(const BodyShape &body) {
    if (std::exchange(mesh, body.mesh) != body.mesh)
      write(*mesh, body.stride, data);
  }
  void showShadow(const std::optional<Color> &color) {
    shadow->SetVisibility(color.has_value());
    if (color)
      setColor(shadow, *color);
  }

  std::shared_ptr<const TriangleMesh> mesh; ///< the stride follows from it
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

void BodyActors::show(const std::vector<Shape> &shapes) {
  std::map<std::string, std::unique_ptr<Body>> shown;
  forEach<BodyShape>(shapes, [&](const Shape &shape, const BodyShape &body) {
    std::unique_ptr<Body> &actors = shown[shape.mark];
    actors = std::exchange(m_bodies[shape.mark], nullptr);
    if (!actors) {
      actors = std::make_unique<Body>();
      addBefore(m_aboveShadows, actors->shadow, m_renderer);
      m_renderer.AddActor(actors->actor);
    }
    actors->take(body);
    writePlacement(body, actors->placement);
    vtkMatrix4x4::Multiply4x4(&m_ontoGround, actors->placement, actors->shadowPlacement);
    actors->shadowPlacement->Modified(); // which Multiply4x4 does not tell
    setColor(actors->actor, shape.color);
    actors->showShadow(m_shadow);
  });
  for (const auto &[id, gone] : m_bodies)
    if (gone) {
      m_renderer.RemoveActor(gone->actor);
      m_renderer.RemoveActor(gone->shadow);
    }
  m_bodies = std::move(shown);
}

void BodyActors::showShadows(const std::optional<Color> &color) {
  m_shadow = color;
  for (const auto &[id, body] : m_bodies)
    body->showShadow(color);
}

} // namespace halfspace
