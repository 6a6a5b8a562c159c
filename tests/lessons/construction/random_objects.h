// Objects at random places, the unlucky ones among them on purpose.
#pragma once

#include "geometry/line.h"
#include "geometry/plane.h"
#include "lessons/construction/construction.h"
#include "lessons/object/corners.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/box.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/mesh.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/polygon.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/screen.h"
#include "lessons/object/kinds/segment.h"
#include "lessons/object/kinds/sphere.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/kinds/ufo.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/object/solid.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <span>

namespace halfspace::test {

/// How the coordinates are written that a scene is made of.
enum class Writing { SmallIntegers, Halves, Decimals, Fractions, LongFractions, LargeIntegers };

class RandomObjects {
public:
  explicit RandomObjects(std::uint64_t seed) : m_engine(seed) {}

  /// Objects for the roles of a construction. Every second scene has something in it that is special: a zero
  /// vector, a ray along the plane, a point on it, a corner that is hit exactly, corners on one line, two
  /// that are the same …
  std::vector<Object> objectsFor(const Construction &construction, Writing writing) {
    m_writing = writing;
    std::vector<Object> objects;
    for (const ConstructionRole &role : construction.roles)
      for (int count = role.isList ? integer(1, maxListedObjects) : 1; count > 0; --count) {
        objects.push_back(*makeObject(anyOf(kindsSeenAs(role.kind))));
        for (std::size_t i = 0; i < coordinatesOf(objects.back()).size(); ++i)
          coordinate(objects.back(), i) = vector();
        if (kindOf(objects.back()) == "prism")
          giveConvexBase(objects.back());
        if (role.kind == BoxObject::kind)
          giveLengths(objects.back());
        if (role.kind == ScreenObject::kind)
          givePixels(objects.back());
        if (role.kind == PolygonObject::kind)
          objects.back() = convexPolygon();
        if (role.kind == NumberObject::kind)
          objects.back() = numberFor(role.name);
        if (role.kind == MeshObject::kind)
          giveShape(objects.back());
        objects.back().kind().settle(objects.back());
      }
    if (integer(0, 1) == 0)
      makeSpecial(objects);
    makePointsSpecial(objects);
    makeLightSpecial(objects);
    makeMeshesSpecial(construction, objects);
    if (std::any_of(construction.roles.begin(), construction.roles.end(),
                    [](const ConstructionRole &role) { return role.isList; }))
      makePlanesSpecial(objects);
    return objects;
  }

private:
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }

  /// Nothing is drawn where there is one alone.
  std::string_view anyOf(const std::vector<std::string_view> &words) {
    return words.size() == 1
               ? words[0]
               : words[static_cast<std::size_t>(integer(0, static_cast<int>(words.size()) - 1))];
  }

  Rational number() {
    constexpr int twelveDigits = 999'999'999;
    switch (m_writing) {
    case Writing::SmallIntegers:
      return integer(-9, 9);
    case Writing::Halves:
      return {integer(-18, 18), 2};
    case Writing::Decimals:
      return {integer(-999, 999), 100};
    case Writing::Fractions:
      return {integer(-99, 99), integer(1, 12)};
    case Writing::LargeIntegers:
      return integer(-999'999'999, 999'999'999);
    case Writing::LongFractions:
      break;
    }
    const auto longInteger = [&] {
      return Rational(integer(1, 999)) * 1'000'000'000 + integer(0, twelveDigits);
    };
    const Rational numerator = longInteger() * (integer(0, 1) == 0 ? 1 : -1);
    return numerator / longInteger();
  }

  ExactVec3 vector() { return {number(), number(), number()}; }

  /// Perpendicular to n; perhaps zero.
  ExactVec3 vectorAlongPlane(const ExactVec3 &n) { return cross(n, vector()); }

  /// The first object of a kind, to be written back when it is changed.
  template <class Kind> struct Found {
    explicit Found(std::vector<Object> &objects) {
      for (Object &object : objects)
        if (auto found = objectAs<Kind>(object)) {
          typed = found;
          place = &object;
        }
    }
    Found(const Found &) = delete;
    Found &operator=(const Found &) = delete;
    ~Found() {
      if (typed)
        *place = *typed;
    }
    std::optional<Kind> typed;
    Object *place = nullptr;
  };

