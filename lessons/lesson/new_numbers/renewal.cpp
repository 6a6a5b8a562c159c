#include "lessons/lesson/new_numbers/renewal.h"

#include "lessons/lesson/new_numbers/faces.h"
#include "lessons/lesson/new_numbers/lighting.h"
#include "lessons/lesson/new_numbers/several_planes.h"
#include "lessons/lesson/new_numbers/sphere_numbers.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/segment.h"
#include "lessons/object/kinds/ufo.h"
#include "lessons/object/kinds/vector.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace halfspace {
namespace {

/// An object gets so many chances of short numbers; nearly all need one or two.
constexpr int mostAttempts = 100;

// What is left to chance.
constexpr int freelyOnceIn = 6; ///< regardless of what is looked for
constexpr int alongOnceIn = 6;

bool isShort(const Object &object) {
  for (std::size_t index = 0; index < coordinatesOf(object).size(); ++index)
    for (int axis = 0; axis < 3; ++axis) // where there is only x the others are 0
      if (abs(coordinate(object, index)[axis]) > largestShortNumber)
        return false;
  return true;
}

/// What there is in a scene.
struct Inventory {
  // How many there are:
  std::ptrdiff_t planes;
  std::ptrdiff_t lines;
  std::ptrdiff_t vectors;
  bool isLit;          ///< a vector is light that shines past points onto a plane
  bool areFourPoints;  ///< and nothing else
  bool areThreePlanes; ///< likewise
};

/// Gives objects new numbers, one after the other: what looks for another object comes after it.
class Renewal {
public:
  /// `keepsCornersOnALine`: a triangle whose corners are on one line is drawn so again.
  Renewal(Dice &dice, const Inventory &scene, bool keepsCornersOnALine)
      : m_dice(dice), m_scene(scene), m_keepsCornersOnALine(keepsCornersOnALine), m_spheres(dice) {
    if (scene.isLit)
      m_light.emplace(dice);
  }

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
      addPlane(*plane);
    else if (const auto triangle = objectAs<TriangleObject>(object); triangle && !isOnALine(*triangle))
      m_nets.push_back(netOf(*triangle));
    else if (const auto line = objectAs<LineObject>(object))
      m_nets.push_back(netOf(*line));
    else if (m_face)
      m_nets.push_back(*m_face);
    else if (const auto vector = objectAs<VectorObject>(object))
      m_drawnVectors.push_back(*vector);
    else if (isLit() && kindOf(object) == PointObject::kind)
      m_light->keepPoint();
    else
      m_drawnPoint = objectAs<PointObject>(object);
  }

private:
  void addPlane(const PlaneObject &plane) {
    m_nets.push_back(netOf(plane));
    if (m_light)
      m_light->shineOnto(m_nets.back());
  }

  void draw(Object &object) {
    m_face = drawFace(object, m_dice);
    if (!(m_face || drawAs<PlaneObject>(object) || drawAs<TriangleObject>(object) ||
          drawAs<PointObject>(object) || drawAs<RayObject>(object) || drawAs<LineObject>(object) ||
          drawAs<SegmentObject>(object) || drawAs<VectorObject>(object) || drawAs<SphereObject>(object) ||
          drawAs<UfoObject>(object)))
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
    if (m_scene.planes < 2 && !m_light)
      plane.normal = m_dice.normal();
    else if (m_light || m_nets.empty())
      plane.normal = m_dice.shortestNormal();
    else if (m_scene.areThreePlanes)
      drawOfThree(m_nets.front(), m_nets.back(), m_dice, plane);
    else
      drawBeside(m_nets.front(), m_scene.planes == 2, m_dice, plane);
  }

  /// Its barrel's length is divided by that of an arrow, which is often 3 or a multiple of it.
  void draw(UfoObject &ufo) {
    ufo.start = m_dice.position();
    ufo.velocity = m_dice.direction(longestStep);
    ufo.barrel = m_dice.normal();
    ufo.barrelLength = 3 * m_dice.between(2, 3);
  }

  void draw(SphereObject &sphere) {
    if (m_scene.planes > 0 && !m_nets.empty())
      m_spheres.drawAt(m_nets.front(), sphere);
    else
      m_spheres.draw(sphere);
  }

