#include "widgets/picture/shapes/mesh.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace halfspace {
namespace {

constexpr std::size_t tubeSides = 12;
constexpr std::size_t coneSides = 24;
constexpr std::size_t ballMeridians = 32;
constexpr std::size_t ballParallels = 18;
constexpr std::size_t coarseMeridians = 12;
constexpr std::size_t coarseParallels = 8;

/// More rounds of a rhythm than this are not told apart any more.
constexpr double mostRounds = 120;

/// Sharper corners than this (the cosine of half the turn) are not mitred to a spike.
constexpr double leastMitreCosine = 0.35;

/// An arrow's head in radii of the shaft, and the largest part of the arrow that it takes.
constexpr double headLength = 9.5;
constexpr double headRadius = 3.0;
constexpr double longestHead = 0.45;
/// However short an arrow is, its head is wider than the shaft by this factor.
constexpr double leastHeadRadius = 1.6;
/// The shaft goes this part of the head into it, so that no gap shows.
constexpr double shaftInHead = 0.04;

/// A direction steeper than this (the sine of its slope) is no use to tell what lies square to it from z.
constexpr double steepest = 0.9;

/// Cosines and sines around the circle; the first direction is repeated at the end.
template <std::size_t sides> std::array<glm::dvec2, sides + 1> circle() {
  std::array<glm::dvec2, sides + 1> points;
  for (std::size_t i = 0; i <= sides; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i % sides) / sides;
    points[i] = {std::cos(angle), std::sin(angle)};
  }
  return points;
}

std::int32_t cornerCount(const Mesh &mesh) { return static_cast<std::int32_t>(mesh.positions.size()); }

void addCorner(Mesh &mesh, Place position, Place normal, Color color) {
  mesh.positions.emplace_back(position);
  mesh.normals.emplace_back(normal);
  mesh.colors.push_back(color);
}

void addTriangle(Mesh &mesh, std::int32_t a, std::int32_t b, std::int32_t c) {
  mesh.triangles.emplace_back(a, b, c);
}

/// Joins two rings of so many corners each that start at these indices.
void joinRings(Mesh &mesh, std::int32_t first, std::int32_t second, std::size_t corners) {
  for (std::int32_t i = 0; i + 1 < static_cast<std::int32_t>(corners); ++i) {
    addTriangle(mesh, first + i, first + i + 1, second + i);
    addTriangle(mesh, first + i + 1, second + i + 1, second + i);
  }
}

/// Two unit directions square to a unit one and to each other.
struct Frame {
  Place a;
  Place b;

  explicit Frame(Place along) {
    const Place other = std::abs(along.z) < steepest ? Place(0, 0, 1) : Place(1, 0, 0);
    a = glm::normalize(glm::cross(other, along));
    b = glm::cross(along, a);
  }
};

template <std::size_t corners>
void addDisc(Mesh &mesh, Place center, const Frame &frame, const std::array<glm::dvec2, corners> &directions,
             double radius, Place normal, Color color) {
  const std::int32_t middle = cornerCount(mesh);
  addCorner(mesh, center, normal, color);
  for (const glm::dvec2 &d : directions)
    addCorner(mesh, center + (frame.a * d.x + frame.b * d.y) * radius, normal, color);
  for (std::int32_t i = 1; i < static_cast<std::int32_t>(corners); ++i)
    addTriangle(mesh, middle, middle + i, middle + i + 1);
}

std::vector<Place> withoutRepeats(std::span<const Place> path) {
  std::vector<Place> points;
  for (const Place &point : path)
    if (points.empty() || point != points.back())
      points.push_back(point);
  return points;
}

/// Sweeps a ring along the directions between points: the ring at each point is slanted so that both tubes
/// meet.
class TubeSweep {
public:
  TubeSweep(Mesh &mesh, double radius, Color color) : m_mesh(mesh), m_radius(radius), m_color(color) {}

