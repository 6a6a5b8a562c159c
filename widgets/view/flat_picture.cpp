#include "widgets/view/flat_picture.h"

#include "widgets/picture/hand/flat_drag.h"
#include "widgets/picture/hand/grips.h"
#include "widgets/picture/hand/mark_picker.h"
#include "widgets/view/staged_scene.h"

#include <utility>

namespace halfspace {

void FlatPicture::take(const FlatFrame *held) {
  const auto &flat = m_model.lesson().flat;
  if (held)
    m_frame = *held;
  else
    m_frame = flat ? flatFrame(*flat, m_model.session().scene) : std::nullopt;
  if (!m_frame)
    return;
  m_stage = m_model.stage();
  m_whole = laid(m_model.figure());
  m_figure = laid(m_model.shown().figure);
}

Lazy<Figure> FlatPicture::laid(const Figure &figure) const {
  return Lazy<Figure>([figure, stage = m_stage, frame = m_frame] {
    return frame ? laidFlat(toStage(figure, stage), *frame) : Figure();
  });
}

void FlatPicture::fit(PixelSize screen, double pixelRatio, const PixelBox &covered) {
  m_view.size = screen;
  m_view.pixelRatio = pixelRatio;
  m_view.covered = {covered};
  m_view.camera = flatCamera(*m_whole, m_view);
}

SceneContent FlatPicture::shown() const {
  SceneContent content;
  content.stage = m_stage;
  content.figure = clippedTo(m_view, *m_figure);
  return content;
}

std::optional<Handle> FlatPicture::handleAt(glm::dvec2 pixel) const {
  const std::string upwards = fullName(m_model.session().scene, m_model.lesson().flat->up);
  const std::vector<Handle> handles = handlesOf(stagedScene(m_model, m_stage));
  const Handle *handle =
      handleOnPage(pixel, handles, upwards, *m_frame, m_view, missMargin * m_view.pixelRatio);
  return handle ? std::optional(*handle) : std::nullopt;
}

std::string FlatPicture::markAt(glm::dvec2 pixel) const {
  return markUnder(pixel, *m_figure, m_view.camera, m_view.size, m_view.pixelRatio);
}

} // namespace halfspace
