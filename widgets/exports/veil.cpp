#include "widgets/exports/veil.h"

#include "widgets/exports/page_polygon.h"
#include "widgets/picture/shapes/mesh.h"
#include "widgets/picture/shapes/silhouette.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace halfspace {
namespace {

/// Nearer to a plane than this, in units of the stage, is in it: far above rounding, far below what is seen.
constexpr double inPlane = 1e-6;
/// Nearer to the border of a polygon than this, in points, is on it.
constexpr double onBorder = 1e-6;
/// A polygon with less than this of the page, in square points, is seen edge-on.
constexpr double leastArea = 1e-3;
/// A circle on a ball that is cut into straight pieces dips into it: not farther along any sight than this
/// part of its radius.
constexpr double dipOfCircles = 0.06;
/// The corners of a silhouette, and how many times as many there are at most, of one that is larger than the
/// page.
constexpr int fewCorners = 48;
constexpr double mostTimesMore = 64;

/// Veils that lie one over the other by less than this, in points, only touch.
constexpr double hair = 0.01;

/// Whether a line along one of the edges of a polygon has all of another one on its outer side.
bool isParted(const std::vector<glm::dvec2> &corners, const std::vector<glm::dvec2> &others) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 edge = corners[(i + 1) % corners.size()] - corners[i];
    const double reach = hair * glm::length(edge);
    if (reach > 0 && std::all_of(others.begin(), others.end(),
                                 [&](glm::dvec2 other) { return crossOf(edge, other - corners[i]) < reach; }))
      return true;
  }
  return false;
}

Place normalOf(const std::vector<Place> &corners) {
  Place area(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    area += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return area;
}

/// The part of the way of a piece that is seen at a part of its way on the page.
double partInSpace(double onPage, const SightedPiece &piece, const Paper &paper) {
  if (paper.isOrthographic())
    return onPage;
  const double first = paper.depthOf(piece.from);
  const double last = paper.depthOf(piece.to);
  return onPage * first / (onPage * first + (1 - onPage) * last);
}

/// The roots of a·t² + 2·b·t + c.
void addRoots(double a, double b, double c, std::vector<double> &roots) {
  const double square = b * b - a * c;
  if (a == 0 || !(square >= 0))
    return;
  const double root = std::sqrt(square);
  roots.push_back((-b - root) / a);
  roots.push_back((-b + root) / a);
}

/// Around what is seen of a ball on the page, or not far beside it.
std::vector<glm::dvec2> silhouetteCorners(const Globe &ball, const Paper &paper) {
  const Silhouette circle = paper.silhouetteOf(ball);
  const double widths = 2 * ball.radius * paper.pointsPerUnitAt(circle.center) / paper.size().x;
  const int count = static_cast<int>(fewCorners * std::clamp(std::ceil(widths), 1.0, mostTimesMore));
  std::vector<glm::dvec2> corners;
  for (const Place &corner : paper.seenPart(circleAround(circle.center, circle.axis, circle.radius, count)))
    corners.push_back(paper.spotOf(corner).at);
  if (turningArea(corners) < 0)
    std::reverse(corners.begin(), corners.end());
  return corners;
}

/// Where a sight enters and leaves a ball, in its own lengths: it is at the place at 1.
std::optional<std::array<double, 2>> passage(const Place &origin, const Place &sight, const Globe &ball) {
  const Place toOrigin = origin - ball.center;
  std::vector<double> roots;
  addRoots(glm::dot(sight, sight), glm::dot(sight, toOrigin),
           glm::dot(toOrigin, toOrigin) - ball.radius * ball.radius, roots);
  if (roots.empty())
    return {};
  return std::array{roots[0], roots[1]};
}

} // namespace

std::optional<FlatVeil> FlatVeil::of(const std::vector<Place> &corners, const Paper &paper) {
  FlatVeil veil;
  for (const Place &corner : corners)
    veil.m_corners.push_back(paper.spotOf(corner).at);
  const double area = turningArea(veil.m_corners);
  if (!(std::abs(area) > 2 * leastArea))
    return {};
  if (area < 0)
    std::reverse(veil.m_corners.begin(), veil.m_corners.end());
  veil.m_normal = glm::normalize(normalOf(corners));
  if (glm::dot(veil.m_normal, paper.sightTo(corners.front())) > 0)
    veil.m_normal = -veil.m_normal;
  veil.m_offset = -glm::dot(veil.m_normal, corners.front());
  return veil;
}

