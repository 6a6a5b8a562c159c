#include "lessons/lesson/short_numbers.h"

#include "lessons/object/corners.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/polygon.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/sphere.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/kinds/ufo.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/object/solid.h"
#include "lessons/scene/evaluation.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <random>
#include <set>

namespace halfspace {
namespace {

/// Of the scenes that fit, the first few are compared: the shortest of all would often be the same.
constexpr int comparedScenes = 4;
/// An object gets so many chances of short numbers; nearly all need one or two.
constexpr int mostAttempts = 100;

// What is left to chance.
constexpr int freelyOnceIn = 6; ///< regardless of what is looked for
constexpr int alongOnceIn = 6;
constexpr int ordinaryOnceIn = 3; ///< a triangle, where there was none

/// Positions that do not follow from others: small, and mostly where the axes are drawn.
constexpr int lowestPosition = -3;
constexpr int highestPosition = 6;
constexpr int longestStep = 3;
/// A triangle's sides are so many times a short vector.
constexpr int smallestTriangle = 3;
constexpr int largestTriangle = 4;
/// No coordinate of a side is longer: their products of four are still to be calculated.
constexpr int longestSide = 6;

/// Whole numbers a, b, c for which √(a² + b² + c²) is whole too.
constexpr std::array<std::array<int, 3>, 3> wholeLengths{{{1, 2, 2}, {2, 3, 6}, {0, 3, 4}}};

/// Convex faces of three to eight corners, in steps along two directions. All have (1, 1) inside.
using WholeFace = std::vector<glm::ivec2>;
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

/// A result of 0 often means that nothing is left to calculate: it is no shorter than a fraction.
constexpr std::size_t lengthOfZero = 3;
/// What has no short form is longer than all that has.
constexpr std::size_t lengthOfLong = 1000;

/// One roll in a statement, or several in braces: elsewhere C++ leaves their order to the compiler, and a
/// seed would not give the same numbers everywhere.
class Dice {
public:
  explicit Dice(std::uint64_t seed) : m_engine(seed) {}

  /// Whole, from low to high. (What the standard library does for this differs between libraries.)
  int between(int low, int high) {
    return low + static_cast<int>(m_engine() % static_cast<std::uint64_t>(high - low + 1));
  }
  /// True once in `times`.
  bool once(int times) { return between(1, times) == 1; }
  int sign() { return once(2) ? -1 : 1; }

  ExactVec3 position() {
    const auto number = [this] { return between(lowestPosition, highestPosition); };
    return {number(), number(), number()};
  }

  /// At most one of its coordinates is 0.
  ExactVec3 direction(int longest) {
    ExactVec3 vector{};
    do
      vector = {between(-longest, longest), between(-longest, longest), between(-longest, longest)};
    while ((vector.x == 0) + (vector.y == 0) + (vector.z == 0) > 1);
    return vector;
  }

  /// As long as a whole number says.
  ExactVec3 normal() {
    const int last = static_cast<int>(wholeLengths.size()) - 1;
    return turned(wholeLengths.at(static_cast<std::size_t>(between(0, last))));
  }
  ExactVec3 shortestNormal() { return turned(wholeLengths.front()); }
  /// 3 or 5 long.
  ExactVec3 shortNormal() { return turned(once(2) ? wholeLengths.front() : wholeLengths.back()); }

private:
  /// The numbers in any order, with any signs.
  ExactVec3 turned(std::array<int, 3> numbers) {
    for (std::size_t last = numbers.size() - 1; last > 0; --last)
      std::swap(numbers[last], numbers.at(static_cast<std::size_t>(between(0, static_cast<int>(last)))));
    return {sign() * numbers[0], sign() * numbers[1], sign() * numbers[2]};
  }

  std::mt19937_64 m_engine;
};

int wholeOf(const Rational &number) { return static_cast<int>(toDouble(number)); }

/// Whole points of a plane or of a triangle's plane: from `at`, some of the steps.
struct Net {
  ExactVec3 at{};
  std::vector<ExactVec3> steps;
  ExactVec3 normal{};
  int size = 0; ///< of a triangle: so many steps are its sides; 0 for a plane