  void makeSpecial(std::vector<Object> &objects) {
    if (objects.size() == 2 && kindOf(objects[0]) == PlaneObject::kind &&
        kindOf(objects[1]) == PlaneObject::kind)
      return makeSpecialPair(objects[0], objects[1]);
    if (objects.size() == 3 && std::all_of(objects.begin(), objects.end(), [](const Object &object) {
          return kindOf(object) == PlaneObject::kind;
        }))
      return makeSpecialPlanes(objects[0], objects[1], objects[2]);
    if (objects.size() == 2 && kindOf(objects[0]) == LineObject::kind &&
        kindOf(objects[1]) == LineObject::kind)
      return makeSpecialLines(objects[0], objects[1]);
    if (objects.size() == 2 && kindOf(objects[0]) == VectorObject::kind &&
        kindOf(objects[1]) == VectorObject::kind)
      return makeSpecialVectors(objects[0], objects[1]);
    if (objects.size() == 3 && std::all_of(objects.begin(), objects.end(), [](const Object &object) {
          return kindOf(object) == VectorObject::kind;
        }))
      return makeSpecialVectors(objects[0], objects[1], objects[2]);
    if (const auto screen = objects.size() == 3 ? objectAs<ScreenObject>(objects[1]) : std::nullopt)
      return makeSpecialCamera(objects[0][0], *screen, objects);
    if (objects.size() == 3 && kindOf(objects[0]) == LineObject::kind)
      return makeSpecialWalk(objects[0], objects[1][0], objects[2][0]);
    if (objects.size() == 4 && std::all_of(objects.begin(), objects.end(), [](const Object &object) {
          return kindOf(object) == PointObject::kind;
        }))
      return makeSpecialFour(objects[0][0], objects[1][0], objects[2][0], objects[3][0]);
    if (objects.size() == 1 && findSolidKind(kindOf(objects[0])))
      return makeSpecialSolid(objects[0]);
    if (objects.size() == 1 && kindOf(objects[0]) == PolygonObject::kind)
      return makeSpecialPolygon(objects[0]);
    for (std::size_t i = 1; i < objects.size(); ++i)
      if (kindOf(objects[i]) == kindOf(objects[0]) && integer(0, 3) == 0)
        objects[i] = objects[0];
    Found<PointObject> point(objects);
    Found<RayObject> ray(objects);
    Found<PlaneObject> plane(objects);
    Found<TriangleObject> triangle(objects);
    if (plane.typed)
      makeSpecial(*plane.typed);
    if (plane.typed && point.typed)
      place(point.typed->at, *plane.typed);
    if (plane.typed && ray.typed)
      makeSpecial(*ray.typed, *plane.typed);
    if (triangle.typed && ray.typed)
      makeSpecial(*triangle.typed, *ray.typed);
    Found<SphereObject> sphere(objects);
    Found<LineObject> line(objects);
    if (sphere.typed && ray.typed)
      makeSpecial(*sphere.typed, ray.typed->origin, ray.typed->direction);
    if (sphere.typed && plane.typed)
      makeSpecial(*sphere.typed, *plane.typed);
    if (Found<SegmentObject> segment(objects); segment.typed && plane.typed)
      makeSpecial(*segment.typed, *plane.typed);
    if (triangle.typed && point.typed)
      makeSpecial(*triangle.typed, point.typed->at);
    if (triangle.typed && objects.size() == 1)
      makeSpecial(*triangle.typed);
    if (Found<PolygonObject> polygon(objects); polygon.typed && ray.typed)
      makeSpecial(polygon.typed->corners, *ray.typed);
    if (ray.typed && findSolidKind(kindOf(objects[0])))
      makeSpecialSolid(objects[0], *ray.typed);
    if (Found<UfoObject> ufo(objects); ufo.typed)
      makeSpecial(*ufo.typed);
    if (sphere.typed && line.typed)
      makeSpecial(*sphere.typed, line.typed->point, line.typed->direction);
    else if (line.typed && point.typed)
      makeSpecial(*line.typed, point.typed->at);
    else if (line.typed)
      makeSpecial(*line.typed, plane.typed ? *plane.typed : PlaneObject{{0, 0, 0}, {0, 0, 1}});
  }

  /// A zero direction, through the origin, in the plane, parallel to it or perpendicular.
  void makeSpecial(LineObject &line, const PlaneObject &plane) {
    const int choice = integer(0, 6);
    if (choice == 0)
      line.direction = {0, 0, 0};
    if (choice == 1)
      line.point = line.direction * number();
    if (choice == 6)
      line.direction = plane.normal * number();
    if (choice >= 2 && choice < 6)
      line.direction = vectorAlongPlane(plane.normal);
    if (choice == 4 || choice == 5)
      line.point = plane.point + vectorAlongPlane(plane.normal);
  }

  /// Without a length, with an end in the plane, along the plane, in it, or through it in the middle.
  void makeSpecial(SegmentObject &segment, const PlaneObject &plane) {
    const ExactVec3 inPlane = plane.point + vectorAlongPlane(plane.normal);
    switch (integer(0, 6)) {
    case 0:
      segment.to = segment.from;
      break;
    case 1:
      segment.from = inPlane;
      break;
    case 2:
      segment.to = inPlane;
      break;
    case 3:
      segment.to = segment.from + vectorAlongPlane(plane.normal);
      break;
    case 4:
      segment = {inPlane, ExactVec3(inPlane + vectorAlongPlane(plane.normal))};
      break;
    default:
      segment.to = inPlane * Rational(2) - segment.from;
    }
  }

  /// Parallel, the same, meeting, perpendicular, or one without a direction.
  void makeSpecialLines(Object &first, Object &second) {
    const int choice = integer(0, 6);
    const Rational factor = integer(0, 1) == 0 ? Rational(-2) : Rational(3, 2);
    if (choice < 3)
      second[1] = first[1] * factor;
    if (choice == 1 || choice == 2 || choice == 3)
      second[0] = first[0] + first[1] * number();
    if (choice == 3)
      second[0] = second[0] + second[1] * number();
    if (choice == 4)
      second[1] = vectorAlongPlane(first[1]);
    if (choice == 6)
      first[1] = {0, 0, 0};
  }

