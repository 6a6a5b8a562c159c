// The labels on the screen: one textured rectangle each, a texel for a pixel, and leader lines.
#pragma once

#include "widgets/picture/labels/label_page.h"

#include <vtkNew.h>

#include <memory>
#include <string>
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

  /// Has labels set and placed, and shows their pictures; empty ones are left out.
  void show(const std::vector<LabelText> &texts, const LabelObstacles &obstacles, const Theme &theme,
            const View &view);

  /// Moves all labels down by so many pixels, off their places in the view.
  void lowerBy(int pixels);

  /// The id of the mark whose label covers a pixel, or empty.
  [[nodiscard]] std::string markAt(glm::dvec2 pixel) const;

private:
  using Picture = std::shared_ptr<const LabelPicture>;
  struct Sprite;

  [[nodiscard]] Sprite &sprite(std::size_t number);
  void showLeaders(const Theme &theme, const View &view);

  vtkRenderer *m_renderer;
  LabelPainter m_painter;
  LabelPage m_page;
  std::vector<LabelOnPage> m_labels; ///< those on the screen
  std::vector<std::unique_ptr<Sprite>> m_sprites;
  vtkNew<vtkPolyData> m_leaderLines;
  vtkNew<vtkActor2D> m_leaders;
};

} // namespace halfspace
