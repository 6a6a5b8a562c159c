// The surfaces of very many triangles in a picture, one VTK object each.
#pragma once

#include "widgets/picture/shapes/shape_list.h"

#include <vtkNew.h>

#include <map>
#include <memory>
#include <string>

class vtkMatrix4x4;
class vtkProp;
class vtkRenderer;

namespace halfspace {

/// Keeps an actor, and one for its shadow, for each body of a picture. The triangles are handed to VTK when a
/// mesh comes first, and stay there while it is shown: a body that moves costs a matrix.
class BodyActors {
public:
  /// `ontoGround` projects along the light onto the ground. Shadows are drawn before `aboveShadows`, which
  /// the renderer has when something is shown.
  BodyActors(vtkRenderer &renderer, vtkMatrix4x4 &ontoGround, vtkProp &aboveShadows);
  ~BodyActors();
  BodyActors(const BodyActors &) = delete;
  BodyActors &operator=(const BodyActors &) = delete;

  void show(const std::vector<Shape> &shapes);
  /// In their colour; nothing: not at all.
  void showShadows(const std::optional<Color> &color);

private:
  struct Body;
  vtkRenderer &m_renderer;
  vtkMatrix4x4 &m_ontoGround;
  vtkProp &m_aboveShadows;
  std::map<std::string, std::unique_ptr<Body>> m_bodies; ///< by the ids of their marks
  std::optional<Color> m_shadow;
};

} // namespace halfspace
