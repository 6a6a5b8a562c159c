#include "widgets/picture/hand/grips.h"

#include "widgets/picture/design_scale.h"
#include "widgets/picture/hand/handle_drag.h"
#include "widgets/picture/shapes/ball_sizes.h"
#include "widgets/picture/shapes/gizmo_shape.h"
#include "widgets/picture/shapes/mark_shapes.h"
#include "widgets/picture/shapes/mesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace halfspace {
namespace {

/// What is not drawn is grabbed within so many design pixels.
constexpr double unseenRadius = 6;

/// The very tip of an arrow is seen as thick as this, in design pixels: it is what people aim at.
constexpr double tipPixels = 1;

/// Makes the grips of one picture.
class GripMaker {
public:
  GripMaker(const Figure &figure, const Theme &theme, const View &view)
      : m_theme(theme), m_view(view), m_scale(designScale(view.camera, view.size, view.pixelRatio)),
        m_balls(figure) {
    for (const Mark &mark : figure.marks)
      m_marks.emplace(baseOf(mark).id, &mark);
  }

  [[nodiscard]] Grip gripOf(const Handle &handle, bool isSelected) const {
    Grip grip{handle.id, handle.object, handle.motion == Handle::Motion::Whole, isSelected};
    if (const auto knob = knobOf(handle, isSelected))
      addKnob(grip, *knob);
    else if (const auto mark = m_marks.find(handle.id); mark != m_marks.end())
      addMark(grip, *mark->second);
    if (grip.pieces.empty())
      addUnseen(grip, shownPlace(handle));
    if (isSelected && movesFreely(handle))
      addRing(grip, shownPlace(handle));
    return grip;
  }

private:
  [[nodiscard]] std::optional<glm::dvec2> pixelOf(Place at) const {
    const auto pixel = m_view.camera.project(at, m_view.size);
    return pixel ? std::optional(glm::dvec2(*pixel)) : std::nullopt;
  }

  [[nodiscard]] double depthOf(Place at) const {
    return glm::dot(at - m_view.camera.eye(), m_view.camera.viewDirection());
  }

  /// Radii in units of the stage.
  void addPiece(Grip &grip, Place from, Place to, double fromRadius, double toRadius) const {
    const auto start = pixelOf(from);
    const auto end = pixelOf(to);
    const double unitsPerPixel = m_view.camera.unitsPerPixel(to, m_view.size);
    if (start && end && unitsPerPixel > 0)
      grip.pieces.push_back({{*start, *end, fromRadius / unitsPerPixel, toRadius / unitsPerPixel},
                             depthOf(from),
                             depthOf(to),
                             unitsPerPixel});
  }

  void addKnob(Grip &grip, const Knob &knob) const {
    const double unit = m_view.unitsPerDesignPixel(knob.at) * (knob.hot ? hotWidth : 1);
    addPiece(grip, knob.at, knob.at, knobBall * unit, knobBall * unit);
    const double head = headOfArrow(knobReach * unit, knobRadius * unit).radius;
    for (const Place &direction : knobDirections(knob, m_view.camera)) {
      const Place way = direction * (knobReach * unit);
      addPiece(grip, knob.at - way, knob.at + way, head, head);
    }
  }

  void addMark(Grip &grip, const Mark &mark) const {
    const double thickness = thicknessOf(baseOf(mark), m_theme, m_scale);
    if (const auto *point = std::get_if<PointMark>(&mark)) {
      const double radius = m_balls.radiusOf(*point, thickness);
      addPiece(grip, point->at, point->at, radius, radius);
    } else if (const auto *arrow = std::get_if<ArrowMark>(&mark)) {
      const Place way = shownVector(*arrow);
      const double length = glm::length(way);
      const ArrowHead head = headOfArrow(length, arrowRadius * thickness);
      const Place tip = arrow->from + way;
      const double tipRadius = std::min(head.radius, tipPixels * m_view.unitsPerDesignPixel(tip));
      addPiece(grip, tip, tip - way * (head.length / length), tipRadius, head.radius);
    }
  }

