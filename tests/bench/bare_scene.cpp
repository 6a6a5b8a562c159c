#include "tests/bench/bare_scene.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkArrowSource.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightsPass.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkOverlayPass.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkSphereSource.h>
#include <vtkTexture.h>
#include <vtkTexturedActor2D.h>
#include <vtkTranslucentPass.h>
#include <vtkTubeFilter.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace halfspace::bench {
namespace {

constexpr int tubeSides = 20;
constexpr int arrowSides = 36;
constexpr int ballMeridians = 32;
constexpr int ballParallels = 18;
/// An arrow's head in radii of its shaft.
constexpr double headLength = 9.5;
constexpr double headRadius = 3;
constexpr double longestHead = 0.45;

/// From the light that casts shadows onto z = 0.
vtkNew<vtkMatrix4x4> shadowMatrix() {
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 2, -0.25);
  matrix->SetElement(1, 2, 0.35);
  matrix->SetElement(2, 2, 0);
  return matrix;
}

vtkNew<vtkMatrix4x4> arrowMatrix(const BareArrow &arrow) {
  const glm::dvec3 along = glm::normalize(arrow.vector);
  const glm::dvec3 other = std::abs(along.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 side = glm::normalize(glm::cross(other, along));
  const glm::dvec3 up = glm::cross(along, side);
  const double length = glm::length(arrow.vector);
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row) {
    matrix->SetElement(row, 0, along[row] * length);
    matrix->SetElement(row, 1, side[row] * length);
    matrix->SetElement(row, 2, up[row] * length);
    matrix->SetElement(row, 3, arrow.from[row]);
  }
  return matrix;
}

void setLines(vtkPolyData *data, const std::vector<Path> &paths) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const Path &path : paths) {
    lines->InsertNextCell(static_cast<int>(path.size()));
    for (const glm::dvec3 &p : path)
      lines->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
  }
  data->SetPoints(points);
  data->SetLines(lines);
}

void setPolygon(vtkPolyData *data, const Path &corners) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(static_cast<int>(corners.size()));
  for (const glm::dvec3 &p : corners)
    polygons->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
  data->SetPoints(points);
  data->SetPolys(polygons);
}

void setTriangles(vtkPolyData *data, const std::vector<glm::dvec3> &corners,
                  const std::vector<glm::uvec3> &triangles) {
  vtkNew<vtkPoints> points;
  for (const glm::dvec3 &p : corners)
    points->InsertNextPoint(p.x, p.y, p.z);
  vtkNew<vtkCellArray> cells;
  for (const glm::uvec3 &triangle : triangles)
    cells->InsertNextCell({triangle.x, triangle.y, triangle.z});
  data->SetPoints(points);
  data->SetPolys(cells);
}

vtkNew<vtkImageData> imageData(const BareImage &image) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const std::ptrdiff_t rowBytes = image.width * 4;
  for (int row = 0; row < image.height; ++row)
    std::copy_n(image.rgba + row * rowBytes, rowBytes,
                static_cast<std::uint8_t *>(data->GetScalarPointer(0, image.height - 1 - row, 0)));
  return data;
}

/// An actor with its shadow and whatever source it has.
class Drawn {
public:
  explicit Drawn(vtkRenderer *renderer) : m_renderer(renderer) {
    m_actor->SetMapper(m_mapper);
    vtkProperty *material = m_actor->GetProperty();
    material->SetInterpolationToPhong();
    material->SetAmbient(0.42);
    material->SetDiffuse(0.70);
    material->SetSpecular(0.18);
    material->SetSpecularPower(24);
    m_renderer->AddActor(m_actor);
  }
  ~Drawn() {
    m_renderer->RemoveActor(m_actor);
    m_renderer->RemoveActor(m_shadow);
  }
  Drawn(const Drawn &) = delete;
  Drawn &operator=(const Drawn &) = delete;