void FlatVeil::addChanges(const SightedPiece &piece, const Paper &paper, std::vector<double> &parts) const {
  const double first = side(piece.from);
  const double last = side(piece.to);
  if ((first > inPlane && last < -inPlane) || (first < -inPlane && last > inPlane))
    parts.push_back(first / (first - last));
  const glm::dvec2 from = paper.spotOf(piece.from).at;
  const glm::dvec2 to = paper.spotOf(piece.to).at;
  for (std::size_t i = 0; i < m_corners.size(); ++i) {
    const glm::dvec2 edge = m_corners[(i + 1) % m_corners.size()] - m_corners[i];
    const double begin = crossOf(edge, from - m_corners[i]);
    const double end = crossOf(edge, to - m_corners[i]);
    if ((begin < 0) != (end < 0))
      parts.push_back(partInSpace(begin / (begin - end), piece, paper));
  }
}

Standing FlatVeil::standingOf(const Place &place, const Paper &paper) const {
  const glm::dvec2 spot = paper.spotOf(place).at;
  double inside = std::numeric_limits<double>::infinity(); // how far, in points
  for (std::size_t i = 0; i < m_corners.size(); ++i) {
    const glm::dvec2 edge = m_corners[(i + 1) % m_corners.size()] - m_corners[i];
    if (const double length = glm::length(edge); length > 0)
      inside = std::min(inside, crossOf(edge, spot - m_corners[i]) / length);
  }
  const double toPlane = side(place);
  // What runs along the border lies on it where it is in the plane; else it passes by.
  if (inside < -onBorder || (inside <= onBorder && std::abs(toPlane) > inPlane))
    return Standing::Aside;
  return toPlane < -inPlane ? Standing::Behind : Standing::Before;
}

bool FlatVeil::isInOnePlaneWith(const FlatVeil &other) const {
  return std::abs(m_offset - other.m_offset) <= inPlane && glm::distance(m_normal, other.m_normal) <= inPlane;
}

std::optional<BallVeil> BallVeil::of(const Globe &ball, Half half, const Paper &paper) {
  const Place toCenter = ball.center - paper.eye();
  if (!(glm::dot(toCenter, paper.viewDirection()) > ball.radius) || !(ball.radius > 0))
    return {};
  BallVeil veil;
  veil.m_ball = ball;
  veil.m_half = half;
  veil.m_corners = silhouetteCorners(ball, paper);
  return veil.m_corners.size() < 3 ? std::nullopt : std::optional(std::move(veil));
}

void BallVeil::addChanges(const SightedPiece &piece, const Paper &paper, std::vector<double> &parts) const {
  const Place along = piece.to - piece.from;
  const double square = m_ball.radius * m_ball.radius;
  // Where it goes through the surface …
  const Place fromCenter = piece.from - m_ball.center;
  addRoots(glm::dot(along, along), glm::dot(along, fromCenter), glm::dot(fromCenter, fromCenter) - square,
           parts);
  // … and where sights to it touch the ball.
  if (paper.isOrthographic()) {
    const Place &view = paper.viewDirection();
    const Place across = along - view * glm::dot(along, view);
    const Place start = fromCenter - view * glm::dot(fromCenter, view);
    addRoots(glm::dot(across, across), glm::dot(across, start), glm::dot(start, start) - square, parts);
    return;
  }
  const Place toCenter = m_ball.center - paper.eye();
  const Place start = piece.from - paper.eye();
  const double tangent = glm::dot(toCenter, toCenter) - square;
  addRoots(glm::dot(along, toCenter) * glm::dot(along, toCenter) - glm::dot(along, along) * tangent,
           glm::dot(along, toCenter) * glm::dot(start, toCenter) - glm::dot(along, start) * tangent,
           glm::dot(start, toCenter) * glm::dot(start, toCenter) - glm::dot(start, start) * tangent, parts);
}

Standing BallVeil::standingOf(const Place &place, const Paper &paper) const {
  const Place sight = paper.sightTo(place);
  const auto ends = passage(paper.sightFrom(place), sight, m_ball);
  if (!ends)
    return Standing::Aside;
  const double dip = dipOfCircles * m_ball.radius / glm::length(sight);
  return ends->at(m_half == Half::Near ? 0 : 1) < 1 - dip ? Standing::Behind : Standing::Before;
}

