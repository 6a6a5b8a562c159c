#include "widgets/scene/label_overlay.h"

#include "widgets/scene/vtk_image.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkTexturedActor2D.h>

namespace halfspace {

/// A rectangle of the screen with a picture on it.
struct LabelOverlay::Sprite {
  vtkRenderer *renderer;
  Picture picture;
  vtkNew<vtkPoints> corners;
  vtkNew<vtkPolyData> rectangle;
  vtkNew<vtkImageData> image;
  vtkNew<vtkTexture> texture;
  vtkNew<vtkTexturedActor2D> actor;

  explicit Sprite(vtkRenderer *owner) : renderer(owner) {
    corners->SetNumberOfPoints(4);
    vtkNew<vtkCellArray> cell;
    cell->InsertNextCell({0, 1, 2, 3});
    vtkNew<vtkFloatArray> texels;
    texels->SetNumberOfComponents(2);
    for (const float coordinate : {0.F, 0.F, 1.F, 0.F, 1.F, 1.F, 0.F, 1.F})
      texels->InsertNextValue(coordinate);
    rectangle->SetPoints(corners);
    rectangle->SetPolys(cell);
    rectangle->GetPointData()->SetTCoords(texels);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(rectangle);
    texture->SetInputData(image);
    texture->InterpolateOff();
    texture->RepeatOff();
    actor->SetMapper(mapper);
    actor->SetTexture(texture);
    renderer->AddViewProp(actor);
  }
  ~Sprite() { renderer->RemoveViewProp(actor); }
  Sprite(const Sprite &) = delete;
  Sprite &operator=(const Sprite &) = delete;

  void show(const Picture &newPicture, glm::dvec2 topLeft, PixelSize size, double opacity) {
    if (newPicture != picture) {
      picture = newPicture;
      write(*picture, image);
    }
    const double left = topLeft.x;
    const double right = left + picture->width;
    const double top = size.height - topLeft.y;
    const double bottom = top - picture->height;
    corners->SetPoint(0, left, bottom, 0);
    corners->SetPoint(1, right, bottom, 0);
    corners->SetPoint(2, right, top, 0);
    corners->SetPoint(3, left, top, 0);
    corners->Modified();
    actor->GetProperty()->SetOpacity(opacity);
    actor->VisibilityOn();
  }
};

LabelOverlay::LabelOverlay(vtkRenderer *renderer, LabelPainter painter)
    : m_renderer(renderer), m_painter(std::move(painter)) {
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(m_leaderLines);
  m_leaders->SetMapper(mapper);
  m_renderer->AddViewProp(m_leaders);
}

LabelOverlay::~LabelOverlay() { m_renderer->RemoveViewProp(m_leaders); }

LabelOverlay::Sprite &LabelOverlay::sprite(std::size_t number) {
  while (m_sprites.size() <= number)
    m_sprites.push_back(std::make_unique<Sprite>(m_renderer));
  return *m_sprites[number];
}

void LabelOverlay::show(const ShapeLayer &labels, PixelSize size) {
  if (labels == m_shown && size == m_size)
    return;
  m_shown = labels;
  m_size = size;
  std::size_t count = 0;
  forEach<LabelShape>(*labels, [&](const Shape &, const LabelShape &label) {
    sprite(count++).show(m_painter(label.formula, label.style), label.box.low, size, label.opacity);
  });
  for (std::size_t i = count; i < m_sprites.size(); ++i)
    m_sprites[i]->actor->VisibilityOff();
  showLeaders(*labels, size);
}

void LabelOverlay::showLeaders(const std::vector<Shape> &shapes, PixelSize size) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const auto insert = [&](glm::dvec2 pixel) {
    return points->InsertNextPoint(pixel.x, size.height - pixel.y, 0);
  };
  forEach<LeaderShape>(shapes, [&](const Shape &shape, const LeaderShape &leader) {
    const vtkIdType from = insert(leader.from);
    lines->InsertNextCell({from, insert(leader.to)});
    // They all look the same.
    m_leaders->GetProperty()->SetColor(shape.color.red / 255.0, shape.color.green / 255.0,
                                       shape.color.blue / 255.0);
    m_leaders->GetProperty()->SetLineWidth(static_cast<float>(leader.width));
  });
  m_leaderLines->SetPoints(points);
  m_leaderLines->SetLines(lines);
  m_leaders->SetVisibility(points->GetNumberOfPoints() > 0);
}

void LabelOverlay::lowerBy(int pixels) {
  for (const std::unique_ptr<Sprite> &sprite : m_sprites)
    sprite->actor->SetPosition(0, -pixels);
  m_leaders->SetPosition(0, -pixels);
}

} // namespace halfspace