  [[nodiscard]] ExactVec3 after(const std::vector<int> &counts) const {
    ExactVec3 point = at;
    for (std::size_t i = 0; i < counts.size(); ++i)
      point += steps[i] * Rational(counts[i]);
    return point;
  }
};

/// Two coordinates of the normal, changed places and one sign: a step along the plane, perhaps none.
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

/// Of a line: its whole points, and an arrow across it.
Net netOf(const LineObject &line) {
  const ExactVec3 &v = line.direction;
  const ExactVec3 across = stepAlong(v, 0, 1);
  return {line.point, {v}, isZero(across) ? stepAlong(v, 0, 2) : across, 0};
}

bool isOnALine(const TriangleObject &triangle) {
  return isZero(cross(ExactVec3(triangle.p1 - triangle.p0), ExactVec3(triangle.p2 - triangle.p0)));
}

bool isShort(const Object &object) {
  for (std::size_t index = 0; index < coordinatesOf(object).size(); ++index)
    for (int axis = 0; axis < 3; ++axis) // where there is only x the others are 0
      if (abs(coordinate(object, index)[axis]) > largestShortNumber)
        return false;
  return true;
}

/// Gives objects new numbers, one after the other: what looks for another object comes after it.
class Renewal {
public:
  /// `keepsCornersOnALine`: a triangle whose corners are on one line is drawn so again.
  Renewal(Dice &dice, std::ptrdiff_t planes, std::ptrdiff_t lines, bool keepsCornersOnALine)
      : m_dice(dice), m_planes(planes), m_lines(lines), m_keepsCornersOnALine(keepsCornersOnALine) {}

  /// Whole and short ones that it did not have; it keeps those that it has where there is no luck.
  void renew(Object &object) {
    const Object before = object;
    bool found = false;
    for (int attempt = 0; attempt < mostAttempts && !found; ++attempt) {
      draw(object);
      found = isShort(object) && !(object == before);
    }
    if (!found)
      object = before;
    else if (const auto plane = objectAs<PlaneObject>(object))
      m_nets.push_back(netOf(*plane));
    else if (const auto triangle = objectAs<TriangleObject>(object); triangle && !isOnALine(*triangle))
      m_nets.push_back(netOf(*triangle));
    else if (const auto line = objectAs<LineObject>(object))
      m_nets.push_back(netOf(*line));
    else if (kindOf(object) == PolygonObject::kind || findSolidKind(kindOf(object)))
      m_nets.push_back(m_polygon);
    else if (!m_vector)
      m_vector = objectAs<VectorObject>(object);
  }

private:
  void draw(Object &object) {
    if (!(drawAs<PlaneObject>(object) || drawAs<TriangleObject>(object) || drawAs<PointObject>(object) ||
          drawAs<RayObject>(object) || drawAs<LineObject>(object) || drawAs<VectorObject>(object) ||
          drawAs<SphereObject>(object) || drawAs<UfoObject>(object) || drawAs<PolygonObject>(object) ||
          drawSolid(object)))
      drawAny(object);
  }

  template <TypedObject Kind> bool drawAs(Object &object) {
    auto typed = objectAs<Kind>(object);
    if (typed) {
      draw(*typed);
      object = *typed;
    }
    return typed.has_value();
  }

  /// Of a kind that nothing more is known of.
  void drawAny(Object &object) {
    if (object.kind().binding)
      return drawFreedoms(object);
    const auto specs = coordinatesOf(object);
    for (std::size_t i = 0; i < specs.size(); ++i)
      switch (specs[i].role) {
      case CoordinateRole::Position:
        object[i] = m_dice.position();
        break;
      case CoordinateRole::Direction:
        object[i] = m_dice.direction(longestStep);
        break;
      case CoordinateRole::Length:
        object[i].x = m_dice.between(1, longestSide);
        break;
      case CoordinateRole::Number:
        break;
      }
  }

  /// Where on its host a bound point lies: after sixths of a side or of a direction. Every second one is in
  /// the triangle, if there is one.
  void drawFreedoms(Object &bound) {
    const bool isInside = m_dice.once(2);
    for (std::size_t i = 0; i < bound.size(); ++i)
      bound[i].x = {isInside ? m_dice.between(1, 3) : m_dice.between(-2, 8), 6};
    bound.kind().settle(bound);
  }