  void makeSpecial(LineObject &line, ExactVec3 &point) {
    const int choice = integer(0, 3);
    if (choice == 0)
      line.direction = {0, 0, 0};
    if (choice == 1)
      point = line.point;
    if (choice == 2)
      point = line.point + line.direction * number();
  }

  /// Points of the line, at its ends, on its segment or elsewhere; a direction with zeros, where the second
  /// point mostly has the same coordinates as the line, or none at all.
  void makeSpecialWalk(Object &line, ExactVec3 &first, ExactVec3 &second) {
    ExactVec3 &direction = line[1];
    for (int axis = 0; axis < 3; ++axis)
      if (integer(0, 3) == 0)
        direction[axis] = 0;
    if (integer(0, 9) == 0)
      direction = {0, 0, 0};
    const auto steps = [&] { return integer(0, 1) == 0 ? Rational(integer(-1, 6), 4) : number(); };
    first = line[0] + direction * steps();
    if (integer(0, 1) == 0)
      second = line[0] + direction * steps();
    for (int axis = 0; axis < 3; ++axis)
      if (direction[axis] == 0 && integer(0, 2) != 0)
        second[axis] = line[0][axis];
  }

  /// Parallel, the same, one without a normal, perpendicular, or both with normals of the same length.
  void makeSpecialPair(Object &first, Object &second) {
    const int choice = integer(0, 4);
    const Rational factor = integer(0, 1) == 0 ? Rational(-2) : Rational(3, 2);
    if (choice < 2)
      second[1] = first[1] * factor;
    if (choice == 1)
      second[0] = first[0] + vectorAlongPlane(first[1]);
    if (choice == 2)
      first[1] = {0, 0, 0};
    if (choice == 3)
      second[1] = vectorAlongPlane(first[1]);
    if (choice == 4)
      second[1] = {first[1].y, first[1].z, Rational(-first[1].x)};
  }

  /// Without a single common point: with a normal that is zero, a sum of the others or a multiple of one or
  /// both; and then often with a point that brings them together.
  void makeSpecialPlanes(Object &first, Object &second, Object &third) {
    const auto factor = [&] { return Rational(integer(0, 1) == 0 ? -2 : 3); };
    const ExactVec3 along = cross(first[1], second[1]);
    switch (integer(0, 8)) {
    case 0:
      first[1] = {0, 0, 0};
      return;
    case 1:
      second[1] = {0, 0, 0};
      return;
    case 2: // all along one line
    case 3:
      second[1] = first[1] * factor();
      third[1] = first[1] * factor();
      second[0] = first[0] + vectorAlongPlane(first[1]) + first[1] * Rational(integer(0, 1));
      third[0] = first[0] + vectorAlongPlane(first[1]) + first[1] * Rational(integer(0, 1));
      return;
    case 4: // two of them
      third[1] = first[1] * factor();
      break;
    case 5:
      second[1] = third[1] * factor();
      second[0] = third[0] + vectorAlongPlane(third[1]) + third[1] * Rational(integer(0, 1));
      return;
    default:
      third[1] = first[1] * factor() + second[1];
    }
    if (integer(0, 1) == 0 && !isZero(along)) {
      const Plane<Rational> one = planeThrough(first[0], first[1]);
      const Plane<Rational> other = planeThrough(second[0], second[1]);
      const ExactVec3 moment = second[1] * one.offset - first[1] * other.offset;
      third[0] = nearestToOrigin(Line<Rational>{along, moment}) + along * number();
    }
  }

  /// One zero, along each other, perpendicular, or from one point.
  void makeSpecialVectors(Object &first, Object &second) {
    switch (integer(0, 5)) {
    case 0:
      first[1] = {0, 0, 0};
      break;
    case 1:
      second[1] = {0, 0, 0};
      break;
    case 2:
      second[1] = first[1] * number();
      break;
    case 3:
      second[1] = vectorAlongPlane(first[1]);
      break;
    default:
      second[0] = first[0];
    }
  }

  /// One zero, two along one line or all, in one plane, one of them perpendicular to the others, or from one
  /// point.
  void makeSpecialVectors(Object &first, Object &second, Object &third) {
    const std::array all{&first, &second, &third};
    const auto any = static_cast<std::size_t>(integer(0, 2));
    Object &one = *all.at(any);
    const Object &other = *all.at((any + 1) % 3);
    const Object &last = *all.at((any + 2) % 3);
    switch (integer(0, 7)) {
    case 0:
      one[1] = {0, 0, 0};
      break;
    case 1:
      one[1] = other[1] * number();
      break;
    case 2:
      second[1] = first[1] * Rational(integer(1, 3));
      third[1] = first[1] * Rational(-2);
      break;
    case 3:
    case 4:
      one[1] = other[1] * Rational(integer(1, 3)) - last[1];
      break;
    case 5:
    case 6:
      one[1] = cross(other[1], last[1]);
      break;
    default:
      second[0] = third[0] = first[0];
    }
  }