  void show(const BareThing &thing) {
    setVisible(true);
    if (m_shown && *m_shown == thing)
      return;
    const bool isNew = !m_shown;
    m_shown = std::make_unique<BareThing>(thing);
    std::visit([&](const auto &kind) { set(kind, isNew); }, thing);
  }
  void setVisible(bool visible) {
    m_actor->SetVisibility(visible);
    m_shadow->SetVisibility(visible);
  }

private:
  void paint(glm::dvec3 color) { m_actor->GetProperty()->SetColor(color.x, color.y, color.z); }

  template <class Source> void connect(Source *source) {
    m_mapper->SetInputConnection(source->GetOutputPort());
    m_shadowMapper->SetInputConnection(source->GetOutputPort());
    castShadow();
  }
  void castShadow() {
    m_shadow->SetMapper(m_shadowMapper);
    m_shadow->SetUserMatrix(shadowMatrix());
    m_shadow->GetProperty()->LightingOff();
    m_shadow->GetProperty()->SetColor(0.85, 0.87, 0.89);
    m_renderer->AddActor(m_shadow);
  }

  void set(const BareGrid &grid, bool) {
    setLines(m_data, grid.lines);
    m_mapper->SetInputData(m_data);
    m_actor->GetProperty()->LightingOff();
    paint(grid.color);
  }
  void set(const BareTubes &tubes, bool isNew) {
    setLines(m_data, tubes.paths);
    m_tube->SetRadius(tubes.radius);
    paint(tubes.color);
    if (!isNew)
      return;
    m_tube->SetInputData(m_data);
    m_tube->SetNumberOfSides(tubeSides);
    m_tube->CappingOn();
    connect(m_tube.GetPointer());
  }
  void set(const BareArrow &arrow, bool isNew) {
    const double length = glm::length(arrow.vector);
    setVisible(length > 0);
    if (!(length > 0))
      return;
    const double head = std::min(longestHead, headLength * arrow.radius / length);
    m_arrow->SetTipLength(head);
    m_arrow->SetTipRadius(headRadius * head / headLength);
    m_arrow->SetShaftRadius(arrow.radius / length);
    const auto matrix = arrowMatrix(arrow);
    m_actor->SetUserMatrix(matrix);
    paint(arrow.color);
    if (isNew) {
      m_arrow->SetTipResolution(arrowSides);
      m_arrow->SetShaftResolution(tubeSides);
      connect(m_arrow.GetPointer());
    }
    vtkNew<vtkMatrix4x4> flattened;
    vtkMatrix4x4::Multiply4x4(shadowMatrix(), matrix, flattened);
    m_shadow->SetUserMatrix(flattened);
  }
  void set(const BareBall &ball, bool isNew) {
    m_sphere->SetCenter(ball.at.x, ball.at.y, ball.at.z);
    m_sphere->SetRadius(ball.radius);
    paint(ball.color);
    if (!isNew)
      return;
    m_sphere->SetThetaResolution(ballMeridians);
    m_sphere->SetPhiResolution(ballParallels);
    connect(m_sphere.GetPointer());
  }
  void set(const BareFace &face, bool isNew) {
    setPolygon(m_data, face.corners);
    m_actor->GetProperty()->LightingOff();
    m_actor->GetProperty()->SetOpacity(face.opacity);
    paint(face.color);
    if (!isNew)
      return;
    m_mapper->SetInputData(m_data);
    m_shadowMapper->SetInputData(m_data);
    castShadow();
  }

