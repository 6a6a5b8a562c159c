// Scenes of every size that coordinates allow, near-parallel ones and those with far results: each has a
// picture in which its objects can be seen, in bounded time and memory.
#include "lessons/construction/construction.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/solid.h"
#include "lessons/reading/typed_number.h"
#include "lessons/scene/evaluation.h"
#include "tests/geometry/random_numbers.h"
#include "tests/picture/shapes/mesh_of.h"
#include "tests/scene/pictures.h"
#include "widgets/picture/camera_views.h"
#include "widgets/picture/design_scale.h"
#include "widgets/picture/labels/label_layout.h"
#include "widgets/picture/labels/label_requests.h"
#include "widgets/picture/shapes/ground.h"
#include "widgets/picture/shapes/mark_outline.h"
#include "widgets/picture/shapes/mark_shapes.h"
#include "widgets/picture/shapes/translucent_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sys/resource.h>

namespace halfspace {
namespace {

// What all of a test's pictures may take together; one without bounds takes any of it.
constexpr rlim_t memoryLimit = rlim_t{8} << 30U;
constexpr rlim_t secondsLimit = 200;

constexpr int picturesDrawn = 160;
constexpr int picturesPrepared = 2000;

constexpr PixelSize size{320, 200};

/// Far above what any of these scenes needs, far below what a loop without a bound makes.
constexpr std::size_t mostCorners = 500'000;
constexpr std::size_t mostLabels = 300;
constexpr std::size_t mostGridLines = 400;

void limit(int resource, rlim_t most) {
  const rlimit bounds{most, most};
  ASSERT_EQ(setrlimit(static_cast<__rlimit_resource>(resource), &bounds), 0);
}

/// Makes scenes with one construction over random objects.
class ExtremeScenes {
public:
  explicit ExtremeScenes(std::uint64_t seed) : m_random(seed) {}

  Scene next() {
    for (;;) {
      Scene scene = anyScene();
      if (isAccepted(scene))
        return scene;
    }
  }

private:
  int integer(int low, int high) { return m_random.integer(low, high); }

  ExactVec3 vector(int exponent) {
    const auto number = [&] { return Rational(integer(-999, 999), 100) * powerOfTen(exponent); };
    return {number(), number(), number()};
  }

  Scene anyScene() {
    const auto &table = constructions();
    const Construction &construction = table[static_cast<std::size_t>(integer(0, int(table.size()) - 1))];
    const int kind = integer(0, 3);
    const int exponent = integer(-9, 8);
    const ExactVec3 farAway = kind == 1 ? vector(8) : ExactVec3(0);
    Scene scene;
    ConstructionUse use{std::string(construction.id), {}};
    for (const ConstructionRole &role : construction.roles) {
      const int count = role.isList ? integer(1, maxListedObjects) : 1;
      for (int place = 0; place < count; ++place) {
        const auto words = kindsSeenAs(role.kind);
        Object object = *makeObject(words[static_cast<std::size_t>(integer(0, int(words.size()) - 1))]);
        for (std::size_t i = 0; i < coordinatesOf(object).size(); ++i) {
          coordinate(object, i) = vector(kind == 2 ? integer(-9, 8) : exponent);
          if (coordinatesOf(object)[i].role == CoordinateRole::Position)
            coordinate(object, i) += farAway;
        }
        object.kind().settle(object); // as on every way into a scene
        scene.entries.push_back({role.isList ? role.name + std::to_string(place) : role.name, object});
        use.roles[role.name].ids.push_back(scene.entries.back().name);
      }
    }
    if (kind == 3)
      makeNearlyParallel(scene);
    scene.entries.push_back({"use", use});
    return scene;
  }

  /// Turns a ray almost into the plane beside it: what it meets is far away.
  void makeNearlyParallel(Scene &scene) {
    ExactVec3 normal(0);
    for (const Entry &entry : scene.entries) {
      const auto &object = std::get<Object>(entry.content);
      if (const auto plane = objectAs<PlaneObject>(object))
        normal = plane->normal;
      if (const auto triangle = objectAs<TriangleObject>(object))
        normal = cross(triangle->p1 - triangle->p0, triangle->p2 - triangle->p0);
    }
    const Rational largest = std::max({abs(normal.x), abs(normal.y), abs(normal.z)});
    if (largest == 0)
      return;
    normal *= Rational(1 / largest);
    for (std::size_t place = 0; place < scene.entries.size(); ++place)
      if (Object object = std::get<Object>(scene.entries[place].content); kindOf(object) == RayObject::kind) {
        object[1] = cross(normal, vector(0)) + normal * powerOfTen(-integer(1, 20));
        setObject(scene, scene.entries[place].name, std::move(object));
      }
  }

  static bool isAccepted(const Scene &scene) {
    for (const CoordinateId &id : coordinatesOf(scene))
      for (int axis = 0; axis < 3; ++axis)
        if (refuseCoordinate(coordinate(*findObject(scene, id.object), id.index)[axis]))
          return false;
    return true;
  }

