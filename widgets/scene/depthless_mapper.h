// Draws a mesh without writing its depth.
#pragma once

#include <vtkOpenGLPolyDataMapper.h>

namespace halfspace {

/// For what is painted on the ground: it is hidden by what stands before it, and itself hides nothing drawn
/// later.
class DepthlessMapper : public vtkOpenGLPolyDataMapper {
public:
  static DepthlessMapper *New();
  vtkTypeMacro(DepthlessMapper, vtkOpenGLPolyDataMapper)

      void RenderPieceDraw(vtkRenderer *renderer, vtkActor *actor) override;

protected:
  DepthlessMapper() = default;
  ~DepthlessMapper() override = default;
};

} // namespace halfspace
