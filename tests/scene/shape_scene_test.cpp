#include "widgets/scene/shape_scene.h"

#include "tests/picture/marks.h"
#include "tests/scene/pictures.h"
#include "widgets/picture/composer.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>
#include <vtkRenderer.h>

#include <numeric>

namespace halfspace {
namespace {

constexpr Rgba magenta{255, 0, 255, 255};
constexpr int labelWidth = 18;
constexpr int labelHeight = 9;

/// Of type at 11 pixels, half of the usual, a formula of this size has a label of that size.
math::Layout smallFormula() {
  math::Layout formula;
  formula.width = 1;
  formula.ascent = 0.17;
  formula.rules.emplace_back();
  return formula;
}

std::shared_ptr<const RgbaImage> paintMagenta(const LabelFormula &formula, const LabelStyle &style) {
  const LabelRoom room = roomOf(*formula, style);
  auto picture = std::make_shared<RgbaImage>();
  picture->width = room.width;
  picture->height = room.height;
  for (int i = 0; i < room.width * room.height; ++i)
    picture->rgba.insert(picture->rgba.end(), {255, 0, 255, 255});
  return picture;
}

/// Only the mark's label is not empty: a plain rectangle.
const Labels magentaForQ{[](const std::string &latex) {
                           return std::make_shared<const math::Layout>(latex == "Q" ? smallFormula()
                                                                                    : math::Layout());
                         },
                         paintMagenta};

Figure labelledPoint() {
  PointMark point = withId(pointAt({11, 15, 8}), "point.Q", Subject::Point);
  point.label = "Q";
  return {{point}};
}

TEST(ShapeScene, DrawsALabelTexelForPixel) {
  const auto picture = drawOffscreen(requestFor(labelledPoint()), magentaForQ);
  ASSERT_TRUE(picture);
  int count = 0;
  for (int y = 0; y < picture->height; ++y)
    for (int x = 0; x < picture->width; ++x)
      count += pixelAt(*picture, x, y) == magenta;
  EXPECT_EQ(count, labelWidth * labelHeight);
}

/// The middle of all that is magenta.
glm::dvec2 middleOfLabel(const PictureRequest &request) {
  const auto picture = drawOffscreen(request, magentaForQ);
  EXPECT_TRUE(picture);
  glm::dvec2 sum(0);
  int count = 0;
  for (int y = 0; y < picture->height; ++y)
    for (int x = 0; x < picture->width; ++x)
      if (pixelAt(*picture, x, y) == magenta) {
        sum += glm::dvec2(x, y);
        ++count;
      }
  EXPECT_GT(count, 0);
  return sum / double(count);
}

TEST(ShapeScene, LabelledLikeAnother_HasItsLabelsWhereTheyStandThere) {
  PictureRequest request = requestFor(labelledPoint());
  const glm::dvec2 alone = middleOfLabel(request);
  PictureRequest crowded = request;
  const SightLine sight = request.camera.sightThrough(alone, request.size);
  const Place there = sight.origin + glm::normalize(sight.direction) * request.camera.distance();
  crowded.content.figure.marks.push_back(withId(pointAt(there), "R", Subject::Neutral));
  const glm::dvec2 aside = middleOfLabel(crowded);
  EXPECT_GT(glm::distance(aside, alone), 3);
  request.labelledLike = crowded.content;
  EXPECT_EQ(middleOfLabel(request), aside);
}

TEST(ShapeScene, LabelledLikeTheLast_HasItsLabelsWhereTheyWouldStandInThat) {
  PictureRequest request = requestFor(labelledPoint());
  PictureRequest crowded = request;
  const glm::dvec2 alone = middleOfLabel(request);
  const SightLine sight = request.camera.sightThrough(alone, request.size);
  const Place there = sight.origin + glm::normalize(sight.direction) * request.camera.distance();
  crowded.content.figure.marks.push_back(withId(pointAt(there), "R", Subject::Neutral));
  PictureRequest like = request;
  like.labelledLike = crowded.content;
  request.isLabelledLikeLast = true;
  OffscreenPainter painter(magentaForQ.set, magentaForQ.paint);
  painter.arrange(crowded);
  const auto arranged = painter.draw(request);
  ASSERT_TRUE(arranged && painter.draw(crowded));
  const auto drawn = painter.draw(request);
  const auto expected = drawOffscreen(like, magentaForQ);
  ASSERT_TRUE(drawn && expected);
  EXPECT_EQ(arranged->rgba, expected->rgba);
  EXPECT_EQ(drawn->rgba, expected->rgba);
}

TEST(ShapeScene, OfAPainterThatLives_HasItsLabelsWhereAFirstPictureHasThem) {
  const PictureRequest request = requestFor(labelledPoint());
  PictureRequest moved = request;
  moved.content.figure.marks.change(0, [](Mark &mark) { std::get<PointMark>(mark).at = {11, 14, 2}; });
  OffscreenPainter painter(magentaForQ.set, magentaForQ.paint);
  for (const PictureRequest &each : {moved, requestFor({}), request}) {
    const auto picture = painter.draw(each);
    const auto alone = drawOffscreen(each, magentaForQ);
    ASSERT_TRUE(picture && alone);
    EXPECT_EQ(picture->rgba, alone->rgba);
  }
}

/// When the meshes that a scene draws were last made.
std::vector<vtkMTimeType> meshTimes(const ShapeScene &scene) {
  std::vector<vtkMTimeType> times;
  vtkActorCollection *actors = scene.renderer()->GetActors();
  actors->InitTraversal();
  while (vtkActor *actor = actors->GetNextActor())
    times.push_back(actor->GetMapper()->GetInput()->GetMTime());
  return times;
}

int differences(const std::vector<vtkMTimeType> &a, const std::vector<vtkMTimeType> &b) {
  return static_cast<int>(a.size()) -
         std::inner_product(a.begin(), a.end(), b.begin(), 0, std::plus<>(), std::equal_to<>());
}

TEST(ShapeScene, TurnedOrWithAnotherGizmo_KeepsTheMeshesOfTheFigure) {
  PictureRequest request = requestFor(labelledPoint());
  Composer composer(noLabels.set);
  ShapeScene scene(noLabels.paint);
  composer.setContent(request.content);
  composer.setView({request.camera, request.size, 1});
  scene.show(composer.compose());
  const auto start = meshTimes(scene);
  composer.setTools(Gizmo{}, {});
  scene.show(composer.compose());
  const auto withGizmo = meshTimes(scene);
  EXPECT_EQ(differences(start, withGizmo), 1); // the tools
  composer.setTools(Gizmo{}, {});
  scene.show(composer.compose());
  EXPECT_EQ(meshTimes(scene), withGizmo);
  request.camera.turn(0.3, 0.1);
  composer.setView({request.camera, request.size, 1});
  scene.show(composer.compose());
  EXPECT_LE(differences(withGizmo, meshTimes(scene)), 4); // the tools, the axes, the faces and their shadow
}

/// So near that the axes are as long for any number.
Figure wallsOneBehindAnother(int count) {
  Figure walls;
  for (int i = 0; i < count; ++i) {
    const double x = -i / 1000.0;
    walls.add(
        withId(polygonOf({{x, -9, -9}, {x, 9, -9}, {x, 9, 9}, {x, -9, 9}}), "wall" + std::to_string(i)));
  }
  return walls;
}

MeshMark meshOfFloors(std::uint32_t count) {
  auto mesh = std::make_shared<TriangleMesh>();
  for (std::uint32_t i = 0; i < count; ++i) {
    const double z = i / 1000.0;
    mesh->corners.insert(mesh->corners.end(), {{0, 0, z}, {9, 0, z}, {0, 9, z}});
    mesh->triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  MeshMark mark;
  mark.id = "floors";
  mark.box = {{0, 0, 0}, {9, 9, 1}};
  mark.mesh = std::move(mesh);
  return mark;
}

/// How many polygons all actors together draw.
vtkIdType polygonsDrawn(const SceneContent &content, bool leavesOut) {
  Composer composer(noLabels.set);
  composer.setContent(content);
  ShapeScene scene(noLabels.paint);
  scene.show(composer.compose());
  EXPECT_EQ(composer.compose().leavesOutSurfaces, leavesOut);
  vtkIdType count = 0;
  vtkActorCollection *actors = scene.renderer()->GetActors();
  actors->InitTraversal();
  while (vtkActor *actor = actors->GetNextActor())
    count += actor->GetMapper()->GetInput()->GetNumberOfCells();
  return count;
}

TEST(ShapeScene, OfVeryManyFacesOneBehindAnother_DrawsSome_AndThoseThatStandOut) {
  SceneContent content;
  content.figure = wallsOneBehindAnother(40);
  const vtkIdType ofForty = polygonsDrawn(content, false);
  content.figure = wallsOneBehindAnother(41);
  EXPECT_LT(polygonsDrawn(content, true), ofForty);
  content.figure = wallsOneBehindAnother(160);
  EXPECT_EQ(polygonsDrawn(content, true), ofForty);
  content.highlighted = {"wall1"};
  EXPECT_GT(polygonsDrawn(content, true), ofForty);
}

TEST(ShapeScene, OfAMeshOfVeryManyTrianglesOneBehindAnother_DrawsOneInSoMany) {
  SceneContent content;
  content.figure = {{meshOfFloors(80)}};
  const vtkIdType ofEighty = polygonsDrawn(content, false);
  content.figure = {{meshOfFloors(320)}};
  EXPECT_EQ(polygonsDrawn(content, true), ofEighty);
}

TEST(ShapeScene, WritesALabelThatArrivesPaler) {
  PictureRequest request = requestFor(labelledPoint());
  request.content.arrival = {{"point.Q"}, 0.5};
  const auto picture = drawOffscreen(request, magentaForQ);
  ASSERT_TRUE(picture);
  int full = 0;
  int paler = 0;
  for (int y = 0; y < picture->height; ++y)
    for (int x = 0; x < picture->width; ++x) {
      const Rgba pixel = pixelAt(*picture, x, y);
      full += pixel == magenta;
      paler += pixel.red > 240 && pixel.blue > 240 && pixel.green > 90 && pixel.green < 150;
    }
  EXPECT_EQ(full, 0);
  EXPECT_EQ(paler, labelWidth * labelHeight);
}

} // namespace
} // namespace halfspace
