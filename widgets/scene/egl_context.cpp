#include "widgets/scene/egl_context.h"

#include "lessons/words.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>
#include <vtkVersionMacros.h>

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>

namespace halfspace {
namespace {

std::string noOpenGl() {
  return words(
      "Pictures cannot be drawn here: OpenGL 3.2 without a window (EGL) is missing. Installing Mesa's "
      "libegl1 and libgl1-mesa-dri brings it.");
}

/// Answers VTK's questions about the context.
void answer(vtkObject *, unsigned long event, void *client, void *data) {
  const auto *context = static_cast<const EglContext *>(client);
  if (event == vtkCommand::WindowMakeCurrentEvent)
    context->makeCurrent();
  else if (event == vtkCommand::WindowIsCurrentEvent)
    *static_cast<bool *>(data) = context->isCurrent();
}

} // namespace

EglContext::EglContext() : m_failure(open()) {}

EglContext::~EglContext() {
  if (!m_display)
    return;
  eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (m_context)
    eglDestroyContext(m_display, m_context);
  // The display is not terminated: EGL shares it with whoever else asked for it in this process.
}

std::string EglContext::open() {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): EGL hands all functions out under one type.
  const auto getDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (!getDisplay)
    return noOpenGl();
  m_display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (!m_display || !eglInitialize(m_display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
    return noOpenGl();

  constexpr std::array<EGLint, 5> wantedConfig{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                               EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(m_display, wantedConfig.data(), &config, 1, &count) || count < 1)
    return noOpenGl();
  constexpr std::array<EGLint, 7> wantedContext{EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                2,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_NONE};
  m_context = eglCreateContext(m_display, config, EGL_NO_CONTEXT, wantedContext.data());
  if (!m_context || !eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context))
    return noOpenGl();
  return {};
}

void EglContext::makeCurrent() const { eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context); }

bool EglContext::isCurrent() const { return eglGetCurrentContext() == m_context; }

void EglContext::serve(vtkGenericOpenGLRenderWindow *window) {
  window->SetOwnContext(0);
  window->SetReadyForRendering(true);
  window->SetSupportsOpenGL(1);
  window->SetIsDirect(1);
  window->SetFrameBlitModeToNoBlit();
  window->SetForceMaximumHardwareLineWidth(1);
  window->SetMapped(1);
  vtkNew<vtkCallbackCommand> callback;
  callback->SetClientData(this);
  callback->SetCallback(answer);
  window->AddObserver(vtkCommand::WindowMakeCurrentEvent, callback);
  window->AddObserver(vtkCommand::WindowIsCurrentEvent, callback);
#if VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 4
  const auto load = [](void *, const char *name) {
    return reinterpret_cast<vtkOpenGLRenderWindow::VTKOpenGLAPIProc>(eglGetProcAddress(name));
  };
  window->SetOpenGLSymbolLoader(load, nullptr);
#endif
  window->OpenGLInitContext();
}

} // namespace halfspace