  /// Now and then it meets what it looks for in a whole point, lies in it, is parallel to it, or stands
  /// straight on a plane.
  void draw(LineObject &line) {
    if (m_spheres.hasSphere()) {
      line = m_spheres.lineThrough();
      line.point += line.direction * Rational(m_dice.between(-1, 1));
      return;
    }
    const bool isAlone = m_nets.empty() && m_scene.lines < 2;
    line = {m_dice.position(), isAlone ? m_dice.shortNormal() : m_dice.shortestNormal()};
    if (m_nets.empty())
      return;
    const Net &other = m_nets.front();
    if (m_dice.once(3))
      line.direction = directionAlong(other, m_dice);
    else if (m_scene.planes > 0 && m_dice.once(alongOnceIn))
      line.direction = other.normal;
    if (m_dice.once(2))
      line.point = anyPointOf(other, m_dice);
    line.point += line.direction * Rational(m_dice.between(-1, 1));
  }

  /// Later ones start where the first does. Most have another length, so that it is seen by whose length is
  /// divided; now and then they are at a right angle to it, or lie along it.
  void draw(VectorObject &vector) {
    if (isLit())
      return m_light->draw(vector);
    const bool isFirst = m_drawnVectors.empty();
    vector.vector = m_scene.vectors > 2 ? vectorOfThree() : m_dice.shortNormal();
    vector.start = isFirst ? m_dice.position() : m_drawnVectors.front().start;
    if (isFirst || m_scene.vectors > 2)
      return;
    const ExactVec3 &first = m_drawnVectors.front().vector;
    while (dot(vector.vector, vector.vector) == dot(first, first))
      vector.vector = m_dice.once(2) ? m_dice.shortNormal() : m_dice.shortestNormal() * Rational(2);
    if (m_dice.once(alongOnceIn))
      vector.vector = m_dice.once(2) ? stepAlong(first, 0, 1) : first * Rational(2 * m_dice.sign());
  }

