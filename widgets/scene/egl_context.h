// An OpenGL context without a window and without a display server.
#pragma once

#include <string>

class vtkGenericOpenGLRenderWindow;

namespace halfspace {

/// A context on EGL's surfaceless platform, current in the thread that made it for as long as it lives.
class EglContext {
public:
  EglContext();
  ~EglContext();
  EglContext(const EglContext &) = delete;
  EglContext &operator=(const EglContext &) = delete;

  /// A sentence for the user that says why there is no context; empty when there is one.
  [[nodiscard]] const std::string &failure() const { return m_failure; }

  /// Makes a window draw into this context, which must outlive it.
  void serve(vtkGenericOpenGLRenderWindow *window);

  void makeCurrent() const;
  [[nodiscard]] bool isCurrent() const;

private:
  [[nodiscard]] std::string open();

  // EGL's own types are pointers to void; its header drags in X11's macros.
  void *m_display = nullptr;
  void *m_context = nullptr;
  std::string m_failure;
};

} // namespace halfspace
