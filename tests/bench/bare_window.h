// A window in which bare VTK draws, beside the program's.
#pragma once

#include "tests/bench/bare_scene.h"
#include "tests/bench/durations.h"
#include "widgets/view/scene_view.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QTest>
#include <QVTKOpenGLNativeWidget.h>

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

namespace halfspace::bench {

/// Waits until the drawing is done: VTK only orders it.
inline void finishDrawing() { QOpenGLContext::currentContext()->functions()->glFinish(); }

/// Counts what a view draws from now on.
inline void countRenders(const SceneView &view, int &count) {
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&count);
  command->SetCallback([](vtkObject *, unsigned long, void *data, void *) { ++*static_cast<int *>(data); });
  view.renderWindow()->GetRenderers()->GetFirstRenderer()->AddObserver(vtkCommand::EndEvent, command);
}

/// A window of bare VTK, as large as the view that it is compared with.
class BareWindow {
public:
  explicit BareWindow(SceneView &view) {
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    m_widget.setRenderWindow(window);
    window->AddRenderer(m_scene.renderer());
    window->SetMultiSamples(0); // as the program has it while something moves
    m_widget.resize(view.size());
    m_widget.move(view.window()->width(), 0);
    const Camera &camera = view.viewpoint().camera();
    m_scene.setCamera({camera.eye(), camera.target, Camera::viewAngle});
    m_widget.show();
    static_cast<void>(QTest::qWaitForWindowExposed(&m_widget));
  }
  ~BareWindow() {
    m_widget.makeCurrent();
    m_widget.renderWindow()->RemoveRenderer(m_scene.renderer());
  }
  BareWindow(const BareWindow &) = delete;
  BareWindow &operator=(const BareWindow &) = delete;

  /// How long it takes to change the picture and to draw it.
  double draw(const BarePicture &picture) {
    m_widget.makeCurrent();
    finishDrawing();
    const auto start = Clock::now();
    m_scene.show(picture);
    if (!m_isFitted)
      m_scene.fitClippingRange();
    m_isFitted = true;
    m_widget.renderWindow()->Render();
    finishDrawing();
    const double duration = millisecondsSince(start);
    QCoreApplication::processEvents();
    return duration;
  }

private:
  BareScene m_scene;
  QVTKOpenGLNativeWidget m_widget;
  bool m_isFitted = false;
};

} // namespace halfspace::bench
