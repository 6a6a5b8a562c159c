#include "lessons/discovery/spatial_object.h"

#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/polygon.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/sphere.h"
#include "lessons/object/kinds/triangle.h"
#include "lessons/object/kinds/vector.h"

namespace halfspace {
namespace {

Rational squareOf(const ExactVec3 &vector) { return dot(vector, vector); }

bool isFlat(Form form) { return form == Form::Plane || form == Form::Face; }

/// Something with a direction or a normal; nothing where that is zero.
std::optional<SpatialObject> directed(Form form, const ExactVec3 &at, const ExactVec3 &way) {
  return isZero(way) ? std::nullopt : std::optional(SpatialObject{form, at, way});
}

/// The plane of corners; nothing where they have none, or several.
std::optional<SpatialObject> planeOfCorners(Form form, const Object &object) {
  const ExactVec3 normal = cross(object[1] - object[0], object[2] - object[0]);
  for (std::size_t corner = 3; corner < object.size(); ++corner)
    if (dot(normal, object[corner] - object[0]) != 0)
      return {};
  return directed(form, object[0], normal);
}

} // namespace

std::optional<SpatialObject> spatialOf(const Object &object) {
  const std::string_view kind = kindOf(object);
  if (kind == PointObject::kind)
    return SpatialObject{Form::Point, object[0]};
  if (kind == VectorObject::kind)
    return directed(Form::Vector, ExactVec3(0), object[1]);
  if (kind == LineObject::kind)
    return directed(Form::Line, object[0], object[1]);
  if (kind == RayObject::kind)
    return directed(Form::Ray, object[0], object[1]);
  if (kind == "segment")
    return directed(Form::Segment, object[0], object[1] - object[0]);
  if (kind == PlaneObject::kind)
    return directed(Form::Plane, object[0], object[1]);
  if (kind == "plane-through-points")
    return planeOfCorners(Form::Plane, object);
  if (kind == TriangleObject::kind || kind == PolygonObject::kind)
    return planeOfCorners(Form::Face, object);
  if (kind == SphereObject::kind && object[1].x > 0)
    return SpatialObject{Form::Sphere, object[0], ExactVec3(0), object[1].x};
  if (kind == NumberObject::kind)
    return SpatialObject{Form::Number, ExactVec3(0), ExactVec3(0), object[0].x};
  return {};
}

std::optional<SpatialObject> lineThrough(const SpatialObject &from, const SpatialObject &to) {
  return directed(Form::Line, from.at, to.at - from.at);
}

bool areParallel(const SpatialObject &a, const SpatialObject &b) {
  return isFlat(a.form) == isFlat(b.form) ? isZero(cross(a.way, b.way)) : dot(a.way, b.way) == 0;
}

bool arePerpendicular(const SpatialObject &a, const SpatialObject &b) {
  return isFlat(a.form) == isFlat(b.form) ? dot(a.way, b.way) == 0 : isZero(cross(a.way, b.way));
}

bool contains(const SpatialObject &object, const ExactVec3 &place) {
  return object.form == Form::Sphere ? squareOf(place - object.at) == object.number * object.number
                                     : squaredDistance(place, object) == 0;
}

bool contains(const SpatialObject &outer, const SpatialObject &inner) {
  return areParallel(outer, inner) && contains(outer, inner.at);
}

Rational squaredDistance(const ExactVec3 &place, const SpatialObject &object) {
  const ExactVec3 between = place - object.at;
  if (object.form == Form::Point)
    return squareOf(between);
  const Rational square = squareOf(object.way);
  if (!isFlat(object.form))
    return squareOf(cross(between, object.way)) / square;
  const Rational along = dot(between, object.way);
  return along * along / square;
}

std::optional<ExactVec3> meetingPoint(const SpatialObject &a, const SpatialObject &b) {
  const ExactVec3 common = cross(a.way, b.way);
  if (isZero(common))
    return {};
  const Rational along = dot(cross(b.at - a.at, b.way), common) / squareOf(common);
  const ExactVec3 place = a.at + a.way * along;
  return contains(b, place) ? std::optional(place) : std::nullopt;
}

} // namespace halfspace
