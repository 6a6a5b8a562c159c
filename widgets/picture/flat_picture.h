// A scene on the page of its lesson's flat picture.
#pragma once

#include "lessons/lazy.h"
#include "widgets/picture/flat_page.h"
#include "widgets/picture/scene_content.h"

#include <string>

namespace halfspace {

/// What a step shows of a scene, laid flat. Its figures are made when somebody looks at them.
class FlatPicture {
public:
  /// The figure of all steps, and what one of them shows of it, both in scene units.
  FlatPicture(FlatFrame frame, Stage stage, const Figure &whole, const Figure &shown);

  /// The view with a camera that has the whole of it, of all steps, in view, beside what covers that.
  [[nodiscard]] View fitted(View view) const;
  /// Whether a view that was fitted to another picture has the whole of this one in view.
  [[nodiscard]] bool isInView(const View &view) const { return showsAll(*m_whole, view); }

  [[nodiscard]] const FlatFrame &frame() const { return m_frame; }
  [[nodiscard]] const Stage &stage() const { return m_stage; }
  [[nodiscard]] const Figure &figure() const { return *m_figure; }
  /// What is seen of it from a fitted view. Its labels find places of their own: where somebody has put them
  /// is meant for the picture in space.
  [[nodiscard]] SceneContent seenFrom(const View &view) const;
  /// The id of the mark at a pixel of a view; empty for none.
  [[nodiscard]] std::string markAt(glm::dvec2 pixel, const View &view) const;

private:
  /// A figure of the scene, as it lies on the page.
  [[nodiscard]] Lazy<Figure> laid(const Figure &figure) const;

  FlatFrame m_frame;
  Stage m_stage;
  Lazy<Figure> m_whole; ///< of all steps
  Lazy<Figure> m_figure;
};

} // namespace halfspace
