#include "lessons/lesson/new_numbers/net.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace halfspace {
namespace {

int wholeOf(const Rational &number) { return static_cast<int>(toDouble(number)); }

} // namespace

ExactVec3 Net::after(const std::vector<int> &counts) const {
  ExactVec3 point = at;
  for (std::size_t i = 0; i < counts.size(); ++i)
    point += steps[i] * Rational(counts[i]);
  return point;
}

ExactVec3 stepAlong(const ExactVec3 &normal, int from, int to) {
  const int common = std::max(1, std::gcd(wholeOf(normal[from]), wholeOf(normal[to])));
  ExactVec3 step{};
  step[from] = -wholeOf(normal[to]) / common;
  step[to] = wholeOf(normal[from]) / common;
  return step;
}

Net netOf(const PlaneObject &plane) {
  const ExactVec3 &n = plane.normal;
  return {plane.point, {stepAlong(n, 0, 1), stepAlong(n, 0, 2), stepAlong(n, 1, 2)}, n, 0};
}

Net netOf(const TriangleObject &triangle) {
  Net net{triangle.p0, {triangle.p1 - triangle.p0, triangle.p2 - triangle.p0}, {}, 0};
  for (const ExactVec3 &side : net.steps)
    for (int axis = 0; axis < 3; ++axis)
      net.size = std::gcd(net.size, wholeOf(side[axis]));
  for (ExactVec3 &step : net.steps)
    step /= Rational(net.size);
  net.normal = cross(net.steps[0], net.steps[1]);
  return net;
}

Net netOf(const LineObject &line) {
  const ExactVec3 &v = line.direction;
  const ExactVec3 across = stepAlong(v, 0, 1);
  return {line.point, {v}, isZero(across) ? stepAlong(v, 0, 2) : across, 0};
}

ExactVec3 anyPointOf(const Net &net, Dice &dice) {
  if (net.size == 0) {
    std::vector<int> counts;
    for (std::size_t i = 0; i < net.steps.size(); ++i)
      counts.push_back(dice.between(-1, 1));
    return net.after(counts);
  }
  if (dice.once(2))
    return net.after({dice.between(0, net.size + 1), dice.between(0, net.size + 1)});
  const int first = dice.between(1, net.size - 2);
  return net.after({first, dice.between(1, net.size - 1 - first)});
}

ExactVec3 pointOf(const Net &net, Dice &dice) {
  ExactVec3 point = net.at;
  while (point == net.at)
    point = anyPointOf(net, dice);
  return point;
}

ExactVec3 cornerOf(const Net &net, Dice &dice) {
  const int corner = dice.between(0, 2);
  return net.after({corner == 1 ? net.size : 0, corner == 2 ? net.size : 0});
}

ExactVec3 directionAlong(const Net &net, Dice &dice) {
  ExactVec3 direction{};
  while (isZero(direction))
    for (const ExactVec3 &step : net.steps)
      direction += step * Rational(dice.between(-1, 1));
  return direction;
}

bool isOnALine(const TriangleObject &triangle) {
  return isZero(cross(ExactVec3(triangle.p1 - triangle.p0), ExactVec3(triangle.p2 - triangle.p0)));
}

const WholeFace &wholeFace(std::size_t corners) {
  static const std::array<WholeFace, 6> faces{
      {{{0, 0}, {3, 0}, {0, 3}},
       {{0, 0}, {2, 0}, {3, 3}, {0, 2}},
       {{0, 0}, {2, 0}, {3, 1}, {2, 3}, {0, 2}},
       {{1, 0}, {2, 0}, {3, 1}, {2, 2}, {1, 2}, {0, 1}},
       {{1, 0}, {2, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 1}},
       {{1, 0}, {2, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 2}, {0, 1}}}};
  return faces.at(corners - faces.front().size());
}

} // namespace halfspace