  void set(const BareMesh &mesh, bool isNew) {
    vtkNew<vtkMatrix4x4> matrix;
    for (glm::length_t column = 0; column < 4; ++column)
      for (glm::length_t row = 0; row < 4; ++row)
        matrix->SetElement(row, column, mesh.placement[column][row]);
    vtkNew<vtkMatrix4x4> flattened;
    vtkMatrix4x4::Multiply4x4(shadowMatrix(), matrix, flattened);
    if (isNew) {
      setTriangles(m_data, *mesh.corners, *mesh.triangles);
      m_actor->GetProperty()->SetInterpolationToFlat();
      m_mapper->SetInputData(m_data);
      m_shadowMapper->SetInputData(m_data);
      castShadow();
    }
    m_actor->SetUserMatrix(matrix);
    m_shadow->SetUserMatrix(flattened);
    paint(mesh.color);
  }

  vtkRenderer *m_renderer;
  std::unique_ptr<BareThing> m_shown;
  vtkNew<vtkPolyData> m_data;
  vtkNew<vtkTubeFilter> m_tube;
  vtkNew<vtkArrowSource> m_arrow;
  vtkNew<vtkSphereSource> m_sphere;
  vtkNew<vtkPolyDataMapper> m_mapper;
  vtkNew<vtkPolyDataMapper> m_shadowMapper;
  vtkNew<vtkActor> m_actor;
  vtkNew<vtkActor> m_shadow;
};

/// A picture on the screen.
class DrawnLabel {
public:
  explicit DrawnLabel(vtkRenderer *renderer) {
    vtkNew<vtkCellArray> cell;
    cell->InsertNextCell({0, 1, 2, 3});
    vtkNew<vtkFloatArray> texels;
    texels->SetNumberOfComponents(2);
    for (const float coordinate : {0.F, 0.F, 1.F, 0.F, 1.F, 1.F, 0.F, 1.F})
      texels->InsertNextValue(coordinate);
    m_corners->SetNumberOfPoints(4);
    vtkNew<vtkPolyData> rectangle;
    rectangle->SetPoints(m_corners);
    rectangle->SetPolys(cell);
    rectangle->GetPointData()->SetTCoords(texels);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(rectangle);
    m_actor->SetMapper(mapper);
    m_actor->SetTexture(m_texture);
    renderer->AddViewProp(m_actor);
  }

  void show(const BareLabel &label) {
    if (label.image.rgba != m_image.rgba) {
      m_image = label.image;
      m_texture->SetInputData(imageData(m_image));
      m_corners->SetPoint(0, 0, 0, 0);
      m_corners->SetPoint(1, m_image.width, 0, 0);
      m_corners->SetPoint(2, m_image.width, m_image.height, 0);
      m_corners->SetPoint(3, 0, m_image.height, 0);
      m_corners->Modified();
    }
    m_actor->SetPosition(label.pixel.x, label.pixel.y);
    m_actor->VisibilityOn();
  }
  void hide() { m_actor->VisibilityOff(); }

private:
  BareImage m_image;
  vtkNew<vtkPoints> m_corners;
  vtkNew<vtkTexture> m_texture;
  vtkNew<vtkTexturedActor2D> m_actor;
};

void usePlainPasses(vtkRenderer *renderer) {
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkOverlayPass> overlay;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(lights);
  passes->AddItem(opaque);
  passes->AddItem(translucent);
  passes->AddItem(overlay);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  renderer->SetPass(camera);
}

void addCameraLight(vtkRenderer *renderer, double x, double y, double z, double intensity) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

} // namespace

class BareScene::Impl {
public:
  vtkNew<vtkRenderer> renderer;
  std::map<std::string, std::unique_ptr<Drawn>> drawn;
  std::vector<std::unique_ptr<DrawnLabel>> labels;
};

BareScene::BareScene() : m_impl(std::make_unique<Impl>()) {
  vtkRenderer *renderer = m_impl->renderer;
  renderer->SetBackground(0.93, 0.95, 0.97);
  renderer->SetBackground2(1, 1, 1);
  renderer->GradientBackgroundOn();
  renderer->AutomaticLightCreationOff();
  addCameraLight(renderer, -0.5, 0.9, 1.0, 0.78);
  addCameraLight(renderer, 0.8, -0.2, 0.9, 0.30);
  usePlainPasses(renderer);
}