  void makeSpecial(PlaneObject &plane) {
    switch (integer(0, 5)) {
    case 0:
      plane.normal = {0, 0, 0};
      break;
    case 1:
      plane.normal = {0, 0, number()};
      break;
    case 2:
      plane.normal = {Rational(3, 5), 0, Rational(-4, 5)};
      break;
    case 3:
      plane.point = {0, 0, 0};
      break;
    default:
      break;
    }
  }

  /// Each of the planes may run along the ray, contain it, or go through its start.
  void makePlanesSpecial(std::vector<Object> &objects) {
    const auto ray = std::find_if(objects.begin(), objects.end(),
                                  [](const Object &object) { return kindOf(object) == RayObject::kind; });
    if (ray == objects.end())
      return;
    const ExactVec3 origin = (*ray)[0];
    const ExactVec3 direction = (*ray)[1];
    for (Object &object : objects) {
      if (kindOf(object) != PlaneObject::kind)
        continue;
      const int choice = integer(0, 7);
      if (choice < 2)
        object[1] = vectorAlongPlane(direction);
      if (choice == 1 || choice == 2)
        object[0] = origin;
    }
  }

  /// A point of the plane, its P0, or left as it is.
  void place(ExactVec3 &at, const PlaneObject &plane) {
    const int choice = integer(0, 2);
    if (choice == 0)
      at = plane.point;
    if (choice == 1)
      at = plane.point + vectorAlongPlane(plane.normal);
  }

  /// All in the plane, two of them, one alone, three on one line, or left as they are.
  void makePointsSpecial(std::vector<Object> &objects) {
    const auto plane = objectAs<PlaneObject>(objects[0]);
    if (!plane || objects.size() < 4 || kindOf(objects[1]) != PointObject::kind)
      return;
    const auto points = std::span(objects).subspan(1);
    const auto any = static_cast<std::size_t>(integer(0, static_cast<int>(points.size()) - 1));
    const int choice = integer(0, 9);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (choice == 0 || (choice == 1 && i != any) || (choice == 2 && i == any))
        points[i][0] = plane->point + vectorAlongPlane(plane->normal);
    if (choice == 3)
      points[2][0] = points[0][0] + (points[1][0] - points[0][0]) * number();
  }

  /// Of a plane, a lamp, three corners and sunlight: mostly all corners lit, between the lamp and the plane,
  /// and then perhaps on one line, in one plane with the lamp, along the sunlight, or with two equally high.
  /// Else light that is none or runs along the plane, and a lamp in it, at a corner, or level with one.
  void makeLightSpecial(std::vector<Object> &objects) {
    if (objects.size() != 6 || kindOf(objects[5]) != VectorObject::kind)
      return;
    const ExactVec3 at = objects[0][0];
    const ExactVec3 n = objects[0][1];
    ExactVec3 &lamp = objects[1][0];
    ExactVec3 &a = objects[2][0];
    ExactVec3 &b = objects[3][0];
    ExactVec3 &c = objects[4][0];
    ExactVec3 &sun = objects[5][1];
    const auto high = [&](int height) -> ExactVec3 {
      return at + vectorAlongPlane(n) + n * Rational(height);
    };
    const int choice = integer(0, 19);
    if (choice >= 10) {
      a = high(integer(0, 3));
      b = high(integer(0, 3));
      c = high(integer(0, 3));
      lamp = high(4);
      sun = vectorAlongPlane(n) - n * Rational(integer(1, 2));
    }
    switch (choice) {
    case 0:
      sun = {0, 0, 0};
      break;
    case 1:
      sun = vectorAlongPlane(n);
      break;
    case 2:
      lamp = at + vectorAlongPlane(n);
      break;
    case 3:
      a = lamp;
      break;
    case 4:
      b = lamp + vectorAlongPlane(n);
      break;
    case 5: // its midpoint level with the lamp
      b = lamp * Rational(2) - a + vectorAlongPlane(n);
      break;
    case 6:
      b = c = lamp;
      break;
    case 10:
      c = a + (b - a) * Rational(1, integer(2, 3));
      break;
    case 11:
      lamp = a * Rational(3) - b - c;
      break;
    case 12:
      sun = (c - a) + (c - b);
      break;
    case 13: // one shadow of two corners
      b = lamp + (a - lamp) * Rational(1, 2);
      break;
    case 14:
      b = a + vectorAlongPlane(n);
      break;
    default:
      break;
    }
  }

  void makeSpecial(RayObject &ray, const PlaneObject &plane) {
    place(ray.origin, plane);
    const int choice = integer(0, 3);
    if (choice == 0)
      ray.direction = {0, 0, 0};
    if (choice == 1)
      ray.direction = vectorAlongPlane(plane.normal);
    if (choice == 2)
      ray.direction = plane.normal;
  }