  void draw(PlaneObject &plane) {
    plane.point = m_dice.position();
    if (m_planes < 2)
      plane.normal = m_dice.normal();
    else if (m_nets.empty())
      plane.normal = m_dice.shortestNormal();
    else
      drawBeside(m_nets.front(), plane);
  }

  /// The line of two planes has long numbers unless both normals are very short. Now and then they are
  /// parallel, or the same if there are no others.
  void drawBeside(const Net &other, PlaneObject &plane) {
    plane.normal = m_dice.direction(1);
    if (!m_dice.once(alongOnceIn))
      return;
    plane.normal = other.normal * Rational(m_dice.sign());
    if (m_planes == 2 && m_dice.once(2))
      plane.point = pointOf(other);
  }

  /// Its barrel's length is divided by that of an arrow, which is often 3 or a multiple of it.
  void draw(UfoObject &ufo) {
    ufo.start = m_dice.position();
    ufo.velocity = m_dice.direction(longestStep);
    ufo.barrel = m_dice.normal();
    ufo.barrelLength = 3 * m_dice.between(2, 3);
  }

  /// Such that many whole points lie on it.
  void draw(SphereObject &sphere) {
    const ExactVec3 reach = m_dice.shortNormal();
    sphere = {m_dice.position(), Surd::root(dot(reach, reach)).rationalPart()};
    m_sphere = sphere;
  }

  /// From the centre to one of the sphere's whole points.
  ExactVec3 reachOf(const SphereObject &sphere) {
    ExactVec3 reach = m_dice.shortNormal();
    while (dot(reach, reach) != sphere.radius * sphere.radius)
      reach = m_dice.shortNormal();
    return reach;
  }

  /// Through two whole points of a sphere; now and then so that it touches it, or passes by.
  void drawThrough(const SphereObject &sphere, RayObject &ray) {
    const ExactVec3 reach = reachOf(sphere);
    ray.direction = reachOf(sphere) - reach;
    if (isZero(ray.direction))
      ray.direction = reach;
    if (!m_dice.once(3))
      return aimAt(ExactVec3(sphere.center + reach), ray);
    const ExactVec3 across = stepAlong(reach, 0, 1);
    ray.direction = isZero(across) ? stepAlong(reach, 0, 2) : across;
    aimAt(ExactVec3(sphere.center + reach * Rational(m_dice.between(1, 2))), ray);
  }

  /// Now and then it meets what it looks for in a whole point, lies in it, or is parallel to it.
  void draw(LineObject &line) {
    const bool isAlone = m_nets.empty() && m_lines < 2;
    line = {m_dice.position(), isAlone ? m_dice.shortNormal() : m_dice.shortestNormal()};
    if (m_nets.empty())
      return;
    const Net &other = m_nets.front();
    if (m_dice.once(3))
      line.direction = directionAlong(other);
    if (m_dice.once(2))
      line.point = anyPointOf(other);
    line.point += line.direction * Rational(m_dice.between(-1, 1));
  }

