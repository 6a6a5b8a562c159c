#include "widgets/picture/shapes/surface_layers.h"

#include "lessons/words.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace halfspace {
namespace {

/// Lines go through the middles of at most so many surfaces …
constexpr std::size_t mostSampled = 64;
/// … and of fewer where that would cost more questions: some tenths of a second, once for a mesh.
constexpr std::size_t mostQuestions = 1 << 24;

struct StraightLine {
  Place through{};
  Place along{};
};

using Corners = std::vector<Place>;

template <class Polygon> Place middleOf(const Polygon &corners) {
  Place sum(0);
  for (const Place &corner : corners)
    sum += corner;
  return sum / static_cast<double>(corners.size());
}

/// Twice the area of a planar polygon times its unit normal.
template <class Polygon> Place areaVectorOf(const Polygon &corners) {
  Place area(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    area += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return area;
}

/// Looked at along its plane a surface takes no pixels: the sine of the angle up to which that counts.
constexpr double flattest = 0.02;

template <class Polygon> bool liesAlong(const StraightLine &line, const Polygon &corners) {
  const Place area = areaVectorOf(corners);
  return std::abs(glm::dot(line.along, area)) <= flattest * glm::length(line.along) * glm::length(area);
}

/// Whether a line passes all sides of a convex polygon in one sense, and not along its plane.
template <class Polygon> bool crosses(const StraightLine &line, const Polygon &corners) {
  bool left = false;
  bool right = false;
  Place from = corners.back() - line.through;
  for (const Place &corner : corners) {
    const Place to = corner - line.through;
    const double side = glm::dot(line.along, glm::cross(from, to));
    left = left || side > 0;
    right = right || side < 0;
    from = to;
  }
  return left != right && !liesAlong(line, corners);
}

/// So many of `count` surfaces as may be asked, each the more likely the larger it is: large ones take the
/// pixels.
template <class CornersOf> std::vector<std::size_t> sample(std::size_t count, const CornersOf &cornersOf) {
  const auto areaOf = [&](std::size_t i) { return glm::length(areaVectorOf(cornersOf(i))); };
  double whole = 0;
  for (std::size_t i = 0; i < count; ++i)
    whole += areaOf(i);
  const std::size_t size = std::clamp<std::size_t>(mostQuestions / count, 1, mostSampled);
  std::vector<std::size_t> sampled;
  double passed = 0;
  for (std::size_t i = 0; i < count && sampled.size() < size; ++i) {
    passed += areaOf(i);
    if (passed * static_cast<double>(size) > whole * (static_cast<double>(sampled.size()) + 0.5))
      sampled.push_back(i);
  }
  return sampled;
}

/// Through the middle of each sampled surface: straight across it, and towards the middle of the next one,
/// as the surfaces of a row need not face each other.
template <class CornersOf>
std::vector<StraightLine> linesThrough(const std::vector<std::size_t> &sampled, const CornersOf &cornersOf) {
  std::vector<StraightLine> lines;
  for (std::size_t i = 0; i < sampled.size(); ++i) {
    const auto &corners = cornersOf(sampled[i]);
    const Place middle = middleOf(corners);
    lines.push_back({middle, areaVectorOf(corners)});
    lines.push_back({middle, middleOf(cornersOf(sampled[(i + 1) % sampled.size()])) - middle});
  }
  return lines;
}

template <class CornersOf> std::size_t layersOf(std::size_t count, const CornersOf &cornersOf) {
  std::size_t most = 0;
  for (const StraightLine &line : linesThrough(sample(count, cornersOf), cornersOf)) {
    std::size_t crossed = 0;
    for (std::size_t i = 0; i < count; ++i)
      if (crosses(line, cornersOf(i)))
        ++crossed;
    most = std::max(most, crossed);
  }
  return most;
}

/// The eight faces of the octahedron in a ball: a line through it crosses two, as with the ball itself.
std::vector<Corners> octahedronIn(const SphereMark &ball) {
  std::vector<Corners> faces;
  for (const double x : {-ball.radius, ball.radius})
    for (const double y : {-ball.radius, ball.radius})
      for (const double z : {-ball.radius, ball.radius})
        faces.push_back(
            {ball.center + Place(x, 0, 0), ball.center + Place(0, y, 0), ball.center + Place(0, 0, z)});
  return faces;
}

/// The translucent faces of a mark.
std::vector<Corners> facesOf(const Mark &mark) {
  if (const auto *patch = std::get_if<PlanePatchMark>(&mark))
    return {cornersOf(*patch)};
  if (const auto *polygon = std::get_if<PolygonMark>(&mark))
    return {polygon->corners};
  if (const auto *ball = std::get_if<SphereMark>(&mark))
    return octahedronIn(*ball);
  return {};
}

struct Face {
  std::size_t mark = 0; ///< the index of its mark
  Corners corners;
};

std::vector<Face> facesOf(const Figure &figure) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < figure.marks.size(); ++i)
    for (Corners &corners : facesOf(figure.marks[i]))
      if (corners.size() >= 3)
        faces.push_back({i, std::move(corners)});
  return faces;
}

