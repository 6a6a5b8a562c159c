#include "widgets/scene/scene_actors.h"

#include "widgets/scene/depthless_mapper.h"

#include <vtkActor.h>
#include <vtkCameraPass.h>
#include <vtkLight.h>
#include <vtkLightsPass.h>
#include <vtkMatrix4x4.h>
#include <vtkOpaquePass.h>
#include <vtkOverlayPass.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkTranslucentPass.h>

#include <array>
#include <cmath>

namespace halfspace {
namespace {

/// Where the light that casts the shadows comes from.
const Place shadowLight{0.25, -0.35, 1.0};

constexpr double faceShadowPaleness = 0.55;

void setColor(vtkActor *actor, Color color) {
  actor->GetProperty()->SetColor(color.red / 255.0, color.green / 255.0, color.blue / 255.0);
}

void addCameraLight(vtkRenderer *renderer, double x, double y, double z, double intensity) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

/// Lights, opaque, translucent in the given order, overlay: nothing that sorts or peels. The scene orders its
/// faces itself, and so multisampling works, which VTK's own handling of translucency rules out.
void usePlainPasses(vtkRenderer *renderer) {
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkOverlayPass> overlay;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(lights);
  passes->AddItem(opaque);
  passes->AddItem(translucent);
  passes->AddItem(overlay);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  renderer->SetPass(camera);
}

void useSolidMaterial(vtkActor *actor) {
  vtkProperty *material = actor->GetProperty();
  material->SetInterpolationToPhong();
  material->SetAmbient(0.42);
  material->SetDiffuse(0.70);
  material->SetSpecular(0.18);
  material->SetSpecularPower(24);
}

void flattenOntoGround(vtkMatrix4x4 *matrix) {
  matrix->SetElement(0, 2, -shadowLight.x / shadowLight.z);
  matrix->SetElement(1, 2, -shadowLight.y / shadowLight.z);
  matrix->SetElement(2, 2, 0);
}

} // namespace

template <class Mapper> SceneActors::LayerOf<Mapper>::LayerOf() {
  mapper->SetInputData(data);
  actor->SetMapper(mapper);
}

SceneActors::Shadow::Shadow(const Layer &layer, vtkMatrix4x4 *ontoGround) {
  mapper->SetInputData(layer.data);
  mapper->ScalarVisibilityOff();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->SetUserMatrix(ontoGround);
  actor->ForceOpaqueOn();
}

SceneActors::SceneActors()
    : m_solidShadow(m_solids, m_ontoGround), m_faceShadow(m_faces, m_ontoGround),
      m_bodies(std::make_unique<BodyActors>(*m_renderer, *m_ontoGround, *m_grid.actor)) {
  flattenOntoGround(m_ontoGround);
  for (const Layer *solid : {&m_solids, &m_axes, &m_tools})
    useSolidMaterial(solid->actor);
  m_faces.actor->GetProperty()->LightingOff();
  m_faces.actor->ForceTranslucentOn();
  // The grid's pale lines blend with the background although they are drawn among the opaque things.
  m_grid.actor->GetProperty()->LightingOff();
  m_grid.actor->ForceOpaqueOn();
  // What is painted on the ground comes first and leaves no depth behind: so lines never cut through what
  // stands there, and what lies below the ground can be seen. The shadows of bodies come before the grid.
  vtkActor *const inOrder[] = {m_faceShadow.actor, m_solidShadow.actor, m_grid.actor, m_solids.actor,
                               m_axes.actor,       m_tools.actor,       m_faces.actor};
  for (vtkActor *actor : inOrder)
    m_renderer->AddActor(actor);

  m_renderer->AutomaticLightCreationOff();
  addCameraLight(m_renderer, -0.5, 0.9, 1.0, 0.78);
  addCameraLight(m_renderer, 0.8, -0.2, 0.9, 0.30);
  usePlainPasses(m_renderer);
}

SceneActors::~SceneActors() = default;

void SceneActors::applyTheme(const Theme &theme) {
  setColor(m_solidShadow.actor, theme.shadow);
  setColor(m_faceShadow.actor, mix(theme.shadow, theme.backgroundBottom, faceShadowPaleness));
}

void SceneActors::showBackground(const Theme &theme, bool visible, double from, double to) {
  const auto colorAt = [&](double height) {
    const auto channel = [&](std::uint8_t bottom, std::uint8_t top) {
      return visible ? std::lerp(bottom, top, height) / 255 : 0;
    };
    const Color bottom = theme.backgroundBottom;
    const Color top = theme.backgroundTop;
    return std::array{channel(bottom.red, top.red), channel(bottom.green, top.green),
                      channel(bottom.blue, top.blue)};
  };
  m_renderer->SetBackground(colorAt(from).data());
  m_renderer->SetBackground2(colorAt(to).data());
  m_renderer->SetGradientBackground(visible);
  m_renderer->SetBackgroundAlpha(visible ? 1 : 0);
}

void SceneActors::setGridLineWidth(double pixels) {
  m_grid.actor->GetProperty()->SetLineWidth(static_cast<float>(pixels));
}

void SceneActors::setShadowsVisible(bool visible) {
  m_solidShadow.actor->SetVisibility(visible);
  m_faceShadow.actor->SetVisibility(visible);
  m_bodies->setShadowsVisible(visible);
}

} // namespace halfspace
