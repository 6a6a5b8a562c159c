#include "widgets/scene/depthless_mapper.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

namespace halfspace {

vtkStandardNewMacro(DepthlessMapper);

void DepthlessMapper::RenderPieceDraw(vtkRenderer *renderer, vtkActor *actor) {
  // An OpenGL mapper is only ever asked to draw into an OpenGL window.
  vtkOpenGLState *state = static_cast<vtkOpenGLRenderWindow *>(renderer->GetRenderWindow())->GetState();
  state->vtkglDepthMask(false);
  this->Superclass::RenderPieceDraw(renderer, actor);
  state->vtkglDepthMask(true);
}

} // namespace halfspace