auto cornersIn(const std::vector<Face> &faces) {
  return [&faces](std::size_t i) -> const Corners & { return faces[i].corners; };
}

std::size_t layersOf(const std::vector<Face> &faces) {
  return faces.size() <= mostFaceLayers ? faces.size() : layersOf(faces.size(), cornersIn(faces));
}

/// The marks of all faces that a line crosses.
std::vector<std::size_t> stackOn(const StraightLine &line, const std::vector<Face> &faces,
                                 const std::set<std::size_t> &leftOut) {
  std::vector<std::size_t> stack;
  for (const Face &face : faces)
    if (!leftOut.contains(face.mark) && crosses(line, face.corners))
      stack.push_back(face.mark);
  return stack;
}

void leaveOutEveryOther(std::vector<std::size_t> &stack, std::set<std::size_t> &leftOut) {
  bool goes = false;
  for (const std::size_t mark : std::set(stack.begin(), stack.end())) {
    if (goes)
      leftOut.insert(mark);
    goes = !goes;
  }
  std::erase_if(stack, [&](std::size_t mark) { return leftOut.contains(mark); });
}

/// The marks that go for no line to cross too many faces. What is left is asked again, as other lines go
/// through it.
std::set<std::size_t> marksLeftOut(std::vector<Face> faces) {
  std::set<std::size_t> leftOut;
  std::size_t before = 0;
  do {
    before = leftOut.size();
    for (const StraightLine &line : linesThrough(sample(faces.size(), cornersIn(faces)), cornersIn(faces)))
      for (auto stack = stackOn(line, faces, leftOut); stack.size() > mostFaceLayers;)
        leaveOutEveryOther(stack, leftOut);
    std::erase_if(faces, [&](const Face &face) { return leftOut.contains(face.mark); });
  } while (leftOut.size() > before);
  return leftOut;
}

} // namespace

std::size_t faceLayersOf(const Figure &figure) { return layersOf(facesOf(figure)); }

std::size_t meshLayersOf(const TriangleMesh &mesh) {
  if (mesh.triangles.size() <= mostMeshLayers)
    return mesh.triangles.size();
  return layersOf(mesh.triangles.size(), [&](std::size_t i) {
    const auto &[a, b, c] = mesh.triangles[i];
    return std::array<Place, 3>{mesh.corners[a], mesh.corners[b], mesh.corners[c]};
  });
}

std::size_t strideFor(std::size_t meshLayers) {
  return std::bit_ceil((meshLayers + mostMeshLayers - 1) / mostMeshLayers);
}

std::optional<Figure> thinned(const Figure &figure, const std::set<std::string> &highlighted) {
  std::vector<Face> faces = facesOf(figure);
  if (layersOf(faces) <= mostFaceLayers)
    return std::nullopt;
  const std::set<std::size_t> leftOut = marksLeftOut(std::move(faces));
  Figure left;
  for (std::size_t i = 0; i < figure.marks.size(); ++i)
    if (!leftOut.contains(i) || highlighted.contains(baseOf(figure.marks[i]).id))
      left.marks.push_back(figure.marks[i]);
  return left;
}

std::string overfullWords() {
  return words("So many surfaces lie one behind another that only some of them are drawn.");
}

} // namespace halfspace
