// The few VTK objects that draw shapes in space, and how they are lit.
#pragma once

#include "widgets/picture/shapes/shape_mesh.h"
#include "widgets/scene/body_actors.h"
#include "widgets/scene/vtk_mesh.h"

#include <vtkNew.h>

#include <array>
#include <memory>

class vtkActor;
class vtkMatrix4x4;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;

namespace halfspace {

class DepthlessMapper;

/// One renderer with one mesh each for solids, faces, axes, grid and tools, and the shadows of the first two.
class SceneActors {
public:
  SceneActors();
  ~SceneActors();
  SceneActors(const SceneActors &) = delete;
  SceneActors &operator=(const SceneActors &) = delete;

  [[nodiscard]] vtkRenderer *renderer() const { return m_renderer; }

  /// Brings the objects of those layers up to date that are not the ones that are shown.
  void show(const ShapeList &list);
  /// Shows the part of the background gradient from one height (0 the bottom of the view, 1 its top) to
  /// another; or, not visible, black with alpha 0.
  void showBackground(const Background &background, double from, double to);

private:
  /// A mesh and the actor that shows it.
  template <class Mapper> struct MeshActorOf {
    vtkNew<vtkPolyData> data;
    vtkNew<Mapper> mapper;
    vtkNew<vtkActor> actor;
    MeshActorOf();
  };
  using MeshActor = MeshActorOf<vtkPolyDataMapper>;
  /// Painted on the ground: whatever else there is, is drawn over it.
  using GroundActor = MeshActorOf<DepthlessMapper>;
  /// Another actor for the mesh of one, flattened onto the ground in one colour.
  struct Shadow {
    vtkNew<DepthlessMapper> mapper;
    vtkNew<vtkActor> actor;
    Shadow(const MeshActor &drawn, vtkMatrix4x4 *ontoGround);
  };

  /// The mesh of a layer in an actor, and how it gets there.
  struct LayerMesh {
    Layer layer;
    MeshSequence sequence{};
    MeshWriter writer;
    LayerMesh(Layer of, vtkPolyData *data) : layer(of), writer(data) {}
  };

  void showGrid(const std::vector<Shape> &lines);
  void showShadows(const std::optional<Shadows> &shadows);

  vtkNew<vtkRenderer> m_renderer;
  vtkNew<vtkMatrix4x4> m_ontoGround; ///< projects along the light onto the ground
  MeshActor m_solids;
  MeshActor m_faces;
  MeshActor m_axes;
  GroundActor m_grid;
  MeshActor m_tools;
  Shadow m_solidShadow;
  Shadow m_faceShadow;
  std::array<LayerMesh, 3> m_meshes;
  std::unique_ptr<BodyActors> m_bodies; ///< their shadows lie below the grid
  std::array<ShapeLayer, layerCount> m_shown;
};

} // namespace halfspace