  /// With as many corners as before.
  void draw(PolygonObject &polygon) {
    const ExactVec3 first = m_dice.direction(1);
    ExactVec3 second = first;
    while (isZero(cross(first, second)))
      second = m_dice.direction(1);
    m_polygon = {m_dice.position(), {first, second}, cross(first, second), 3};
    const WholeFace &corners = wholeFace(polygon.corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
      polygon.corners[i] = m_polygon.after({corners[i].x, corners[i].y});
  }

  /// Square to the axes as far as it can be: rays meet its other faces at short numbers too. A face of it is
  /// looked for.
  bool drawSolid(Object &solid) {
    if (!findSolidKind(kindOf(solid)))
      return false;
    const int axis = m_dice.between(0, 2);
    const auto arrow = [&](int turn, int length) {
      ExactVec3 along{};
      along[(axis + turn) % 3] = length;
      return along;
    };
    const int size = m_dice.between(smallestTriangle, largestTriangle);
    const ExactVec3 corner = m_dice.position();
    solid[0] = corner;
    if (kindOf(solid) == "box") {
      for (std::size_t i = 1; i < solid.size(); ++i)
        solid[i].x = m_dice.between(smallestTriangle, longestSide);
      m_polygon = {corner, {arrow(1, 1), arrow(2, 1)}, arrow(0, 1), smallestTriangle};
    } else if (kindOf(solid) == "tetrahedron") {
      m_polygon = {corner, {arrow(1, m_dice.sign()), arrow(2, m_dice.sign())}, arrow(0, 1), size};
      for (std::size_t i = 0; i < 2; ++i)
        solid[i + 1] = corner + m_polygon.steps[i] * Rational(size);
      solid[3] = corner + arrow(0, size * m_dice.sign());
    } else {
      m_polygon = {corner, {arrow(1, m_dice.sign()), arrow(2, m_dice.between(1, 2))}, arrow(0, 1), 3};
      const std::vector<std::size_t> base = cornersOf(solid);
      const WholeFace &corners = wholeFace(base.size());
      for (std::size_t i = 0; i < base.size(); ++i)
        solid[base[i]] = m_polygon.after({corners[i].x, corners[i].y});
      solid[1] = arrow(0, m_dice.sign() * m_dice.between(smallestTriangle, longestSide));
    }
    return true;
  }

  /// Later ones start where the first does. Most have another length, so that it is seen by whose length is
  /// divided; now and then they are at a right angle to it, or lie along it.
  void draw(VectorObject &vector) {
    vector.vector = m_dice.shortNormal();
    vector.start = m_vector ? m_vector->start : m_dice.position();
    if (!m_vector)
      return;
    const ExactVec3 &first = m_vector->vector;
    while (dot(vector.vector, vector.vector) == dot(first, first))
      vector.vector = m_dice.once(2) ? m_dice.shortNormal() : m_dice.shortestNormal() * Rational(2);
    if (m_dice.once(alongOnceIn))
      vector.vector = m_dice.once(2) ? stepAlong(first, 0, 1) : first * Rational(2 * m_dice.sign());
  }

  void draw(TriangleObject &triangle) {
    if (m_keepsCornersOnALine && isOnALine(triangle))
      return drawOnALine(triangle);
    const int size = m_dice.between(smallestTriangle, largestTriangle);
    const int longest = longestSide / size;
    const ExactVec3 first = m_dice.direction(longest);
    ExactVec3 second = first;
    while (isZero(cross(first, second)))
      second = m_dice.direction(longest);
    const ExactVec3 corner = m_dice.position();
    triangle = {corner, corner + first * Rational(size), corner + second * Rational(size)};
  }

  /// Each corner in a place of its own.
  void drawOnALine(TriangleObject &triangle) {
    const ExactVec3 step = m_dice.direction(longestStep);
    const int first = m_dice.sign() * m_dice.between(1, longestStep);
    int second = first;
    while (second == first)
      second = m_dice.sign() * m_dice.between(1, longestStep);
    triangle.p0 = m_dice.position();
    triangle.p1 = triangle.p0 + step * Rational(first);
    triangle.p2 = triangle.p0 + step * Rational(second);
  }

  /// At random; straight above, in or below what it looks for; in the plane of a triangle.
  void draw(PointObject &point) {
    point.at = m_dice.position();
    const Net *net = aim();
    if (!net || m_dice.once(freelyOnceIn))
      return;
    if (net->size > 0) {
      point.at = m_dice.once(alongOnceIn) ? cornerOf(*net) : pointOf(*net);
      return;
    }
    const ExactVec3 foot = pointOf(*net);
    point.at = foot + net->normal * Rational(m_dice.between(-2, 2));
  }

  /// At random, in what it looks for, along it, or towards a point of it.
  void draw(RayObject &ray) {
    ray = {m_dice.position(), m_dice.direction(longestStep)};
    if (m_sphere)
      return drawThrough(*m_sphere, ray);
    const Net *net = aim();
    if (!net || m_dice.once(freelyOnceIn))
      return;
    const ExactVec3 point = pointOf(*net);
    if (m_dice.once(alongOnceIn))
      ray = {point, directionAlong(*net)};
    else if (m_dice.once(alongOnceIn))
      ray.direction = directionAlong(*net);
    else
      aimAt(point, ray);
  }

  /// Behind one time in three; after steps, or half steps.
  void aimAt(const ExactVec3 &point, RayObject &ray) {
    const ExactVec3 step = ray.direction;
    const int steps = m_dice.between(1, 4);
    const bool isBehind = m_dice.once(3);
    ray.origin = point - step * Rational(isBehind ? -steps : steps);
    ray.direction = step * Rational(m_dice.between(1, 2));
  }

  const Net *aim() {
    if (m_nets.empty())
      return nullptr;
    return &m_nets[static_cast<std::size_t>(m_dice.between(0, static_cast<int>(m_nets.size()) - 1))];
  }

  /// Not the point that is given already. Of a triangle's net, every second one is inside.
  ExactVec3 pointOf(const Net &net) {
    ExactVec3 point = net.at;
    while (point == net.at)
      point = anyPointOf(net);
    return point;
  }

  /// Of a triangle's net.
  ExactVec3 cornerOf(const Net &net) {
    const int corner = m_dice.between(0, 2);
    return net.after({corner == 1 ? net.size : 0, corner == 2 ? net.size : 0});
  }

  ExactVec3 anyPointOf(const Net &net) {
    if (net.size == 0) {
      std::vector<int> counts;
      for (std::size_t i = 0; i < net.steps.size(); ++i)
        counts.push_back(m_dice.between(-1, 1));
      return net.after(counts);
    }
    if (m_dice.once(2))
      return net.after({m_dice.between(0, net.size + 1), m_dice.between(0, net.size + 1)});
    const int first = m_dice.between(1, net.size - 2);
    return net.after({first, m_dice.between(1, net.size - 1 - first)});
  }

  ExactVec3 directionAlong(const Net &net) {
    ExactVec3 direction{};
    while (isZero(direction))
      for (const ExactVec3 &step : net.steps)
        direction += step * Rational(m_dice.between(-1, 1));
    return direction;
  }

  Dice &m_dice;
  // How many there are:
  std::ptrdiff_t m_planes;
  std::ptrdiff_t m_lines;
  bool m_keepsCornersOnALine;
  std::vector<Net> m_nets;
  Net m_polygon;                        ///< of the last that was drawn
  std::optional<VectorObject> m_vector; ///< the first
  std::optional<SphereObject> m_sphere; ///< the last
};

/// What is looked for before what looks for it.
void renewAll(std::vector<Object *> objects, Dice &dice, bool keepsCornersOnALine = false) {
  const auto count = [&](std::string_view kind) {
    return std::count_if(objects.begin(), objects.end(),
                         [&](const Object *object) { return kindOf(*object) == kind; });
  };
  Renewal renewal(dice, count(PlaneObject::kind), count(LineObject::kind), keepsCornersOnALine);
  const auto isLine = [](const Object *object) { return kindOf(*object) == LineObject::kind; };
  const auto others = std::stable_partition(objects.begin(), objects.end(), [&](const Object *object) {
    const std::string_view kind = kindOf(*object);
    return isLine(object) || kind == PlaneObject::kind || kind == TriangleObject::kind ||
           kind == SphereObject::kind || kind == PolygonObject::kind || findSolidKind(kind);
  });
  std::stable_partition(objects.begin(), others, std::not_fn(isLine));
  for (Object *object : objects)
    renewal.renew(*object);
}

/// The last construction and all that it follows from: nothing else has a say in what is shown as the result.
Scene shownPartOf(const Scene &scene) {
  std::set<std::string> needed;
  Scene part;
  for (std::size_t i = scene.entries.size(); i-- > 0;) {
    const Entry &entry = scene.entries[i];
    const auto *use = std::get_if<ConstructionUse>(&entry.content);
    const bool isLastUse = use && needed.empty();
    if (!isLastUse && !needed.contains(entry.name))
      continue;
    for (const std::string &id : referencesIn(entry))
      needed.insert(ownerOf(id));
    part.entries.push_back(entry);
  }
  std::reverse(part.entries.begin(), part.entries.end());
  return part;
}

std::vector<Object *> objectsOf(Scene &scene) {
  std::vector<Object *> objects;
  for (Entry &entry : scene.entries)
    if (auto *object = std::get_if<Object>(&entry.content))
      objects.push_back(object);
  return objects;
}

/// A construction has none of its own, a plain number keeps its one, as it may be a bound or a step, and a
/// mesh stays where others stand around it.
bool keepsItsNumbers(const Entry &entry) {
  const auto *object = std::get_if<Object>(&entry.content);
  return !object || kindOf(*object) == NumberObject::kind || object->shape();
}

bool differEverywhere(const Scene &a, const Scene &b) {
  return std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(),
                    [](const Entry &x, const Entry &y) { return keepsItsNumbers(x) || !(x == y); });
}

std::size_t lengthOf(const Surd &number) {
  if (number == Surd(0))
    return lengthOfZero;
  const auto text = toText(number);
  return text ? text->size() : lengthOfLong;
}

std::size_t lengthOf(const std::vector<NamedValue> &values) {
  std::size_t length = 0;
  for (const NamedValue &value : values)
    length += std::visit(Overloaded{[](const Surd &number) { return lengthOf(number); },
                                    [](const std::vector<Surd> &numbers) {
                                      std::size_t sum = 0;
                                      for (const Surd &number : numbers)
                                        sum += lengthOf(number);
                                      return sum;
                                    },
                                    [](const std::vector<NamedValue> &group) { return lengthOf(group); },
                                    [](const auto &) { return std::size_t(0); }},
                         value.value);
  return length;
}

/// Keeps the shortest of the first few scenes.
class Shortest {
public:
  [[nodiscard]] bool isFull() const { return m_count == comparedScenes; }
  void compare(Scene scene, std::size_t length) {
    if (isFull())
      return;
    ++m_count;
    if (!m_scene || length < m_length) {
      m_scene = std::move(scene);
      m_length = length;
    }
  }
  [[nodiscard]] const std::optional<Scene> &scene() const { return m_scene; }

private:
  std::optional<Scene> m_scene;
  std::size_t m_length = 0;
  int m_count = 0;
};

/// The shortest of some new scenes. With the case of `before` if that is wanted and no degenerate one; no new
/// scene is degenerate where `before` is not. Those of which the same is told beside numbers come first.
std::optional<Scene> renewed(const Scene &before, Dice &dice, const WantedNumbers &wanted) {
  const Evaluation start = evaluate(before);
  if (!start.lastConstruction())
    return before; // nothing is shown as the result
  const Outcome &present = *start.lastConstruction()->outcome;
  const std::vector<std::string> lines = present.explanation->ids();
  const bool keepsCornersOnALine =
      present.told->degenerate && !(wanted.keepCase && dice.once(ordinaryOnceIn));
  Shortest alike;
  Shortest others;
  for (int tried = 0; tried < mostNumbersTried && !alike.isFull(); ++tried) {
    Scene scene = before;
    renewAll(objectsOf(scene), dice, keepsCornersOnALine);
    if (!differEverywhere(scene, before) || (wanted.suits && !wanted.suits(scene)))
      continue;
    const Evaluation evaluation = evaluate(scene);
    const Outcome &outcome = *evaluation.lastConstruction()->outcome;
    const bool isOfItsCase = outcome.told->name == present.told->name;
    const bool isAllowed =
        present.told->degenerate || (!outcome.told->degenerate && (!wanted.keepCase || isOfItsCase));
    if (!isAllowed)
      continue;
    Shortest &kept =
        !wanted.keepCase || (isOfItsCase && outcome.explanation->ids() == lines) ? alike : others;
    kept.compare(std::move(scene), lengthOf(*outcome.values));
  }
  return alike.scene() ? alike.scene() : others.scene();
}

} // namespace

Scene withShortNumbers(Scene scene, std::uint64_t seed, const WantedNumbers &wanted) {
  Dice dice(seed);
  const auto last = renewed(shownPartOf(scene), dice, wanted);
  if (!last)
    return scene;
  std::vector<Object *> others;
  for (Entry &entry : scene.entries)
    if (auto *object = std::get_if<Object>(&entry.content)) {
      if (const Object *found = findObject(*last, entry.name))
        *object = *found;
      else
        others.push_back(object);
    }
  renewAll(std::move(others), dice);
  return scene;
}

} // namespace halfspace
