// The surfaces of very many triangles in a figure, one VTK object each.
#pragma once

#include "lessons/figure/figure.h"
#include "widgets/picture/shapes/arrival.h"
#include "widgets/picture/theme.h"

#include <vtkNew.h>

#include <map>
#include <memory>
#include <set>
#include <string>

class vtkMatrix4x4;
class vtkProp;
class vtkRenderer;

namespace halfspace {

/// Keeps an actor, and one for its shadow, for each body of a figure. The triangles are handed to VTK when a
/// mesh comes first, and stay there while it is shown: a body that moves costs a matrix.
class BodyActors {
public:
  /// `ontoGround` projects along the light onto the ground. Shadows are drawn before `aboveShadows`, which
  /// the renderer has when something is shown.
  BodyActors(vtkRenderer &renderer, vtkMatrix4x4 &ontoGround, vtkProp &aboveShadows);
  ~BodyActors();
  BodyActors(const BodyActors &) = delete;
  BodyActors &operator=(const BodyActors &) = delete;

  void show(const Figure &figure, const std::set<std::string> &highlighted, const Theme &theme,
            const Arrival &arrival);
  /// Whether of a body only some triangles are drawn: more than `mostMeshLayers` lie one behind another.
  [[nodiscard]] bool leaveOutTriangles() const;
  void setShadowsVisible(bool visible);

private:
  struct Body;
  vtkRenderer &m_renderer;
  vtkMatrix4x4 &m_ontoGround;
  vtkProp &m_aboveShadows;
  std::map<std::string, std::unique_ptr<Body>> m_bodies; ///< by the ids of their marks
  bool m_shadowsVisible = true;
};

} // namespace halfspace
