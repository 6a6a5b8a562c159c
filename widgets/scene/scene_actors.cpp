#include "widgets/scene/scene_actors.h"

#include "widgets/picture/shapes/light.h"
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
#include <utility>

namespace halfspace {
namespace {

void setColor(vtkActor *actor, Color color) {
  actor->GetProperty()->SetColor(color.red / 255.0, color.green / 255.0, color.blue / 255.0);
}

void addLight(vtkRenderer *renderer, const CameraLight &lamp) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(lamp.from.x, lamp.from.y, lamp.from.z);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(lamp.strength);
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
  material->SetAmbient(ambientPart);
  material->SetDiffuse(diffusePart);
  material->SetSpecular(0.18);
  material->SetSpecularPower(24);
}

void flattenOntoGround(vtkMatrix4x4 *matrix) {
  matrix->SetElement(0, 2, -shadowLight.x / shadowLight.z);
  matrix->SetElement(1, 2, -shadowLight.y / shadowLight.z);
  matrix->SetElement(2, 2, 0);
}

} // namespace

template <class Mapper> SceneActors::MeshActorOf<Mapper>::MeshActorOf() {
  mapper->SetInputData(data);
  actor->SetMapper(mapper);
}

SceneActors::Shadow::Shadow(const MeshActor &drawn, vtkMatrix4x4 *ontoGround) {
  mapper->SetInputData(drawn.data);
  mapper->ScalarVisibilityOff();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->SetUserMatrix(ontoGround);
  actor->ForceOpaqueOn();
}

SceneActors::SceneActors()
    : m_solidShadow(m_solids, m_ontoGround),
      m_faceShadow(m_faces, m_ontoGround), m_meshes{{{Layer::Solids, m_solids.data},
                                                     {Layer::Axes, m_axes.data},
                                                     {Layer::Tools, m_tools.data}}},
      m_bodies(std::make_unique<BodyActors>(*m_renderer, *m_ontoGround, *m_grid.actor)) {
  flattenOntoGround(m_ontoGround);
  for (const MeshActor *solid : {&m_solids, &m_axes, &m_tools})
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
  for (const CameraLight &lamp : cameraLights)
    addLight(m_renderer, lamp);
  usePlainPasses(m_renderer);
}

SceneActors::~SceneActors() = default;

void SceneActors::show(const ShapeList &list) {
  const auto isNew = [&](Layer layer) {
    return m_shown[static_cast<std::size_t>(layer)] != list.layer(layer);
  };
  for (LayerMesh &mesh : m_meshes)
    if (isNew(mesh.layer))
      mesh.writer.write(mesh.sequence.meshOf(list.layer(mesh.layer)));
  if (isNew(Layer::Ground))
    showGrid(*list.layer(Layer::Ground));
  if (isNew(Layer::Bodies))
    m_bodies->show(*list.layer(Layer::Bodies));
  if (isNew(Layer::Faces))
    writeFaces(*list.layer(Layer::Faces), m_faces.data);
  m_shown = list.layers;
  showShadows(list.shadows);
}

void SceneActors::showGrid(const std::vector<Shape> &lines) {
  writeHairlines(lines, m_grid.data);
  // VTK has one width for all lines of an actor, and so has the grid.
  forEach<HairlineShape>(lines, [&](const Shape &, const HairlineShape &line) {
    m_grid.actor->GetProperty()->SetLineWidth(static_cast<float>(line.width));
  });
}

void SceneActors::showShadows(const std::optional<Shadows> &shadows) {
  m_solidShadow.actor->SetVisibility(shadows.has_value());
  m_faceShadow.actor->SetVisibility(shadows.has_value());
  m_bodies->showShadows(shadows ? std::optional(shadows->ofSolids) : std::nullopt);
  if (!shadows)
    return;
  setColor(m_solidShadow.actor, shadows->ofSolids);
  setColor(m_faceShadow.actor, shadows->ofFaces);
}

void SceneActors::showBackground(const Background &background, double from, double to) {
  const auto colorAt = [&](double height) {
    const auto channel = [&](std::uint8_t bottom, std::uint8_t top) {
      return background.isVisible ? std::lerp(bottom, top, height) / 255 : 0;
    };
    const auto &[bottom, top, isVisible] = background;
    return std::array{channel(bottom.red, top.red), channel(bottom.green, top.green),
                      channel(bottom.blue, top.blue)};
  };
  m_renderer->SetBackground(colorAt(from).data());
  m_renderer->SetBackground2(colorAt(to).data());
  m_renderer->SetGradientBackground(background.isVisible);
  m_renderer->SetBackgroundAlpha(background.isVisible ? 1 : 0);
}

} // namespace halfspace
