#include "widgets/picture/shapes/translucent_faces.h"

#include "widgets/picture/shapes/mark_outline.h"
#include "widgets/picture/shapes/mark_shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace halfspace {
namespace {

/// Corners nearer than this to a plane, in scene units, count as on it: far above rounding, far below a
/// pixel.
constexpr double onPlaneTolerance = 1e-7;

constexpr double ghostOpacity = 0.35;
constexpr double highlightOpacity = 0.18;

// The pieces of a ball's surface: flat, and few, as they are ordered anew in every frame.
constexpr int ballMeridians = 20;
constexpr int ballParallels = 10;

/// Faces that all pass through one another would be cut into more pieces than anyone can draw. After so many
/// cuts each face stays whole, on the side where its middle lies.
constexpr int mostCuts = 4096;

/// Twice the area of a planar polygon times its unit normal.
Place areaVector(const std::vector<Place> &corners) {
  Place area(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    area += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return area;
}

struct Halves {
  Face front;
  Face back;
};

/// Cuts a face along a plane; `sides` are its corners' distances from it.
Halves cut(const Face &face, const std::vector<double> &sides) {
  const Face empty{{}, face.color, face.opacity, face.mark, face.globe};
  Halves halves{empty, empty};
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const std::size_t next = (i + 1) % face.corners.size();
    if (sides[i] >= -onPlaneTolerance)
      halves.front.corners.push_back(face.corners[i]);
    if (sides[i] <= onPlaneTolerance)
      halves.back.corners.push_back(face.corners[i]);
    const bool leavesFront = sides[i] > onPlaneTolerance && sides[next] < -onPlaneTolerance;
    const bool leavesBack = sides[i] < -onPlaneTolerance && sides[next] > onPlaneTolerance;
    if (leavesFront || leavesBack) {
      const Place crossing =
          glm::mix(face.corners[i], face.corners[next], sides[i] / (sides[i] - sides[next]));
      halves.front.corners.push_back(crossing);
      halves.back.corners.push_back(crossing);
    }
  }
  return halves;
}

Face faceOf(const Mark &mark, const Theme &theme, bool highlighted) {
  const MarkBase &base = baseOf(mark);
  const bool isPatch = std::holds_alternative<PlanePatchMark>(mark);
  Face face;
  face.corners = outlineOf(mark, rightAngleSize).path;
  face.color = base.role == Role::Warning                  ? theme.warning
               : isPatch && base.subject == Subject::Plane ? theme.patchFaceOf(hueOf(base))
                                                           : theme.colorOf(hueOf(base));
  face.opacity =
      (isPatch ? theme.planeOpacity : theme.polygonOpacity) * (base.role == Role::Ghost ? ghostOpacity : 1) +
      (highlighted ? highlightOpacity : 0);
  return face;
}

/// The surface of a ball, seen twice by whoever looks through it: each side is half as dense as a polygon.
void addSurface(const SphereMark &sphere, const Face &like, std::vector<Face> &faces) {
  const auto at = [&](int meridian, int parallel) {
    const double around = 2 * std::numbers::pi * meridian / ballMeridians;
    const double up = std::numbers::pi * parallel / ballParallels - std::numbers::pi / 2;
    return sphere.center +
           Place(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up)) *
               sphere.radius;
  };
  for (int parallel = 0; parallel < ballParallels; ++parallel)
    for (int meridian = 0; meridian < ballMeridians; ++meridian) {
      std::vector<Place> corners{at(meridian, parallel), at(meridian + 1, parallel)};
      if (parallel == 0)
        corners.pop_back();
      corners.push_back(at(meridian + 1, parallel + 1));
      if (parallel + 1 < ballParallels)
        corners.push_back(at(meridian, parallel + 1));
      faces.push_back(
          {std::move(corners), like.color, like.opacity / 2, like.mark, Globe{sphere.center, sphere.radius}});
    }
}

} // namespace

