// The session's scene on the page of its lesson's flat picture.
#pragma once

#include "lessons/lazy.h"
#include "widgets/picture/flat_page.h"
#include "widgets/picture/scene_content.h"
#include "widgets/session_model.h"

namespace halfspace {

/// Follows the session. There is none where the lesson has no flat picture, or its scene not what that is
/// made of. Its figures are made when somebody looks at them. Pixels are those that it is fitted to.
class FlatPicture {
public:
  explicit FlatPicture(const SessionModel &model) : m_model(model) {}

  /// The session is another one, or elsewhere. A page that is `held` keeps still; null: it lies as the scene
  /// says.
  void take(const FlatFrame *held);
  [[nodiscard]] bool isThere() const { return m_frame.has_value(); }

  // While it is there:

  /// Looks at the whole of it, of all steps, from a screen that is covered in part.
  void fit(PixelSize screen, double pixelRatio, const PixelBox &covered);
  /// Whether the whole of it is in view.
  [[nodiscard]] bool isInView() const { return showsAll(*m_whole, m_view); }

  [[nodiscard]] const FlatFrame &frame() const { return *m_frame; }
  [[nodiscard]] const Figure &figure() const { return *m_figure; }
  [[nodiscard]] const Stage &stage() const { return m_stage; }
  [[nodiscard]] const View &view() const { return m_view; }
  /// What is seen of it.
  [[nodiscard]] SceneContent shown() const;
  /// The handle at a pixel that can be moved there; nothing for none.
  [[nodiscard]] std::optional<Handle> handleAt(glm::dvec2 pixel) const;
  /// The id of the mark at a pixel; empty for none.
  [[nodiscard]] std::string markAt(glm::dvec2 pixel) const;

private:
  /// A figure of the scene, as it lies on the page.
  [[nodiscard]] Lazy<Figure> laid(const Figure &figure) const;

  const SessionModel &m_model;
  std::optional<FlatFrame> m_frame;
  Stage m_stage;
  Lazy<Figure> m_whole = laid({}); ///< of all steps
  Lazy<Figure> m_figure = laid({});
  View m_view;
};

} // namespace halfspace
