#include <vtkVersionMacros.h>

// VTK 9.4 went from GLEW to a loader that needs no help.
#define HALFSPACE_VTK_HAS_GLEW (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 4)
#if HALFSPACE_VTK_HAS_GLEW
#include <vtk_glew.h>
#endif

#include "widgets/scene/render_window.h"

#include <vtkObjectFactory.h>

#include <array>

namespace halfspace {

vtkStandardNewMacro(RenderWindow);

#if HALFSPACE_VTK_HAS_GLEW

void RenderWindow::OpenGLInitContext() {
  constexpr GLenum noGlxDisplay = 4; // GLEW_ERROR_NO_GLX_DISPLAY, which older headers do not name
  this->ContextCreationTime.Modified();
  if (this->Initialized)
    return;
  glewExperimental = GL_TRUE;
  const GLenum result = glewInit();
  while (glGetError() != GL_NO_ERROR) {
    // GLEW leaves errors behind when it probes a core context.
  }
  this->GlewInitValid = (result == GLEW_OK || result == noGlxDisplay) && GLEW_VERSION_3_2;
  if (!this->GlewInitValid)
    return;
  this->Initialized = true;
  std::array<GLfloat, 2> widths{1, 1};
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths.data());
  this->MaximumHardwareLineWidth = widths[1];
}

#else

void RenderWindow::OpenGLInitContext() { this->Superclass::OpenGLInitContext(); }

#endif

} // namespace halfspace