  void makeSpecial(TriangleObject &triangle, RayObject &ray) {
    const ExactVec3 u = triangle.p1 - triangle.p0;
    const ExactVec3 v = triangle.p2 - triangle.p0;
    // Thirds from −1 to 4/3: inside, outside, and on every edge and corner.
    const auto third = [&] { return Rational(integer(-1, 4), 3); };
    const ExactVec3 inPlane = triangle.p0 + u * third() + v * third();
    switch (integer(0, 8)) {
    case 0:
      triangle.p1 = triangle.p0;
      break;
    case 1:
      triangle.p2 = integer(0, 1) == 0 ? triangle.p0 : triangle.p1;
      break;
    case 2:
      triangle.p2 = triangle.p0 + u * number();
      break;
    case 3: // and where a formula that has lost signs is right by chance
      ray.direction = {0, 0, 0};
      if (const ExactVec3 n = cross(u, v); n.x != 0)
        ray.origin.x = dot(n, triangle.p0) / n.x;
      break;
    case 4:
      ray.direction = u * number() + v * number();
      break;
    case 5:
      ray = {inPlane, u * third() + v * third()};
      break;
    case 6:
      ray.origin = inPlane;
      break;
    default:
      ray.direction = ExactVec3(inPlane - ray.origin) * Rational(integer(0, 2) == 0 ? -1 : 2);
    }
  }

  /// Of three to eight corners: some of those of an octagon, stretched and turned in space.
  PolygonObject convexPolygon() {
    static constexpr std::array<std::array<int, 2>, 8> octagon{
        {{1, 0}, {2, 0}, {3, 1}, {3, 2}, {2, 3}, {1, 3}, {0, 2}, {0, 1}}};
    std::vector<std::array<int, 2>> places(octagon.begin(), octagon.end());
    for (int dropped = integer(0, 5); dropped > 0; --dropped)
      places.erase(places.begin() + integer(0, static_cast<int>(places.size()) - 1));
    const ExactVec3 start = vector();
    const ExactVec3 across = vector();
    const ExactVec3 up = vector();
    PolygonObject polygon;
    for (const auto &[x, y] : places)
      polygon.corners.push_back(start + across * Rational(x) + up * Rational(y));
    return polygon;
  }

  /// Where a ray can be aimed at: the middle of a polygon, a corner, a point of an edge, or one outside.
  ExactVec3 placeIn(const std::vector<ExactVec3> &corners) {
    const auto first = static_cast<std::size_t>(integer(0, static_cast<int>(corners.size()) - 1));
    const ExactVec3 &corner = corners[first];
    const ExactVec3 &next = corners[(first + 1) % corners.size()];
    const ExactVec3 middle =
        std::accumulate(corners.begin(), corners.end(), ExactVec3(0)) / Rational(int(corners.size()));
    const std::array places{middle, corner, ExactVec3(corner + (next - corner) * Rational(1, 3)),
                            ExactVec3(corner * Rational(2) - middle)};
    return places.at(static_cast<std::size_t>(integer(0, 3)));
  }

  void makeSpecial(std::vector<ExactVec3> &corners, RayObject &ray) {
    const ExactVec3 inPlane = placeIn(corners);
    const ExactVec3 along = (corners[1] - corners[0]) * number() + (corners[2] - corners[0]) * number();
    switch (integer(0, 9)) {
    case 0:
      ray.direction = {0, 0, 0};
      break;
    case 1:
      ray.direction = along;
      break;
    case 2:
      ray = {inPlane, along};
      break;
    case 3:
      corners.back() = integer(0, 1) == 0 ? corners[0] : corners[1];
      break;
    case 4: // a straight corner, bends, crossings
      corners[1] = inPlane;
      break;
    case 5: // not flat, when there are more than three
      corners.back() += vector();
      break;
    default:
      ray.direction = ExactVec3(inPlane - ray.origin) * Rational(integer(0, 2) == 0 ? -1 : 2);
    }
  }

  void giveConvexBase(Object &prism) {
    const std::vector<ExactVec3> corners = convexPolygon().corners;
    while (cornersOf(prism).size() < corners.size())
      prism.addVertex();
    std::size_t next = 0;
    for (const std::size_t corner : cornersOf(prism))
      prism[corner] = corners[next++];
  }

  /// Most boxes have an inside.
  static void giveLengths(Object &box) {
    for (std::size_t i = 1; i < box.size(); ++i)
      box[i].x = abs(box[i].x);
  }

  void givePixels(Object &screen) {
    for (std::size_t i = 3; i < screen.size(); ++i)
      screen[i].x = integer(1, 6);
  }