  /// Puts a ring at a point that the path reaches in one unit direction and leaves in another.
  void ring(Place at, const Frame &frame, Place in, Place out) {
    const Place across = in + out;
    const double length = glm::length(across);
    const bool isMitred = length / 2 > leastMitreCosine;
    const Place plane = isMitred ? across / length : in;
    const double slant = glm::dot(in, plane);
    const std::int32_t first = cornerCount(m_mesh);
    for (const glm::dvec2 &d : directions()) {
      const Place outward = frame.a * d.x + frame.b * d.y;
      addCorner(m_mesh, at + (outward - in * (glm::dot(outward, plane) / slant)) * m_radius, outward,
                m_color);
    }
    if (m_previous >= 0)
      joinRings(m_mesh, m_previous, first, directions().size());
    m_previous = first;
  }

  void cap(Place at, const Frame &frame, Place normal) {
    addDisc(m_mesh, at, frame, directions(), m_radius, normal, m_color);
  }

private:
  static const std::array<glm::dvec2, tubeSides + 1> &directions() {
    static const auto table = circle<tubeSides>();
    return table;
  }

  Mesh &m_mesh;
  double m_radius;
  Color m_color;
  std::int32_t m_previous = -1;
};

/// The same frame carried round a corner, so that the tube is not twisted.
Frame turned(Frame frame, Place in, Place out) {
  const Place across = in + out;
  if (glm::length(across) / 2 <= leastMitreCosine)
    return Frame(out);
  const auto turn = [&](Place v) {
    const Place mitred = v - in * (glm::dot(v, across) / glm::dot(in, across));
    return glm::normalize(mitred - out * glm::dot(mitred, out));
  };
  frame.a = turn(frame.a);
  frame.b = glm::cross(out, frame.a);
  return frame;
}

} // namespace

void clear(Mesh &mesh) {
  mesh.positions.clear();
  mesh.normals.clear();
  mesh.colors.clear();
  mesh.triangles.clear();
}

void addTube(Mesh &mesh, std::span<const Place> path, double radius, Color color) {
  const std::vector<Place> points = withoutRepeats(path);
  if (points.size() < 2)
    return;
  TubeSweep sweep(mesh, radius, color);
  Place in = glm::normalize(points[1] - points[0]);
  Frame frame(in);
  sweep.cap(points.front(), frame, -in);
  sweep.ring(points.front(), frame, in, in);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Place out = glm::normalize(points[i + 1] - points[i]);
    sweep.ring(points[i], frame, in, out);
    frame = turned(frame, in, out);
    in = out;
  }
  sweep.ring(points.back(), frame, in, in);
  sweep.cap(points.back(), frame, in);
}

void addTube(Mesh &mesh, Place from, Place to, double radius, Color color) {
  addTube(mesh, std::array{from, to}, radius, color);
}

void addRing(Mesh &mesh, std::span<const Place> corners, double radius, Color color) {
  std::vector<Place> points = withoutRepeats(corners);
  if (points.size() > 1 && points.front() == points.back())
    points.pop_back();
  if (points.size() < 3)
    return addTube(mesh, points, radius, color);
  const auto at = [&](std::size_t i) { return points[i % points.size()]; };
  TubeSweep sweep(mesh, radius, color);
  Place in = glm::normalize(at(0) - points.back());
  Frame frame(in);
  for (std::size_t i = 0; i <= points.size(); ++i) {
    const Place out = glm::normalize(at(i + 1) - at(i));
    sweep.ring(at(i), frame, in, out);
    frame = turned(frame, in, out);
    in = out;
  }
}

void addDashes(Mesh &mesh, Place from, Place to, double radius, const Rhythm &rhythm, Color color) {
  const double length = glm::distance(from, to);
  if (!(length > 0))
    return;
  // So many rounds without the last one's gap fill the length.
  const double period = std::accumulate(rhythm.begin(), rhythm.end(), 0.0);
  const double rounds = std::clamp(std::round((length + rhythm.back()) / period), 1.0, mostRounds);
  const Place step = (to - from) / (rounds * period - rhythm.back());
  for (double i = 0; i < rounds; ++i) {
    Place start = from + step * (i * period);
    for (std::size_t k = 0; k + 1 < rhythm.size(); k += 2) {
      addTube(mesh, start, start + step * rhythm[k], radius, color);
      start += step * (rhythm[k] + rhythm[k + 1]);
    }
  }
}