  RandomNumbers m_random;
};

std::string inWords(const Scene &scene) {
  std::string text;
  for (const CoordinateId &id : coordinatesOf(scene)) {
    const ExactVec3 &value = coordinate(*findObject(scene, id.object), id.index);
    text += fullName(scene, id) + "=" + toText(value.x) + "," + toText(value.y) + "," + toText(value.z) + " ";
  }
  return text;
}

struct Prepared {
  SceneContent content;
  Camera camera;
};

Prepared prepared(const Scene &scene) {
  Prepared made;
  made.content.stage = stageOf(scene);
  made.content.figure = toStage(figureOf(evaluate(scene)), made.content.stage);
  made.camera = homeView({}, made.content.figure, made.content.stage.hasAxes(), size, ownPixelRatio(size));
  return made;
}

bool isWithinReach(const Place &place) {
  return isFinite(place) && glm::length(place) <= 2 * drawnReach; // a patch goes on around its points
}

void expectFiniteAndBounded(const Mesh &mesh) {
  EXPECT_LE(mesh.positions.size(), mostCorners);
  for (const glm::vec3 &position : mesh.positions)
    ASSERT_TRUE(isWithinReach(Place(position)));
  for (const glm::vec3 &normal : mesh.normals)
    ASSERT_TRUE(isFinite(Place(normal)));
}

/// A ball is drawn as many flat faces, a polygon as a few where others cut it, all else as fewer.
std::size_t mostFacesOf(const Figure &figure) {
  constexpr std::size_t ofABall = 200;
  constexpr std::size_t ofTheRest = 100;
  constexpr std::size_t ofAPolygon = 8;
  std::size_t most = ofTheRest;
  for (const Mark &mark : figure.marks)
    most += std::holds_alternative<SphereMark>(mark)    ? ofABall
            : std::holds_alternative<PolygonMark>(mark) ? ofAPolygon
                                                        : 0;
  return most;
}

void expectAllIsBounded(const Prepared &made) {
  const Figure &figure = made.content.figure;
  const Theme &theme = themes().front();
  const View view{made.camera, size, ownPixelRatio(size)};
  const double scale = designScale(view.camera, size, view.pixelRatio);
  EXPECT_FALSE(figure.marks.empty());
  for (const Mark &mark : figure.marks)
    for (const Place &place : outlineOf(mark, rightAngleSize * scale).path)
      ASSERT_TRUE(isWithinReach(place)) << baseOf(mark).id;
  expectFiniteAndBounded(meshOf(solidsOf(figure, {}, theme, scale)));
  const FaceOrder faces(facesOf(figure, {}, theme));
  EXPECT_LE(faces.backToFront(glm::dvec4(view.camera.eye(), 1)).size(), mostFacesOf(figure));
  EXPECT_LE(gridAround(view.camera).lines.size(), mostGridLines);
  const AxesReach axes = axesAround(figure);
  expectFiniteAndBounded(meshOf(axesOf(axes, view.camera, theme, scale)));
  const auto labels = writtenLabels(
      made.content, axisLabels(axes, view.camera, made.content.stage.exponent, scale), theme, view);
  EXPECT_LE(labels.size(), mostLabels);
  for (const WrittenLabel &label : labels) {
    EXPECT_LE(label.latex.size(), 400U) << label.latex;
    for (const LabelAnchor &anchor : label.anchors)
      EXPECT_TRUE(std::isfinite(anchor.pixel.x) && std::isfinite(anchor.pixel.y)) << label.latex;
  }
}

/// Every given point is where the camera has it, within the picture, and solid.
void expectGivenPointsSeen(const Prepared &made, const RgbaImage &picture) {
  int seen = 0;
  for (const Mark &mark : made.content.figure.marks) {
    const auto *point = std::get_if<PointMark>(&mark);
    if (!point || point->role != Role::Given)
      continue;
    const auto pixel = made.camera.project(point->at, size);
    ASSERT_TRUE(pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x < size.width && pixel->y < size.height)
        << point->id;
    EXPECT_GE(pixelAt(picture, *pixel).alpha, 200) << point->id;
    ++seen;
  }
  EXPECT_GT(seen, 0);
}

TEST(ExtremeScenes, Prepared_AreFiniteAndBounded) {
  limit(RLIMIT_AS, memoryLimit);
  limit(RLIMIT_CPU, secondsLimit);
  ExtremeScenes scenes(2027);
  for (int i = 0; i < picturesPrepared && !testing::Test::HasFailure(); ++i) {
    const Scene scene = scenes.next();
    SCOPED_TRACE(inWords(scene));
    expectAllIsBounded(prepared(scene));
  }
}

TEST(ExtremeScenes, Drawn_ShowTheirGivenPoints) {
  limit(RLIMIT_AS, memoryLimit);
  limit(RLIMIT_CPU, secondsLimit);
  ExtremeScenes scenes(618);
  for (int i = 0; i < picturesDrawn && !testing::Test::HasFailure(); ++i) {
    const Scene scene = scenes.next();
    SCOPED_TRACE(inWords(scene));
    const Prepared made = prepared(scene);
    PictureRequest request;
    request.content = made.content;
    request.camera = made.camera;
    request.theme = *findTheme("light");
    request.size = size;
    request.transparent = true;
    const auto picture = drawOffscreen(request, noLabels);
    ASSERT_TRUE(picture) << picture.problem().text();
    expectGivenPointsSeen(made, *picture);
  }
}

} // namespace
} // namespace halfspace