  /// A screen that is none, an eye in its plane, a point that is level with the eye or at it; else mostly a
  /// rectangle, and a point that is seen: in a corner of a pixel, in its middle, or elsewhere.
  void makeSpecialCamera(const ExactVec3 &eye, ScreenObject screen, std::vector<Object> &objects) {
    if (integer(0, 2) != 0)
      screen.v = vectorAlongPlane(screen.u);
    const auto half = [&](const Rational &most) {
      return Rational(integer(-1, 2 * static_cast<int>(toDouble(most)) + 1), 2);
    };
    const ExactVec3 onScreen = integer(0, 3) == 0 ? screen.at(Rational(1, 3), Rational(2, 3))
                                                  : screen.at(half(screen.w), half(screen.h));
    const auto along = [&] { return ExactVec3(screen.u * number() + screen.v * number()); };
    ExactVec3 point = eye + ExactVec3(onScreen - eye) * Rational(integer(1, 6), 2);
    switch (integer(0, 19)) {
    case 0:
      screen.v = screen.u * Rational(integer(-1, 1));
      break;
    case 1:
      screen.u = {0, 0, 0};
      break;
    case 2:
      objects[0] = PointObject{onScreen};
      break;
    case 3:
    case 4:
      point = eye + along();
      break;
    case 5:
      point = eye;
      break;
    case 6:
    case 7:
      point = eye - ExactVec3(onScreen - eye) * Rational(integer(1, 3));
      break;
    default:
      break;
    }
    objects[1] = screen;
    objects[2] = PointObject{point};
  }

  /// What a solid is not to be: flat, or bent.
  void spoil(Object &solid) {
    const std::vector<std::size_t> base = cornersOf(solid);
    const std::size_t last = solid.size() - 1;
    const auto isPrism = [&] { return !base.empty(); };
    switch (integer(0, 2)) {
    case 0:
      solid[1] = isPrism() ? solid[base[1]] - solid[base[0]] : solid[0];
      break;
    case 1:
      solid[last] = isPrism() ? solid[last] + vector() : ExactVec3(0);
      break;
    default:
      solid[last] = isPrism() ? (solid[base[0]] + solid[base[1]]) / Rational(2) : solid[0] + solid[1];
    }
    solid.kind().settle(solid);
  }

  void makeSpecialSolid(Object &solid, RayObject &ray) {
    const SolidMesh<Rational> mesh = meshOf(solid);
    const auto middleOf = [](const std::vector<ExactVec3> &corners) {
      return ExactVec3(std::accumulate(corners.begin(), corners.end(), ExactVec3(0)) /
                       Rational(static_cast<int>(corners.size())));
    };
    std::vector<ExactVec3> face;
    for (const std::uint32_t corner :
         mesh.faces[static_cast<std::size_t>(integer(0, static_cast<int>(mesh.faces.size()) - 1))])
      face.push_back(mesh.vertices[corner]);
    const ExactVec3 middle = middleOf(mesh.vertices);
    const ExactVec3 side = face[1] - face[0];
    switch (integer(0, 15)) {
    case 0:
      ray.direction = {0, 0, 0};
      break;
    case 1:
    case 2:
    case 3:
    case 4:
    case 5:
      spoil(solid);
      break;
    case 6:
      ray.origin = middle;
      break;
    case 7:
      ray.origin = placeIn(face);
      break;
    case 8: // along an edge
      ray = {face[0] + side * number(), side * Rational(integer(0, 1) == 0 ? -1 : 2)};
      break;
    case 9: // in a face
      ray.direction = middleOf(face) - face[0];
      ray.origin = face[0] + ray.direction * number();
      break;
    case 10: // mostly touching a corner alone
      ray.direction = cross(face[0] - middle, vector());
      ray.origin = face[0] + ray.direction * Rational(integer(-2, 2));
      break;
    default:
      ray.direction = ExactVec3(placeIn(face) - ray.origin) * Rational(integer(0, 2) == 0 ? -1 : 2);
    }
  }

  /// A frame of a minute, some between two and some before the first; a seed, 0 half of the time; the number
  /// of a fragment, or of none.
  NumberObject numberFor(const std::string &role) {
    constexpr int most = 1'000'000;
    NumberObject number{0, -most, most, 0};
    if (role == "frame")
      number.value = integer(0, 3) == 0 ? Rational(integer(-600, 600), 4) : Rational(25 * integer(0, 60));
    else if (role == "seed")
      number.value = integer(0, 1) * integer(1, 999);
    else
      number.value = Rational(integer(0, 30), integer(0, 9) == 0 ? 2 : 1);
    return number;
  }

  /// Few triangles: one, a square, a tetrahedron, three above each other, two of three that are none.
  void giveShape(Object &mesh) {
    using Corners = std::vector<Vec3<double>>;
    using Faces = std::vector<MeshFace>;
    static const std::array shapes{
        std::pair(Corners{{0, 0, 0}, {4, 0, 0}, {0, 3, 0.5}}, Faces{{0, 1, 2}}),
        std::pair(Corners{{-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}}, Faces{{0, 1, 2, 3}}),
        std::pair(Corners{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}},
                  Faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
        std::pair(Corners{{-3, -3, 0},
                          {3, -3, 0},
                          {0, 3, 0},
                          {-3, -3, 2},
                          {3, -3, 2},
                          {0, 3, 2},
                          {-3, -3, 2.5},
                          {3, -3, 2.5},
                          {0, 3, 2.5}},
                  Faces{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}),
        std::pair(Corners{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {0, 3, 0}},
                  Faces{{0, 1, 2}, {0, 1, 3}, {1, 1, 3}})};
    const auto &[corners, faces] = shapes.at(static_cast<std::size_t>(integer(0, shapes.size() - 1)));
    mesh.setShape(std::make_shared<const MeshShape>(corners, faces));
    static const std::vector<ExactVec3> headings{{3, 4, 0}, {-5, 12, 7}, {0, -2, 0}, {0, 0, 5}};
    if (const auto choice = static_cast<std::size_t>(integer(0, 7)); choice < headings.size())
      mesh[1] = headings[choice];
    mesh[2].x = length();
  }

