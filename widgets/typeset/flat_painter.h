// Paints flat pictures: on a widget, on an image.
#pragma once

#include "widgets/picture/labels/label_page.h"

class QPainter;

namespace halfspace {

class Typesetter;

/// Paints from frame to frame; labels stay where they were as long as they can. The typesetter must outlive
/// it.
class FlatPainter {
public:
  explicit FlatPainter(const Typesetter &typesetter);

  /// A figure that is laid flat, as the view's camera sees it, in the painter's units.
  void paint(QPainter &painter, const SceneContent &content, const Theme &theme, const View &view);

private:
  const Typesetter &m_typesetter;
  LabelSetter m_set;
  LabelPage m_page;
};

/// The same as a picture for a file, on the theme's background or on none. Throws std::bad_alloc where there
/// is not enough memory for it.
[[nodiscard]] RgbaImage drawFlat(const SceneContent &content, const Theme &theme, const View &view,
                                 bool isTransparent, const Typesetter &typesetter);

} // namespace halfspace
