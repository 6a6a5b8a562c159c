// The render window of live views and of pictures without a window: draws into whatever OpenGL context is
// current.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace halfspace {

/// VTK's window for foreign contexts, able to start under EGL and Wayland too.
class RenderWindow : public vtkGenericOpenGLRenderWindow {
public:
  static RenderWindow *New();
  vtkTypeMacro(RenderWindow, vtkGenericOpenGLRenderWindow)

      /// Loads OpenGL's functions for the current context. Up to VTK 9.3 these come through GLEW, which
      /// reports an error where there is no GLX display, though every function is there: that error is passed
      /// over.
      void OpenGLInitContext() override;

  /// Whether OpenGL 3.2 or later could be started.
  [[nodiscard]] bool isReady() const { return this->Initialized; }

protected:
  RenderWindow() = default;
  ~RenderWindow() override = default;
};

} // namespace halfspace
