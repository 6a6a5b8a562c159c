#include "widgets/view/scene_drawing.h"

#include "widgets/picture/shapes/surface_layers.h"
#include "widgets/scene/render_window.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <utility>

namespace halfspace {
namespace {

/// Samples a pixel at rest; while something moves there is one.
constexpr int restSamples = 4;

} // namespace

SceneDrawing::SceneDrawing(QVTKOpenGLNativeWidget &widget, const Typesetter &typesetter,
                           const Viewpoint &viewpoint, const DrawnFigure &drawn, const SceneHandles &handles,
                           HandleHold &hold)
    : m_widget(widget), m_viewpoint(viewpoint), m_drawn(drawn), m_handles(handles), m_hold(hold),
      m_composer(labelSetter(typesetter.fonts())), m_scene(labelPainter(typesetter)), m_frames(widget) {
  vtkNew<halfspace::RenderWindow> window;
  m_widget.setRenderWindow(window);
  window->AddRenderer(m_scene.renderer());
  // VTK's own interaction would fight with ours.
  window->GetInteractor()->SetInteractorStyle(nullptr);
  connect(&m_frames, &FramePacer::due, this, &SceneDrawing::frame);
  connect(&m_hold, &HandleHold::aboutToMove, this, [this] { m_moveBegun = Clock::now(); });
  connect(&m_hold, &HandleHold::moved, this, [this] {
    if (m_outcomeTaken < m_moveBegun)
      return; // the move came to nothing new
    m_times.evaluate = m_outcomeTaken - m_moveBegun;
    m_times.panels = Clock::now() - m_outcomeTaken;
  });
}

SceneDrawing::~SceneDrawing() {
  m_widget.makeCurrent();
  m_widget.renderWindow()->RemoveRenderer(m_scene.renderer());
  m_widget.doneCurrent();
}

void SceneDrawing::setTheme(const Theme &theme) {
  m_composer.setTheme(theme);
  requestNew(); // tools keep clear of lines, which are thicker in some themes
}

void SceneDrawing::takeOutcome(bool inGesture) {
  if (inGesture)
    m_frames.startRest(); // what a flight, or a number that is scrubbed, moves comes to rest later as well
  m_outcomeTaken = Clock::now();
}

void SceneDrawing::frame() {
  m_hold.follow(m_viewpoint.view()); // first: what it asks for is in this frame
  m_frames.begin();
  if (!m_widget.isValid() || !m_widget.isVisible())
    return;
  const auto start = Clock::now();
  prepare();
  const auto prepared = Clock::now();
  // Outside of paintGL: VTK then asks for a paint, which only shows what is drawn here.
  m_frames.awaitPaint();
  m_widget.renderWindow()->SetMultiSamples(m_frames.isMoving() ? 0 : restSamples);
  m_widget.renderWindow()->Render();
  m_times.update = prepared - start;
  m_times.render = Clock::now() - prepared;
  emit frameDrawn(std::exchange(m_times, {}));
}

void SceneDrawing::prepare() {
  const bool isSeenOtherwise = m_composer.setView(m_viewpoint.view());
  if (m_frames.takeNew()) {
    SceneContent content = m_drawn.drawnContent();
    m_handles.addTo(content);
    m_composer.setContent(std::move(content));
  } else if (isSeenOtherwise) { // how a handle can be moved depends on the camera
    m_composer.setTools(m_handles.gizmo(), m_handles.knobs());
  }
  const ShapeList &shapes = m_composer.compose();
  m_scene.show(shapes);
  tellNotice(shapes.leavesOutSurfaces);
}

void SceneDrawing::tellNotice(bool leavesOutSurfaces) {
  const QString notice = leavesOutSurfaces ? QString::fromStdString(overfullWords()) : QString();
  if (std::exchange(m_notice, notice) != notice)
    emit noticeChanged(notice);
}

} // namespace halfspace
