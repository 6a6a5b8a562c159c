// The few VTK objects that draw a scene, and how they are lit.
#pragma once

#include "widgets/picture/theme.h"
#include "widgets/scene/body_actors.h"

#include <vtkNew.h>

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

  [[nodiscard]] BodyActors &bodies() { return *m_bodies; }
  [[nodiscard]] const BodyActors &bodies() const { return *m_bodies; }
  [[nodiscard]] vtkPolyData *solids() const { return m_solids.data; }
  [[nodiscard]] vtkPolyData *faces() const { return m_faces.data; }
  [[nodiscard]] vtkPolyData *axes() const { return m_axes.data; }
  [[nodiscard]] vtkPolyData *grid() const { return m_grid.data; }
  [[nodiscard]] vtkPolyData *tools() const { return m_tools.data; }

  void applyTheme(const Theme &theme);
  /// Shows the part of the background gradient from one height (0 the bottom of the view, 1 its top) to
  /// another; or, not visible, black with alpha 0.
  void showBackground(const Theme &theme, bool visible, double from, double to);
  void setGridLineWidth(double pixels);
  void setShadowsVisible(bool visible);

private:
  /// A mesh and the actor that shows it.
  template <class Mapper> struct LayerOf {
    vtkNew<vtkPolyData> data;
    vtkNew<Mapper> mapper;
    vtkNew<vtkActor> actor;
    LayerOf();
  };
  using Layer = LayerOf<vtkPolyDataMapper>;
  /// Painted on the ground: whatever else there is, is drawn over it.
  using GroundLayer = LayerOf<DepthlessMapper>;
  /// Another actor for the mesh of a layer, flattened onto the ground in one colour.
  struct Shadow {
    vtkNew<DepthlessMapper> mapper;
    vtkNew<vtkActor> actor;
    Shadow(const Layer &layer, vtkMatrix4x4 *ontoGround);
  };

  vtkNew<vtkRenderer> m_renderer;
  vtkNew<vtkMatrix4x4> m_ontoGround; ///< projects along the light onto the ground
  Layer m_solids;
  Layer m_faces;
  Layer m_axes;
  GroundLayer m_grid;
  Layer m_tools;
  Shadow m_solidShadow;
  Shadow m_faceShadow;
  std::unique_ptr<BodyActors> m_bodies; ///< their shadows lie below the grid
};

} // namespace halfspace