std::vector<Face> facesOf(const Figure &figure, const std::set<std::string> &highlighted, const Theme &theme,
                          const Arrival &arrival) {
  std::vector<Face> patches;
  std::vector<Face> polygons;
  for (std::size_t i = 0; i < figure.marks.size(); ++i) {
    const Mark &mark = figure.marks[i];
    const bool isPatch = std::holds_alternative<PlanePatchMark>(mark);
    const auto *sphere = std::get_if<SphereMark>(&mark);
    if (!isPatch && !sphere && !std::holds_alternative<PolygonMark>(mark))
      continue;
    Face face = faceOf(mark, theme, highlighted.contains(baseOf(mark).id));
    face.opacity *= arrival.presenceOf(baseOf(mark));
    face.mark = i;
    if (sphere)
      addSurface(*sphere, face, polygons);
    else
      (isPatch ? patches : polygons).push_back(std::move(face));
  }
  patches.insert(patches.end(), polygons.begin(), polygons.end());
  return patches;
}

struct FaceOrder::Node {
  Place normal{};
  double offset = 0;
  std::vector<Face> inPlane;
  std::unique_ptr<Node> front;
  std::unique_ptr<Node> back;

  [[nodiscard]] double side(Place place) const { return glm::dot(normal, place) + offset; }

  /// Splits by the plane of the first face. The faces are moved from node to node: a ball's pass through
  /// many.
  static std::unique_ptr<Node> of(std::vector<Face> faces, int &cutsLeft) {
    if (faces.empty())
      return nullptr;
    auto node = std::make_unique<Node>();
    node->normal = glm::normalize(areaVector(faces.front().corners));
    node->offset = -glm::dot(node->normal, faces.front().corners.front());
    node->inPlane.push_back(std::move(faces.front()));
    std::vector<Face> inFront;
    std::vector<Face> behind;
    std::vector<double> sides;
    for (std::size_t i = 1; i < faces.size(); ++i) {
      sides.clear();
      for (const Place &corner : faces[i].corners)
        sides.push_back(node->side(corner));
      node->sort(std::move(faces[i]), sides, inFront, behind, cutsLeft);
    }
    node->front = of(std::move(inFront), cutsLeft);
    node->back = of(std::move(behind), cutsLeft);
    return node;
  }

  /// `sides` are the corners' distances from the node's plane.
  void sort(Face face, const std::vector<double> &sides, std::vector<Face> &inFront,
            std::vector<Face> &behind, int &cutsLeft) {
    const auto [lowest, highest] = std::minmax_element(sides.begin(), sides.end());
    const bool reachesFront = *highest > onPlaneTolerance;
    const bool reachesBack = *lowest < -onPlaneTolerance;
    if (!reachesFront || !reachesBack) {
      (reachesFront ? inFront : reachesBack ? behind : inPlane).push_back(std::move(face));
    } else if (cutsLeft > 0) {
      --cutsLeft;
      Halves halves = cut(face, sides);
      keep(std::move(halves.front), inFront);
      keep(std::move(halves.back), behind);
    } else {
      (std::accumulate(sides.begin(), sides.end(), 0.0) > 0 ? inFront : behind).push_back(std::move(face));
    }
  }

  /// A face without area has no plane of its own and is not seen.
  static void keep(Face face, std::vector<Face> &faces) {
    if (face.corners.size() > 2 &&
        glm::length(areaVector(face.corners)) > onPlaneTolerance * onPlaneTolerance)
      faces.push_back(std::move(face));
  }

  static void walk(const Node *node, glm::dvec4 eye, std::vector<const Face *> &order) {
    if (!node)
      return;
    const bool eyeInFront = glm::dot(node->normal, Place(eye)) + node->offset * eye.w > 0;
    walk(eyeInFront ? node->back.get() : node->front.get(), eye, order);
    for (const Face &face : node->inPlane)
      order.push_back(&face);
    walk(eyeInFront ? node->front.get() : node->back.get(), eye, order);
  }
};

FaceOrder::FaceOrder() = default;
FaceOrder::~FaceOrder() = default;
FaceOrder::FaceOrder(FaceOrder &&) noexcept = default;
FaceOrder &FaceOrder::operator=(FaceOrder &&) noexcept = default;

FaceOrder::FaceOrder(std::vector<Face> faces) {
  std::vector<Face> visible;
  for (Face &face : faces)
    Node::keep(std::move(face), visible);
  int cutsLeft = mostCuts;
  m_root = Node::of(std::move(visible), cutsLeft);
}

std::vector<const Face *> FaceOrder::backToFront(glm::dvec4 eye) const {
  std::vector<const Face *> order;
  Node::walk(m_root.get(), eye, order);
  return order;
}

} // namespace halfspace