  /// Some meshes stand twice where they are, and a ray is mostly aimed at one; i is often the number of what
  /// it is aimed at. Any of the meshes may be it, the last one most often.
  void makeMeshesSpecial(const Construction &construction, std::vector<Object> &objects) {
    const std::size_t first = construction.roles.size() - 1;
    if (construction.roles.back().kind != MeshObject::kind)
      return;
    const auto anyMesh = [&] {
      return static_cast<std::size_t>(integer(static_cast<int>(first), static_cast<int>(objects.size()) - 1));
    };
    if (integer(0, 7) == 0)
      objects[anyMesh()] = objects[anyMesh()];
    const std::size_t mesh = integer(0, 1) == 0 ? objects.size() - 1 : anyMesh();
    const MeshObject aimedAt = *objectAs<MeshObject>(objects[mesh]);
    const int fragment = integer(0, static_cast<int>(aimedAt.shape->triangleCount()) - 1);
    RayObject ray = *objectAs<RayObject>(objects.front());
    aim(ray, triangleOf(aimedAt, static_cast<std::size_t>(fragment)));
    objects.front() = ray;
    if (construction.roles[1].name != "i" || integer(0, 1) == 0)
      return;
    objects[1][0].x = fragment + 1;
    for (std::size_t before = first; before < mesh; ++before)
      objects[1][0].x += objectAs<MeshObject>(objects[before])->shape->triangleCount();
  }

  /// At the middle of a triangle, a corner, an edge or beside it; from there, away from it, along it, in it.
  void aim(RayObject &ray, const Triangle<Rational> &triangle) {
    const auto &[p0, p1, p2] = triangle;
    const auto third = [&] { return Rational(integer(-1, 4), 3); };
    const ExactVec3 u = p1 - p0;
    const ExactVec3 v = p2 - p0;
    const std::array<ExactVec3, 4> places{p0 + (u + v) / Rational(3), p1, p0 + u / Rational(3),
                                          p0 + u * third() + v * third()};
    const ExactVec3 target = places.at(static_cast<std::size_t>(integer(0, 3)));
    switch (integer(0, 11)) {
    case 0:
      ray.direction = {0, 0, 0};
      break;
    case 1:
      ray.direction = u * number() + v * number();
      break;
    case 2:
      ray = {target, u * number() + v * number()};
      break;
    case 3:
      ray.origin = target;
      break;
    case 4:
    case 5:
      ray.direction = ray.origin - target;
      break;
    default:
      ray.direction = (target - ray.origin) * Rational(2, integer(1, 3));
    }
  }

  /// A barrel that points nowhere, or has no length, or whose arrow's length is a fraction; a saucer that
  /// stands still.
  void makeSpecial(UfoObject &ufo) {
    ufo.barrelLength = abs(length());
    switch (integer(0, 5)) {
    case 0:
      ufo.barrel = {0, 0, 0};
      break;
    case 3:
      ufo.barrelLength = 0;
      break;
    case 1:
      ufo.barrel = ExactVec3(2, 1, -2) * length();
      break;
    case 2:
      ufo.velocity = {0, 0, 0};
      break;
    default:
      ufo.barrel = ExactVec3(0, 3, -4) / length();
    }
  }

  /// A length ≠ 0.
  Rational length() {
    const Rational any = abs(number());
    return any == 0 ? Rational(1) : any;
  }

  /// Of a sphere and a line, or that of a ray, from a point along a direction.
  void makeSpecial(SphereObject &sphere, ExactVec3 &start, ExactVec3 &direction) {
    // Three arrows square to each other, all as long as 3.
    const ExactVec3 along(1, 2, 2);
    const ExactVec3 aside(2, 1, -2);
    const auto startAt = [&](const Rational &asideShare, const Rational &alongShare) {
      start = sphere.center + aside * asideShare + along * alongShare;
    };
    switch (integer(0, 7)) {
    case 0:
      sphere.radius = 0;
      break;
    case 1:
      direction = {0, 0, 0};
      break;
    case 2: // touching
      direction = along * number();
      sphere.radius = length();
      startAt(Rational(sphere.radius / 3), number());
      break;
    case 3: // roots without roots: sides of 3, 4 and 5
      direction = along * number();
      sphere.radius = 5 * length();
      startAt(Rational(sphere.radius / 5), number());
      break;
    case 4: // starting on it
      sphere.radius = 3 * length();
      startAt(0, Rational(sphere.radius / -3));
      break;
    case 5: // through the centre, perhaps from there
      start = sphere.center + direction * Rational(integer(-2, 2));
      break;
    case 6: // from inside
      start = sphere.center + ExactVec3(sphere.radius / 3, 0, sphere.radius / 3);
      break;
    default:
      direction = ExactVec3(sphere.center - start) + vector() / Rational(9);
    }
  }

