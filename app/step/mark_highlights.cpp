#include "app/step/mark_highlights.h"

#include "widgets/view/flat_view.h"
#include "widgets/view/scene_view.h"
#include "widgets/working/step_working.h"

namespace halfspace {

MarkHighlights::MarkHighlights(SceneView &scene, FlatView &flat, StepWorking &working)
    : m_drawn(scene.drawn()), m_flat(flat), m_working(working) {
  connect(&scene.handles(), &SceneHandles::markHovered, this, &MarkHighlights::hover);
  connect(&flat, &FlatView::markHovered, this, &MarkHighlights::hover);
  connect(&working, &StepWorking::markHovered, this, &MarkHighlights::hover);
  connect(&working, &StepWorking::traceChanged, this, &MarkHighlights::show);
  connect(&scene.input(), &SceneInput::dismissed, &working, &StepWorking::endTrace);
}

void MarkHighlights::setFragment(const std::set<std::string> &marks) {
  m_fragment = marks;
  show();
}

void MarkHighlights::setSelected(const std::set<std::string> &marks) {
  m_selected = marks;
  show();
}

void MarkHighlights::hover(const QString &markId) {
  m_mark = markId;
  emit markHovered(markId);
  show();
}

void MarkHighlights::show() {
  std::set<std::string> marks = m_working.traced().marks;
  if (!m_mark.isEmpty())
    marks.insert(m_mark.toStdString());
  marks.insert(m_fragment.begin(), m_fragment.end());
  marks.insert(m_selected.begin(), m_selected.end());
  m_working.setHighlighted(marks);
  m_flat.setHighlighted(marks);
  m_drawn.setHighlighted(marks);
}

} // namespace halfspace
