#include "widgets/view/drawn_figure.h"

#include <utility>

namespace halfspace {

DrawnFigure::DrawnFigure(const SessionModel &model) : m_model(model) {
  connect(&m_fade, &MarkFade::changed, this, &DrawnFigure::moved);
  connect(&m_extents, &ExtentGlide::changed, this, &DrawnFigure::moved);
}

void DrawnFigure::takeLesson() {
  m_figure = {};
  m_stage = m_model.stage();
}

void DrawnFigure::takeOutcome(bool moving) {
  if (!(m_stage == m_model.stage())) {
    m_stage = m_model.stage();
    m_extents.release(false); // they are in units of the stage before
  }
  Figure figure = toStage(m_model.shown().figure, m_stage);
  if (m_model.history().inGesture())
    holdExtents();
  else
    glideTo(extentsOf(figure), moving);
  m_figure = std::move(figure);
  m_fade.show(m_model.session(), m_model.shown().figure, moving);
}

void DrawnFigure::holdExtents() {
  const Scene &scene = m_model.session().scene;
  if (!m_extents.isHolding()) {
    Extents extents = extentsOf(drawnFigure());
    std::erase_if(extents, [&](const auto &held) { return !findObject(scene, held.first); });
    m_extents.hold(std::move(extents));
  }
  for (const std::string &moved : m_model.history().movedByGesture())
    m_extents.leave(moved);
}

void DrawnFigure::glideTo(const Extents &next, bool moving) {
  Extents now = extentsOf(drawnFigure());
  if (now == next)
    return;
  m_extents.hold(std::move(now));
  m_extents.release(moving);
}

void DrawnFigure::takeGesture(bool moving) {
  if (!m_model.history().inGesture())
    return m_extents.release(moving);
  if (m_fade.arrival().marks.empty())
    return;
  m_fade.finish();
  emit moved();
}

void DrawnFigure::arrive() {
  m_fade.finish();
  m_extents.arrive();
}

void DrawnFigure::setHighlighted(const std::set<std::string> &markIds) {
  if (markIds == m_highlighted)
    return;
  m_highlighted = markIds;
  emit changed();
}

void DrawnFigure::setShownParts(const ShownParts &shown) {
  if (shown == m_parts)
    return;
  m_parts = shown;
  emit changed();
}

void DrawnFigure::setNumbersHidden(bool hidden) {
  if (std::exchange(m_areNumbersHidden, hidden) != hidden)
    emit changed();
}

void DrawnFigure::setGhost(Figure ghost) {
  if (ghost.marks.size() == 0 && m_ghost.marks.size() == 0)
    return;
  m_ghost = std::move(ghost);
  emit changed();
}

SceneContent DrawnFigure::pictureContent() const {
  SceneContent content;
  content.stage = m_stage;
  content.figure = m_figure;
  content.labels = m_model.session().scene.labels;
  content.shown = m_parts;
  content.hasShadows = m_model.lesson().hasShadows;
  if (m_areNumbersHidden)
    content.figure = withoutNumbers(std::move(content.figure));
  return content;
}

SceneContent DrawnFigure::drawnContent() const {
  SceneContent content = pictureContent();
  content.figure = m_extents.drawn(std::move(content.figure)); // whether with its numbers or without
  content.figure.marks.append(m_ghost.marks);
  content.highlighted = m_highlighted;
  content.arrival = m_fade.arrival();
  return content;
}

} // namespace halfspace