void addCone(Mesh &mesh, Place base, Place tip, double radius, Color color) {
  static const auto directions = circle<coneSides>();
  const double height = glm::distance(base, tip);
  if (!(height > 0))
    return;
  const Place along = (tip - base) / height;
  const Frame frame(along);
  const std::int32_t first = cornerCount(mesh);
  const auto corners = static_cast<std::int32_t>(directions.size());
  for (const bool atTip : {false, true})
    for (const glm::dvec2 &d : directions) {
      const Place outward = frame.a * d.x + frame.b * d.y;
      addCorner(mesh, atTip ? tip : base + outward * radius,
                glm::normalize(outward * height + along * radius), color);
    }
  for (std::int32_t i = 0; i + 1 < corners; ++i)
    addTriangle(mesh, first + i, first + i + 1, first + corners + i);
  addDisc(mesh, base, frame, directions, radius, -along, color);
}

namespace {

template <std::size_t meridians, std::size_t parallels>
void addGlobe(Mesh &mesh, Place center, double radius, Color color) {
  static const auto directions = circle<meridians>();
  std::int32_t previous = -1;
  for (std::size_t row = 0; row <= parallels; ++row) {
    const double latitude = std::numbers::pi * (static_cast<double>(row) / parallels - 0.5);
    const std::int32_t first = cornerCount(mesh);
    for (const glm::dvec2 &d : directions) {
      const Place normal(d * std::cos(latitude), std::sin(latitude));
      addCorner(mesh, center + normal * radius, normal, color);
    }
    if (previous >= 0)
      joinRings(mesh, previous, first, directions.size());
    previous = first;
  }
}

} // namespace

void addBall(Mesh &mesh, Place center, double radius, Color color, BallDetail detail) {
  if (detail == BallDetail::Fine)
    addGlobe<ballMeridians, ballParallels>(mesh, center, radius, color);
  else
    addGlobe<coarseMeridians, coarseParallels>(mesh, center, radius, color);
}

void addFlat(Mesh &mesh, std::span<const Place> corners, Color color) {
  if (corners.size() < 3)
    return;
  const Place normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  if (normal == Place(0))
    return;
  const std::int32_t first = cornerCount(mesh);
  for (const Place &corner : corners)
    addCorner(mesh, corner, glm::normalize(normal), color);
  for (std::int32_t i = 1; i + 1 < static_cast<std::int32_t>(corners.size()); ++i)
    addTriangle(mesh, first, first + i, first + i + 1);
}

ArrowHead headOfArrow(double length, double radius) {
  const double head = std::min(longestHead * length, headLength * radius);
  return {head, std::max(headRadius * head / headLength, leastHeadRadius * radius)};
}

void addArrow(Mesh &mesh, Place from, Place vector, double radius, Color color, const Rhythm &rhythm) {
  const double length = glm::length(vector);
  if (!(length > 0))
    return;
  const Place along = vector / length;
  const ArrowHead head = headOfArrow(length, radius);
  const Place neck = from + along * (length - head.length);
  const Place shaftEnd = neck + along * (shaftInHead * head.length);
  if (rhythm.empty())
    addTube(mesh, from, shaftEnd, radius, color);
  else
    addDashes(mesh, from, shaftEnd, radius, rhythm, color);
  addCone(mesh, neck, from + vector, head.radius, color);
}

std::vector<Place> circleAround(Place center, Place axis, double radius, int corners) {
  const Place aside = std::abs(axis.z) < std::abs(axis.x) ? Place(0, 0, 1) : Place(1, 0, 0);
  const Place first = glm::normalize(glm::cross(axis, aside));
  const Place second = glm::cross(axis, first);
  std::vector<Place> circle;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    circle.push_back(center + (first * std::cos(angle) + second * std::sin(angle)) * radius);
  }
  return circle;
}

} // namespace halfspace
