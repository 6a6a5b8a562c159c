// Paths on a page: straight and curved pieces.
#pragma once

#include <glm/vec2.hpp>

#include <vector>

namespace halfspace {

/// Where a path goes on to, and how.
struct PageStep {
  enum class Kind { Move, Line, Curve, Close };

  Kind kind = Kind::Move;
  glm::dvec2 to{};     ///< but for Close, which goes back to the last Move
  glm::dvec2 first{};  ///< the control points of a cubic curve
  glm::dvec2 second{}; ///< likewise
};

struct PagePath {
  std::vector<PageStep> steps{};

  void moveTo(glm::dvec2 to) { steps.push_back({PageStep::Kind::Move, to}); }
  void lineTo(glm::dvec2 to) { steps.push_back({PageStep::Kind::Line, to}); }
  void curveTo(glm::dvec2 first, glm::dvec2 second, glm::dvec2 to) {
    steps.push_back({PageStep::Kind::Curve, to, first, second});
  }
  void close() { steps.push_back({PageStep::Kind::Close}); }
  void append(const PagePath &other) { steps.insert(steps.end(), other.steps.begin(), other.steps.end()); }
};

/// Through all spots in their order, straight from one to the next.
[[nodiscard]] PagePath straightPath(const std::vector<glm::dvec2> &spots, bool isClosed);

/// Through all spots: where the line turns by no more than a curve that was cut into pieces does, as a curve;
/// corners stay corners.
[[nodiscard]] PagePath smoothPath(const std::vector<glm::dvec2> &spots, bool isClosed);

/// A circle.
[[nodiscard]] PagePath circlePath(glm::dvec2 center, double radius);

} // namespace halfspace