const std::vector<glm::dvec2> &Veils::cornersOf(std::size_t number) const {
  return std::visit([](const auto &veil) -> const std::vector<glm::dvec2> & { return veil.corners(); },
                    m_veils[number]);
}

void Veils::add(Veil veil) {
  m_veils.push_back(std::move(veil));
  m_boxes.push_back(boxAround(cornersOf(count() - 1)));
}

bool Veils::overlap(std::size_t one, std::size_t other) const {
  const std::vector<glm::dvec2> &first = cornersOf(one);
  const std::vector<glm::dvec2> &second = cornersOf(other);
  return meet(m_boxes[one], m_boxes[other]) && !isParted(first, second) && !isParted(second, first);
}

bool Questions::ask(std::size_t count) {
  const bool areLeft = count <= m_left;
  m_left = areLeft ? m_left - count : 0;
  return areLeft;
}

std::vector<std::size_t> Veils::near(const PixelBox &box, Questions &questions) const {
  std::vector<std::size_t> numbers;
  if (!questions.ask(count()))
    return numbers;
  for (std::size_t i = 0; i < count(); ++i)
    if (meet(m_boxes[i], box))
      numbers.push_back(i);
  return numbers;
}

AmongVeils AmongVeils::with(const AmongVeils &other) const {
  AmongVeils both = *this;
  both.before.insert(other.before.begin(), other.before.end());
  both.behind.insert(other.behind.begin(), other.behind.end());
  return both;
}

AmongVeils Veils::standingOf(const Place &place, Questions &questions) const {
  AmongVeils among;
  for (const std::size_t number : near(boxAround({m_paper.spotOf(place).at}), questions)) {
    const Standing standing =
        std::visit([&](const auto &veil) { return veil.standingOf(place, m_paper); }, m_veils[number]);
    if (standing != Standing::Aside)
      (standing == Standing::Before ? among.before : among.behind).insert(number);
  }
  return among;
}

std::vector<Veils::Stay> Veils::staysOf(const SightedPiece &piece, Questions &questions) const {
  std::vector<Stay> stays;
  std::vector<double> parts;
  for (const std::size_t number :
       near(boxAround({m_paper.spotOf(piece.from).at, m_paper.spotOf(piece.to).at}), questions)) {
    parts.assign({0, 1});
    std::visit([&](const auto &veil) { veil.addChanges(piece, m_paper, parts); }, m_veils[number]);
    parts.erase(
        std::remove_if(parts.begin(), parts.end(), [](double part) { return !(part >= 0 && part <= 1); }),
        parts.end());
    std::sort(parts.begin(), parts.end());
    for (std::size_t i = 1; i < parts.size(); ++i) {
      if (parts[i] <= parts[i - 1])
        continue;
      const Place middle = glm::mix(piece.from, piece.to, (parts[i - 1] + parts[i]) / 2);
      const Standing standing =
          std::visit([&](const auto &veil) { return veil.standingOf(middle, m_paper); }, m_veils[number]);
      if (standing != Standing::Aside)
        stays.push_back({parts[i - 1], parts[i], number, standing});
    }
  }
  return stays;
}

std::vector<StandingSpan> Veils::spansOf(const SightedPiece &piece, Questions &questions) const {
  const std::vector<Stay> stays = staysOf(piece, questions);
  std::vector<double> parts{0, 1};
  for (const Stay &stay : stays) {
    parts.push_back(stay.begin);
    parts.push_back(stay.end);
  }
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  if (!questions.ask(parts.size() * stays.size()))
    return {StandingSpan{}};
  std::vector<StandingSpan> spans;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    StandingSpan span{parts[i - 1], parts[i]};
    for (const Stay &stay : stays)
      if (stay.begin <= span.begin && stay.end >= span.end)
        (stay.standing == Standing::Before ? span.veils.before : span.veils.behind).insert(stay.veil);
    if (!spans.empty() && spans.back().veils == span.veils)
      spans.back().end = span.end;
    else
      spans.push_back(std::move(span));
  }
  return spans;
}

} // namespace halfspace