  /// Cut by the plane, touched, through the centre, or a point.
  void makeSpecial(SphereObject &sphere, PlaneObject &plane) {
    const ExactVec3 arrow(1, 2, 2); // 3 long
    switch (integer(0, 7)) {
    case 0:
      sphere.radius = 0;
      break;
    case 1:
      sphere.radius = 0;
      sphere.center = plane.point + vectorAlongPlane(plane.normal);
      break;
    case 2:
    case 3:
      sphere.center = plane.point + vectorAlongPlane(plane.normal);
      break;
    case 4:
    case 5: { // the distance and the radius are fractions, and mostly the same
      plane.normal = arrow * length();
      const Rational steps = integer(0, 1) == 0 ? length() : Rational(-length());
      sphere.center = plane.point + vectorAlongPlane(arrow) + arrow * steps;
      sphere.radius = 3 * abs(steps) + (integer(0, 3) == 0 ? 1 : 0);
      break;
    }
    default:
      break;
    }
  }

  /// Two of four points are one, three lie on a line, all on a line, in a plane or on a circle; or their
  /// sphere has a fraction for its radius.
  void makeSpecialFour(ExactVec3 &a, ExactVec3 &b, ExactVec3 &c, ExactVec3 &d) {
    const ExactVec3 u = b - a;
    switch (integer(0, 9)) {
    case 0:
      d = a;
      break;
    case 1:
      c = b;
      break;
    case 2:
      c = a + u * number();
      break;
    case 3:
      c = a + u * number();
      d = a + u * number();
      break;
    case 4:
      d = a + u * number() + (c - a) * number();
      break;
    case 5:
      c = a + vectorAlongPlane(u);
      d = c + u;
      break;
    case 6:
      c = b;
      d = integer(0, 1) == 0 ? a : b;
      break;
    default: {
      const ExactVec3 center = a;
      const Rational factor = length();
      a = center + ExactVec3(1, 2, 2) * factor;
      b = center + ExactVec3(2, 1, -2) * factor;
      c = center + ExactVec3(2, -2, 1) * factor;
      d = center - ExactVec3(1, 2, 2) * factor;
    }
    }
  }

  void makeSpecialSolid(Object &solid) {
    if (kindOf(solid) == "tetrahedron")
      makeSpecialFour(solid[0], solid[1], solid[2], solid[3]);
    else if (integer(0, 1) == 0)
      spoil(solid);
  }

  /// Corners that are one point or lie on a line, a straight one, crossing edges, not in one plane.
  void makeSpecialPolygon(Object &polygon) {
    const std::size_t last = polygon.size() - 1;
    const ExactVec3 side = polygon[1] - polygon[0];
    switch (integer(0, 7)) {
    case 0:
      polygon[last] = polygon[static_cast<std::size_t>(integer(0, 1))];
      break;
    case 1:
      polygon[1] = (polygon[0] + polygon[2]) / Rational(2);
      break;
    case 2:
      std::swap(polygon[1], polygon[2]);
      break;
    case 3:
      polygon[last] += vector();
      break;
    case 4:
      for (std::size_t i = 2; i <= last; ++i)
        polygon[i] = polygon[0] + side * number();
      break;
    case 5: // bent inwards
      polygon[last] =
          polygon[0] + (polygon[1] - polygon[0]) / Rational(3) + (polygon[2] - polygon[0]) / Rational(3);
      break;
    default:
      break;
    }
  }

  /// A point of the plane, at thirds from −1 to 4/3, or a triangle that is none.
  void makeSpecial(TriangleObject &triangle, ExactVec3 &point) {
    const ExactVec3 u = triangle.p1 - triangle.p0;
    const ExactVec3 v = triangle.p2 - triangle.p0;
    const auto third = [&] { return Rational(integer(-1, 4), 3); };
    switch (integer(0, 9)) {
    case 0:
      triangle.p2 = integer(0, 1) == 0 ? triangle.p0 : triangle.p1;
      break;
    case 1:
      triangle.p2 = triangle.p0 + u * number();
      break;
    case 2:
      point = std::array{triangle.p0, triangle.p1, triangle.p2}.at(static_cast<std::size_t>(integer(0, 2)));
      break;
    default:
      point = triangle.p0 + u * third();
      point += v * third();
    }
  }

  /// No triangle: corners that are one point, two of them or all, or that lie on one line in any order.
  void makeSpecial(TriangleObject &triangle) {
    switch (integer(0, 5)) {
    case 0:
      triangle.p1 = triangle.p0;
      break;
    case 1:
      triangle.p2 = triangle.p0;
      break;
    case 2:
      triangle.p2 = triangle.p1;
      break;
    case 3:
      triangle.p1 = triangle.p2 = triangle.p0;
      break;
    default:
      triangle.p2 = triangle.p0 + (triangle.p1 - triangle.p0) * number();
    }
  }

  std::mt19937_64 m_engine;
  Writing m_writing = Writing::SmallIntegers;
};

} // namespace halfspace::test
