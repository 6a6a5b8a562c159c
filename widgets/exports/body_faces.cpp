#include "widgets/exports/body_faces.h"

#include "geometry/triangle_mesh.h"
#include "widgets/picture/shapes/light.h"
#include "widgets/picture/shapes/translucent_faces.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace halfspace {
namespace {

std::uint8_t shaded(std::uint8_t channel, double light) {
  return static_cast<std::uint8_t>(std::lround(std::min(255.0, channel * light)));
}

/// A triangle in the light, as the picture in space has it; seen from both sides.
Color shaded(Color color, const std::array<Place, 3> &corners, const Camera &camera) {
  const Place square = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  if (square == Place(0))
    return color;
  Place normal = glm::normalize(square);
  if (glm::dot(normal, corners[0] - camera.eye()) > 0)
    normal = -normal;
  double light = ambientPart;
  for (const CameraLight &lamp : cameraLights) {
    const Place way =
        camera.right() * lamp.from.x + camera.up() * lamp.from.y - camera.viewDirection() * lamp.from.z;
    light += diffusePart * lamp.strength * std::max(0.0, glm::dot(normal, glm::normalize(way)));
  }
  return {shaded(color.red, light), shaded(color.green, light), shaded(color.blue, light)};
}

std::vector<Shape> trianglesOf(const ShapeList &list) {
  std::size_t count = 0;
  forEach<BodyShape>(*list.layer(Layer::Bodies), [&](const Shape &, const BodyShape &body) {
    count += body.mesh->triangles.size() / body.stride;
  });
  const std::size_t step = count / mostDrawnTriangles + 1;
  std::vector<Shape> triangles;
  forEach<BodyShape>(*list.layer(Layer::Bodies), [&](const Shape &shape, const BodyShape &body) {
    const auto placed = [&](std::uint32_t corner) {
      const auto &at = body.mesh->corners[corner];
      return body.origin + body.axes * Place(at.x, at.y, at.z);
    };
    for (std::size_t i = 0; i < body.mesh->triangles.size(); i += body.stride * step) {
      const auto &[a, b, c] = body.mesh->triangles[i];
      const std::array corners{placed(a), placed(b), placed(c)};
      triangles.push_back({shape.mark, shaded(shape.color, corners, list.view.camera),
                           FaceShape{{corners.begin(), corners.end()}, 1}});
    }
  });
  return triangles;
}

/// Cut and ordered with all others.
std::vector<Shape> ordered(const std::vector<Shape> &shapes, const Paper &paper) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (const auto *face = std::get_if<FaceShape>(&shapes[i].form))
      faces.push_back({face->corners, shapes[i].color, face->opacity, i, face->globe});
  const FaceOrder order(std::move(faces));
  const glm::dvec4 eye =
      paper.isOrthographic() ? glm::dvec4(-paper.viewDirection(), 0) : glm::dvec4(paper.eye(), 1);
  std::vector<Shape> inOrder;
  for (const Face *face : order.backToFront(eye))
    inOrder.push_back(
        {shapes[face->mark].mark, face->color, FaceShape{face->corners, face->opacity, face->globe}});
  return inOrder;
}

double depthOf(const Shape &triangle, const Paper &paper) {
  double depth = 0;
  for (const Place &corner : std::get<FaceShape>(triangle.form).corners)
    depth += paper.depthOf(corner);
  return depth;
}

} // namespace

std::vector<Shape> facesWithBodies(const ShapeList &list, const Paper &paper) {
  const std::vector<Shape> &faces = *list.layer(Layer::Faces);
  std::vector<Shape> all = trianglesOf(list);
  if (all.empty())
    return faces;
  const bool canBeOrdered = all.size() + faces.size() <= mostOrderedFaces;
  if (!canBeOrdered)
    std::stable_sort(all.begin(), all.end(),
                     [&](const Shape &a, const Shape &b) { return depthOf(a, paper) > depthOf(b, paper); });
  all.insert(all.end(), faces.begin(), faces.end());
  return canBeOrdered ? ordered(all, paper) : all;
}

} // namespace halfspace
