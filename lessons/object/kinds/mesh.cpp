#include "lessons/object/kinds/mesh.h"

#include "geometry/decide.h"
#include "geometry/surd.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kind.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace halfspace {
namespace {

/// A heading whose length is no fraction turns by the angle whose half has the nearest tangent that is a
/// multiple of this: at most a third of a degree off, in numbers that stay short.
const Rational tangentStep(1, 200);

struct Turn {
  Rational cosine;
  Rational sine;
};

/// Towards (x, y), as near as fractions come. Requires x ≥ 0 and not both 0.
Turn turnTowards(const Rational &x, const Rational &y) {
  const Surd length = Surd::root(x * x + y * y);
  if (length.isRational())
    return {x / length.rationalPart(), y / length.rationalPart()};
  const double tangent = toDouble(y) / (toDouble(x) + toDouble(length));
  const Rational half = roundToMultiple(tangent, tangentStep);
  const Rational squares = 1 + half * half;
  return {(1 - half * half) / squares, 2 * half / squares};
}

Turn turnOf(const ExactVec3 &heading) {
  const auto &[x, y] = std::pair(heading.x, heading.y);
  if (x == 0 && y == 0)
    return {1, 0};
  if (x >= 0)
    return turnTowards(x, y);
  const Turn back = turnTowards(-x, -y);
  return {-back.cosine, -back.sine};
}

/// The scene's places of all corners that faces are drawn with.
std::vector<ExactVec3> cornersOf(const MeshObject &mesh) {
  const MeshPlacement placement(mesh);
  std::vector<ExactVec3> corners;
  corners.reserve(mesh.shape->mesh()->corners.size());
  for (const Vec3<double> &corner : mesh.shape->mesh()->corners)
    corners.push_back(placement.toScene(exactly(corner)));
  return corners;
}

std::vector<Mark> draw(const Given<Object> &given) {
  const MeshObject mesh = as<MeshObject>(given).object;
  std::vector<Mark> marks;
  if (!mesh.shape->faces().empty()) {
    std::vector<std::vector<std::size_t>> faces;
    for (const MeshFace &face : mesh.shape->faces())
      faces.emplace_back(face.begin(), face.end());
    addFaces(given, Subject::Neutral, cornersOf(mesh), faces, marks);
  } else {
    marks.push_back(MeshMark{wholeOf(given, Subject::Neutral),
                             mesh.shape->mesh(),
                             mesh.shape->search(),
                             {mesh.shape->box().low, mesh.shape->box().high},
                             place(mesh.place),
                             MeshPlacement(mesh).axes()});
  }
  if (!isZero(mesh.heading)) {
    ArrowMark heading = arrowMark(given, 1, Subject::Neutral);
    heading.label.clear();
    marks.push_back(std::move(heading));
  }
  PointMark where = pointMark(given, 0, Subject::Neutral);
  where.label.clear(); // the mesh has a name of its own
  marks.push_back(std::move(where));
  return marks;
}

/// What others catch at of a mesh with few faces: its corners, the edges of its faces, and the plane of a
/// single one.
void offer(const Given<Object> &given, Surroundings &found) {
  const MeshObject mesh = as<MeshObject>(given).object;
  if (mesh.shape->faces().empty())
    return;
  const WordValues name{{"mesh", plainText(given.symbol)}};
  const std::vector<ExactVec3> corners = cornersOf(mesh);
  for (const ExactVec3 &corner : corners)
    found.points.push_back({corner, words("corner of {mesh}", name)});
  std::set<std::pair<std::uint32_t, std::uint32_t>> offered; // two faces have most of them
  for (const MeshFace &face : mesh.shape->faces())
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto [from, to] = std::minmax(face[i], face[(i + 1) % face.size()]);
      if (corners[from] != corners[to] && offered.emplace(from, to).second)
        found.edges.push_back({corners[from], corners[to], words("edge of {mesh}", name)});
    }
  if (mesh.shape->faces().size() == 1) {
    std::vector<ExactVec3> around;
    for (const std::uint32_t corner : mesh.shape->faces().front())
      around.push_back(corners[corner]);
    found.planes.push_back({around.front(), areaOf(around), plainText(given.symbol)});
  }
}

void settle(Object &object) { object[2].x = std::max(object[2].x, smallestScale); }

/// A house to begin with: four walls and a gabled roof over a square of 4 × 4.
std::shared_ptr<const MeshShape> house() {
  static const auto shape = std::make_shared<const MeshShape>(
      std::vector<Vec3<double>>{{0, 0, 0},
                                {4, 0, 0},
                                {4, 4, 0},
                                {0, 4, 0},
                                {0, 0, 3},
                                {4, 0, 3},
                                {4, 4, 3},
                                {0, 4, 3},
                                {2, 0, 5},
                                {2, 4, 5}},
      std::vector<MeshFace>{
          {0, 1, 5, 8, 4}, {2, 3, 7, 9, 6}, {1, 2, 6, 5}, {3, 0, 4, 7}, {5, 6, 9, 8}, {7, 4, 8, 9}});
  return shape;
}

} // namespace

MeshPlacement::MeshPlacement(const MeshObject &mesh)
    : m_place(mesh.place), m_scale(std::max(mesh.scale, smallestScale)) {
  const Turn turn = turnOf(mesh.heading);
  m_cosine = turn.cosine;
  m_sine = turn.sine;
}

ExactVec3 MeshPlacement::turned(const ExactVec3 &vector, const Rational &sine) const {
  return {m_cosine * vector.x - sine * vector.y, sine * vector.x + m_cosine * vector.y, vector.z};
}

ExactVec3 MeshPlacement::toScene(const ExactVec3 &corner) const {
  return m_place + turned(corner, m_sine) * m_scale;
}

Ray<Rational> MeshPlacement::toMesh(const Ray<Rational> &ray) const {
  return {turned(ray.origin - m_place, -m_sine) / m_scale, turned(ray.direction, -m_sine) / m_scale};
}

glm::dmat3 MeshPlacement::axes() const {
  const auto axis = [&](const ExactVec3 &along) {
    return toDouble(ExactVec3(turned(along, m_sine) * m_scale));
  };
  return {axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1})};
}

std::string markOf(const Given<MeshObject> &mesh, std::size_t triangle) {
  const MeshShape &shape = *mesh.object.shape;
  if (shape.faces().empty())
    return mesh.id;
  std::size_t face = 0;
  for (std::size_t first = 0; triangle >= first + shape.faces()[face].size() - 2; ++face)
    first += shape.faces()[face].size() - 2;
  return faceId(mesh.id, face);
}

Triangle<Rational> MeshPlacement::toScene(const Triangle<double> &own) const {
  return {toScene(exactly(own.p0)), toScene(exactly(own.p1)), toScene(exactly(own.p2))};
}

Triangle<Rational> triangleOf(const MeshObject &mesh, std::size_t index) {
  return MeshPlacement(mesh).toScene(mesh.shape->mesh()->triangle(index));
}

namespace object_kinds {

Kind mesh() {
  return {.word = MeshObject::kind,
          .noun = [] { return words("a mesh"); },
          .meaning =
              "a mesh of flat, convex faces by their corners, where it stands, which way it is turned and "
              "how it is scaled",
          .subject = {},
          .coordinates = {{"P", CoordinateRole::Position},
                          {"h", CoordinateRole::Direction},
                          {"k", CoordinateRole::Number}},
          .leavableVertices = 0,
          .shape = house(),
          .binding = {},
          .settle = settle,
          .draw = draw,
          .ownHandles = noHandles,
          .offer = offer,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