BareScene::~BareScene() = default;

vtkRenderer *BareScene::renderer() const { return m_impl->renderer; }

void BareScene::setCamera(const BareCamera &camera) {
  vtkCamera *vtk = m_impl->renderer->GetActiveCamera();
  vtk->SetPosition(camera.eye.x, camera.eye.y, camera.eye.z);
  vtk->SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
  vtk->SetViewUp(0, 0, 1);
  vtk->SetViewAngle(glm::degrees(camera.viewAngle));
}

void BareScene::show(const BarePicture &picture) {
  for (const auto &[name, thing] : m_impl->drawn)
    if (!picture.things.contains(name))
      thing->setVisible(false);
  for (const auto &[name, thing] : picture.things) {
    auto &drawn = m_impl->drawn[name];
    if (!drawn)
      drawn = std::make_unique<Drawn>(m_impl->renderer);
    drawn->show(thing);
  }
  while (m_impl->labels.size() < picture.labels.size())
    m_impl->labels.push_back(std::make_unique<DrawnLabel>(m_impl->renderer));
  for (std::size_t i = 0; i < m_impl->labels.size(); ++i)
    if (i < picture.labels.size())
      m_impl->labels[i]->show(picture.labels[i]);
    else
      m_impl->labels[i]->hide();
}

void BareScene::fitClippingRange() { m_impl->renderer->ResetCameraClippingRange(); }

BarePicture samplePicture(const std::vector<BareImage> &labels) {
  const glm::dvec3 blue(0, 0.45, 0.70);
  const glm::dvec3 orange(0.84, 0.37, 0);
  const glm::dvec3 gray(0.45, 0.5, 0.55);
  BarePicture picture;
  BareGrid grid{{}, {0.8, 0.84, 0.88}};
  for (int i = -13; i <= 13; ++i) {
    grid.lines.push_back({{i + 7, -5, 0}, {i + 7, 21, 0}});
    grid.lines.push_back({{-6, i + 8, 0}, {20, i + 8, 0}});
  }
  picture.things["grid"] = grid;
  const Path corners{{0, 2, 2}, {14, 2, 2}, {14, 16, 6}, {0, 16, 6}};
  picture.things["plane"] = BareFace{corners, blue, 0.3};
  picture.things["plane border"] =
      BareTubes{{{corners[0], corners[1], corners[2], corners[3], corners[0]}}, 0.045, blue};
  picture.things["normal"] = BareArrow{{7, 9, 4}, {0, -1.1, 4}, 0.11, blue};
  picture.things["ray"] = BareArrow{{2, 4, 11}, {4, 3, -4}, 0.11, orange};
  picture.things["line"] = BareTubes{{{{2, 4, 11}, {12, 11.5, 1}}}, 0.05, orange};
  for (int i = 0; i < 4; ++i) {
    picture.things["point " + std::to_string(i)] =
        BareBall{{3.0 * i + 2, 4 + 2.0 * i, 3.0 + i}, 0.25, orange};
    BareTubes dashes{{}, 0.05, gray};
    for (int dash = 0; dash < 8; ++dash)
      dashes.paths.push_back(
          {{3.0 * i + 2, 4 + 2.0 * i, 0.35 * dash}, {3.0 * i + 2, 4 + 2.0 * i, 0.35 * dash + 0.2}});
    picture.things["drop " + std::to_string(i)] = dashes;
  }
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 vector(0);
    vector[axis] = 16;
    picture.things["axis " + std::to_string(axis)] = BareArrow{{}, vector, 0.055, gray};
  }
  for (std::size_t i = 0; i < labels.size(); ++i)
    picture.labels.push_back(
        {labels[i], {60 + 40.0 * static_cast<double>(i % 18), 60 + 70.0 * static_cast<double>(i / 18)}});
  return picture;
}

} // namespace halfspace::bench
