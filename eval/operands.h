// The operands of a question, read from its JSON object.
#pragma once

#include "eval/fault.h"
#include "eval/json_line.h"
#include "geometry/line.h"
#include "geometry/plane.h"
#include "geometry/polygon.h"
#include "geometry/ray.h"
#include "geometry/solid_shape.h"
#include "geometry/sphere.h"
#include "geometry/triangle.h"

#include <optional>
#include <string>
#include <vector>

namespace halfspace {

using ExactVec3 = Vec3<Rational>;

/// Reads the operands of one question by their names. What is missing, malformed or degenerate is noted, and
/// a value of no meaning handed out in its place: a query reads all that it needs, then asks for the fault.
class Operands {
public:
  explicit Operands(JsonValue question) : m_question(question) {}

  Rational number(const std::string &name);
  ExactVec3 vector(const std::string &name);
  /// Like `vector`, but a zero vector is a fault.
  ExactVec3 direction(const std::string &name);
  Plane<Rational> plane(const std::string &name);
  Ray<Rational> ray(const std::string &name);
  /// A line that may be given by any Plücker coordinates.
  Line<Rational> line(const std::string &name);
  /// Like `line`, but coordinates of no real line are a fault.
  Line<Rational> realLine(const std::string &name);
  /// A degenerate triangle is a fault.
  Triangle<Rational> triangle(const std::string &name);
  /// Any triangles, degenerate or not.
  std::vector<Triangle<Rational>> triangles(const std::string &name);
  Sphere<Rational> sphere(const std::string &name);
  /// At least three corners; a polygon that is not planar and convex is a fault.
  Polygon<Rational> polygon(const std::string &name);
  /// A solid that is not convex and closed is a fault.
  ConvexSolid<Rational> solid(const std::string &name);

  /// The fault with the first code, if there was any.
  [[nodiscard]] const std::optional<Fault> &fault() const { return m_fault; }

private:
  template <class From> auto read(const std::string &name, From from);
  void refuse(FaultCode code, const std::string &message);

  JsonValue m_question;
  std::optional<Fault> m_fault;
};

} // namespace halfspace
