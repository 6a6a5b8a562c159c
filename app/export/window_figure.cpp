#include "app/export/window_figure.h"

#include "lessons/scene/file/session_file.h"
#include "widgets/session_model.h"
#include "widgets/view/flat_view.h"
#include "widgets/view/scene_view.h"

namespace halfspace {

WindowFigure::WindowFigure(const SessionModel &model, SceneView &scene, const FlatView &flat)
    : m_model(model), m_scene(scene), m_flat(flat) {}

FigureRequest WindowFigure::requestFor(const ExportChoices &choices) const {
  FigureSubject subject;
  subject.content = m_scene.drawn().pictureContent();
  subject.camera = m_scene.viewpoint().camera();
  if (choices.isFlat)
    subject.flat = m_flat.picture();
  subject.title = m_model.lesson().title;
  subject.description = m_model.shown().description;
  if (choices.mayTellScene())
    subject.session = writeSession(m_model.session());
  const ViewScreen &screen = m_scene.screen();
  return {std::move(subject), figureChoicesOf(choices, screen.size(), screen.designRatio())};
}

bool WindowFigure::hasFlat() const { return m_flat.hasPicture(); }

QString WindowFigure::name() const { return QString::fromStdString(m_model.session().lesson); }

} // namespace halfspace
