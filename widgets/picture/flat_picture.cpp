#include "widgets/picture/flat_picture.h"

#include "widgets/picture/hand/mark_picker.h"

#include <utility>

namespace halfspace {

FlatPicture::FlatPicture(FlatFrame frame, Stage stage, const Figure &whole, const Figure &shown)
    : m_frame(std::move(frame)), m_stage(std::move(stage)), m_whole(laid(whole)), m_figure(laid(shown)) {}

Lazy<Figure> FlatPicture::laid(const Figure &figure) const {
  return Lazy<Figure>(
      [figure, stage = m_stage, frame = m_frame] { return laidFlat(toStage(figure, stage), frame); });
}

View FlatPicture::fitted(View view) const {
  view.camera = flatCamera(*m_whole, view);
  return view;
}

SceneContent FlatPicture::seenFrom(const View &view) const {
  SceneContent content;
  content.stage = m_stage;
  content.figure = clippedTo(view, *m_figure);
  return content;
}

std::string FlatPicture::markAt(glm::dvec2 pixel, const View &view) const {
  return markUnder(pixel, *m_figure, view.camera, view.size, view.pixelRatio);
}

} // namespace halfspace