  /// The area between the first two is a whole number: the height of the others over it is divided by that.
  /// Now and then they lie in one plane.
  ExactVec3 vectorOfThree() {
    if (m_drawnVectors.empty())
      return m_dice.shortestNormal();
    const ExactVec3 &first = m_drawnVectors.front().vector;
    if (m_drawnVectors.size() > 1) {
      const bool isInPlane = m_dice.once(alongOnceIn);
      const ExactVec3 other = m_dice.direction(longestStep);
      return isInPlane ? ExactVec3(m_drawnVectors[1].vector + first * Rational(m_dice.sign())) : other;
    }
    ExactVec3 second = first;
    for (ExactVec3 area{}; isZero(area) || !Surd::root(dot(area, area)).isRational();) {
      second = m_dice.direction(longestStep);
      area = cross(first, second);
    }
    return second;
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

  /// Four without anything else on one sphere. At random; straight above, in or below what it looks for,
  /// beside a line or on it; in the plane of a triangle. Where there are points alone, now and then where the
  /// one before is.
  void draw(PointObject &point) {
    if (isLit())
      return m_light->draw(point);
    if (m_scene.areFourPoints) {
      point.at = m_spheres.pointOnIt();
      return;
    }
    point.at = m_dice.position();
    const Net *net = aim();
    if (!net && m_drawnPoint && m_dice.once(alongOnceIn))
      point = *m_drawnPoint;
    if (!net || m_dice.once(freelyOnceIn))
      return;
    if (net->size > 0) {
      point.at = m_dice.once(alongOnceIn) ? cornerOf(*net, m_dice) : pointOf(*net, m_dice);
      return;
    }
    const ExactVec3 foot = net->steps.size() == 1 ? stepsAlong(*net) : pointOf(*net, m_dice);
    point.at = foot + net->normal * Rational(m_dice.between(-2, 2));
  }

  /// A point of a line after some steps, forwards or backwards: often beyond the first.
  ExactVec3 stepsAlong(const Net &line) {
    const int sign = m_dice.sign();
    return line.after({sign * m_dice.between(1, longestStep)});
  }

  /// At random, in what it looks for, along it, or towards a point of it.
  void draw(RayObject &ray) {
    ray = {m_dice.position(), m_dice.direction(longestStep)};
    if (m_spheres.hasSphere()) {
      const LineObject line = m_spheres.lineThrough();
      ray.direction = line.direction;
      return aimAt(line.point, ray);
    }
    const Net *net = aim();
    if (!net || m_dice.once(freelyOnceIn))
      return;
    const ExactVec3 point = pointOf(*net, m_dice);
    if (m_dice.once(alongOnceIn))
      ray = {point, directionAlong(*net, m_dice)};
    else if (m_dice.once(alongOnceIn))
      ray.direction = directionAlong(*net, m_dice);
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

  /// Its line meets what it looks for in a whole point, after steps from an end: between the ends, at one of
  /// them or beyond. Now and then it is along it, or in it.
  void draw(SegmentObject &segment) {
    const Net *net = aim();
    const ExactVec3 point = net ? pointOf(*net, m_dice) : m_dice.position();
    ExactVec3 step = m_dice.direction(longestStep);
    segment.from = point - step * Rational(m_dice.between(-2, 3));
    if (net && m_dice.once(alongOnceIn)) {
      step = directionAlong(*net, m_dice);
      segment.from = m_dice.once(2) ? point : m_dice.position();
    }
    segment.to = segment.from + step * Rational(m_dice.between(1, 3));
  }

  [[nodiscard]] bool isLit() const { return m_light && m_light->hasPlane(); }

  const Net *aim() {
    if (m_nets.empty())
      return nullptr;
    return &m_nets[static_cast<std::size_t>(m_dice.between(0, static_cast<int>(m_nets.size()) - 1))];
  }

  Dice &m_dice;
  Inventory m_scene;
  std::optional<Lighting> m_light;
  bool m_keepsCornersOnALine;
  std::vector<Net> m_nets;
  std::optional<Net> m_face; ///< of the object that was drawn last, where one is looked for
  std::vector<VectorObject> m_drawnVectors;
  std::optional<PointObject> m_drawnPoint; ///< the object before, where it is a point
  SphereNumbers m_spheres;
};

} // namespace

void renewAll(Scene &scene, const std::vector<std::string> &names, Dice &dice, bool keepsCornersOnALine) {
  std::vector<Object> renewed;
  renewed.reserve(names.size());
  for (const std::string &name : names)
    renewed.push_back(*findObject(scene, name));
  std::vector<Object *> objects;
  objects.reserve(renewed.size());
  for (Object &object : renewed)
    objects.push_back(&object);
  const auto count = [&](std::string_view kind) {
    return std::count_if(objects.begin(), objects.end(),
                         [&](const Object *object) { return kindOf(*object) == kind; });
  };
  const auto points = count(PointObject::kind);
  const bool isLit = count(PlaneObject::kind) == 1 && count(VectorObject::kind) == 1 && points > 0;
  const Inventory inventory{
      count(PlaneObject::kind),           count(LineObject::kind),
      count(VectorObject::kind),          isLit,
      points == 4 && objects.size() == 4, objects.size() == 3 && count(PlaneObject::kind) == 3};
  Renewal renewal(dice, inventory, keepsCornersOnALine);
  // What is looked for comes before what looks for it: spheres look for planes, and lines for spheres.
  const auto isLine = [](const Object *object) { return kindOf(*object) == LineObject::kind; };
  const auto others = std::stable_partition(objects.begin(), objects.end(), [&](const Object *object) {
    const std::string_view kind = kindOf(*object);
    return isLine(object) || kind == PlaneObject::kind || kind == TriangleObject::kind ||
           kind == SphereObject::kind || hasFace(kind);
  });
  const auto lines = std::stable_partition(objects.begin(), others, std::not_fn(isLine));
  std::stable_partition(objects.begin(), lines,
                        [](const Object *object) { return kindOf(*object) != SphereObject::kind; });
  for (Object *object : objects)
    renewal.renew(*object);
  for (std::size_t i = 0; i < names.size(); ++i)
    setObject(scene, names[i], std::move(renewed[i]));
}

} // namespace halfspace