  void addUnseen(Grip &grip, Place at) const {
    if (const auto pixel = pixelOf(at)) {
      const double radius = unseenRadius * m_view.pixelRatio;
      const double nearest = -std::numeric_limits<double>::infinity();
      grip.pieces.push_back({{*pixel, *pixel, radius, radius}, nearest, nearest, 0});
    }
  }

  void addRing(Grip &grip, Place at) const {
    const double radius = modeRingRadius * m_view.pixelRatio;
    if (const auto pixel = pixelOf(at))
      grip.ring = Stroke{*pixel, *pixel, radius, radius};
  }

  const Theme &m_theme;
  const View &m_view;
  double m_scale;
  BallSizes m_balls;
  std::unordered_map<std::string_view, const Mark *> m_marks; ///< by their ids
};

/// How far from the eye the surface of a piece is at a pixel within its stroke.
double surfaceDepth(const GripPiece &piece, glm::dvec2 pixel) {
  const Stroke &stroke = piece.stroke;
  const double part = partNearest(stroke, pixel);
  const double radius = std::lerp(stroke.fromRadius, stroke.toRadius, part);
  const double aside = radius + distanceTo(stroke, pixel);
  const double bulge = std::sqrt(std::max(0.0, radius * radius - aside * aside));
  return (part < 1 ? std::lerp(piece.fromDepth, piece.toDepth, part) : piece.toDepth) -
         bulge * piece.unitsPerPixel;
}

/// What a grip has to say for itself at a pixel.
struct Claim {
  bool isBeside = true; ///< beside what is seen, not on it
  double measure = 0;   ///< the distance on the screen beside it, the depth on it
  const Grip *grip = nullptr;

  /// Of two that are as good the selected one wins, which was perhaps just brought there, else the later one:
  /// a bound point lies on a handle of its host.
  [[nodiscard]] bool winsOver(const std::optional<Claim> &earlier) const {
    if (!earlier || isBeside != earlier->isBeside)
      return !earlier || !isBeside;
    const Grip &other = *earlier->grip;
    if (!isBeside && grip->object == other.object && grip->isWhole != other.isWhole)
      return !grip->isWhole;
    return measure < earlier->measure || (measure == earlier->measure && !other.isSelected);
  }
};

std::optional<Claim> claimOf(const Grip &grip, glm::dvec2 pixel, double margin) {
  std::optional<Claim> best;
  const bool isInRing = grip.ring && distanceTo(*grip.ring, pixel) <= 0;
  for (const GripPiece &piece : grip.pieces) {
    const double distance = distanceTo(piece.stroke, pixel);
    if (distance > margin && !isInRing)
      continue;
    const Claim claim =
        distance <= 0 ? Claim{false, surfaceDepth(piece, pixel), &grip} : Claim{true, distance, &grip};
    if (claim.winsOver(best))
      best = claim;
  }
  return best;
}

} // namespace

std::vector<Grip> gripsOf(const std::vector<Handle> &handles, const std::string &selected,
                          const Figure &figure, const Theme &theme, const View &view) {
  const GripMaker maker(figure, theme, view);
  std::vector<Grip> grips;
  for (const Handle &handle : handles)
    if (grabMode(handle, false, view.camera))
      grips.push_back(maker.gripOf(handle, handle.id == selected));
  return grips;
}

std::string handleGrabbedAt(glm::dvec2 pixel, const std::vector<Grip> &grips, double margin) {
  std::string grabbed;
  std::optional<Claim> best;
  for (const Grip &grip : grips)
    if (const auto claim = claimOf(grip, pixel, margin); claim && claim->winsOver(best)) {
      best = claim;
      grabbed = grip.handle;
    }
  return grabbed;
}

std::vector<Stroke> strokesOf(const std::vector<Grip> &grips) {
  std::vector<Stroke> strokes;
  for (const Grip &grip : grips)
    for (const GripPiece &piece : grip.pieces)
      strokes.push_back(piece.stroke);
  return strokes;
}

} // namespace halfspace
