// The labels on the screen: one textured rectangle each, a texel for a pixel, and leader lines.
#pragma once

#include "widgets/picture/shapes/shape_list.h"

#include <vtkNew.h>

#include <memory>
#include <vector>

class vtkActor2D;
class vtkPolyData;
class vtkRenderer;
class vtkTexture;
class vtkTexturedActor2D;

namespace halfspace {

class LabelOverlay {
public:
  LabelOverlay(vtkRenderer *renderer, LabelPainter painter);
  ~LabelOverlay();

  /// Shows the pictures of labels, and leaders, on a page of a size.
  void show(const ShapeLayer &labels, PixelSize size);

  /// Moves all labels down by so many pixels, off their places in the view.
  void lowerBy(int pixels);

private:
  using Picture = std::shared_ptr<const RgbaImage>;
  struct Sprite;

  [[nodiscard]] Sprite &sprite(std::size_t number);
  void showLeaders(const std::vector<Shape> &shapes, PixelSize size);

  vtkRenderer *m_renderer;
  LabelPainter m_painter;
  ShapeLayer m_shown;
  PixelSize m_size;
  std::vector<std::unique_ptr<Sprite>> m_sprites;
  vtkNew<vtkPolyData> m_leaderLines;
  vtkNew<vtkActor2D> m_leaders;
};

} // namespace halfspace
