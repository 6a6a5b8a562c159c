// The widget that a scene is drawn in, as a screen: its pixels, and what the user wants of them.
#pragma once

#include "widgets/view/viewpoint.h"

#include <QWidget>

namespace halfspace {

/// Pixels are those of the device, a widget's pixels are Qt's.
class ViewScreen {
public:
  /// The widget must outlive it.
  explicit ViewScreen(const QWidget &widget) : m_widget(widget) {}

  /// Makes type, lines and handles larger; 1 is their usual size.
  void setSizeScale(double scale) { m_sizeScale = scale; }
  /// Whether the camera may glide from view to view, and new marks fade in.
  void setMotion(bool on) { m_motion = on; }

  [[nodiscard]] PixelSize size() const;
  /// How many pixels a design pixel has, in which labels, thicknesses and handles are measured.
  [[nodiscard]] double designRatio() const { return m_widget.devicePixelRatioF() * m_sizeScale; }
  /// Whether what glides or fades is seen to do so.
  [[nodiscard]] bool moves() const { return m_motion && m_widget.isVisible(); }
  /// All of this, for a camera.
  [[nodiscard]] Screen now() const { return {size(), designRatio(), moves()}; }

  /// The pixel at a place of the widget.
  [[nodiscard]] glm::dvec2 pixelAt(const QPointF &place) const;
  /// The pixels under a part of the widget.
  [[nodiscard]] PixelBox boxOf(const QRect &part) const;

private:
  const QWidget &m_widget;
  double m_sizeScale = 1;
  bool m_motion = true;
};

} // namespace halfspace
