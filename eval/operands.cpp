#include "eval/operands.h"

namespace halfspace {
namespace {

/// A form that an operand does not have: thrown up to the operand's reader, which names the operand.
struct Malformed {
  std::string words;
};

// --- The parts of operands: each throws Malformed

Rational numberFrom(const JsonValue &value) {
  std::optional<Rational> number;
  if (value.kind() == JsonKind::Number)
    number = parseDecimal(value.spelling());
  else if (value.kind() == JsonKind::String)
    number = parseFraction(value.text());
  else
    throw Malformed{"a number is wanted"};
  if (!number)
    throw Malformed{value.kind() == JsonKind::Number
                        ? "a number has more than 200 digits, or an exponent beyond 400"
                        : "a text is no fraction p/q of integers with at most 200 digits and q not zero"};
  return *number;
}

std::vector<JsonValue> listFrom(const JsonValue &value, const char *wanted) {
  if (value.kind() != JsonKind::List)
    throw Malformed{wanted};
  return value.elements();
}

ExactVec3 vectorFrom(const JsonValue &value) {
  constexpr auto wanted = "a list of three numbers is wanted";
  const auto numbers = listFrom(value, wanted);
  if (numbers.size() != 3)
    throw Malformed{wanted};
  return {numberFrom(numbers[0]), numberFrom(numbers[1]), numberFrom(numbers[2])};
}

Polygon<Rational> pointsFrom(const JsonValue &value, const char *wanted) {
  Polygon<Rational> points;
  for (const JsonValue &point : listFrom(value, wanted))
    points.push_back(vectorFrom(point));
  return points;
}

Polygon<Rational> pointsFrom(const JsonValue &value, std::size_t count, const char *wanted) {
  Polygon<Rational> points = pointsFrom(value, wanted);
  if (points.size() != count)
    throw Malformed{wanted};
  return points;
}

Triangle<Rational> triangleFrom(const JsonValue &value) {
  const auto points = pointsFrom(value, 3, "a list of three points is wanted");
  return {points[0], points[1], points[2]};
}

Plane<Rational> planeFrom(const JsonValue &value, bool &fromPoints) {
  fromPoints = value.hasExactly({"points"});
  if (fromPoints) {
    const auto points = pointsFrom(*value.find("points"), 3, "a list of three points is wanted");
    return planeThrough(points[0], points[1], points[2]);
  }
  if (value.hasExactly({"point", "normal"}))
    return planeThrough(vectorFrom(*value.find("point")), vectorFrom(*value.find("normal")));
  if (!value.hasExactly({"coefficients"}))
    throw Malformed{"a point and a normal, coefficients, or points are wanted, and nothing else"};
  constexpr auto wanted = "a list of four numbers is wanted";
  const auto numbers = listFrom(*value.find("coefficients"), wanted);
  if (numbers.size() != 4)
    throw Malformed{wanted};
  return {{numberFrom(numbers[0]), numberFrom(numbers[1]), numberFrom(numbers[2])}, numberFrom(numbers[3])};
}

Ray<Rational> rayFrom(const JsonValue &value) {
  if (!value.hasExactly({"origin", "direction"}))
    throw Malformed{"an origin and a direction are wanted, and nothing else"};
  return {vectorFrom(*value.find("origin")), vectorFrom(*value.find("direction"))};
}

Line<Rational> lineFrom(const JsonValue &value, bool &fromPlucker) {
  fromPlucker = value.hasExactly({"plucker"});
  if (value.hasExactly({"point", "direction"}))
    return lineAlong(vectorFrom(*value.find("point")), vectorFrom(*value.find("direction")));
  if (value.hasExactly({"through"})) {
    const auto points = pointsFrom(*value.find("through"), 2, "a list of two points is wanted");
    return lineThrough(points[0], points[1]);
  }
  if (!fromPlucker)
    throw Malformed{"a point and a direction, through, or plucker are wanted, and nothing else"};
  const JsonValue six = *value.find("plucker");
  if (!six.hasExactly({"direction", "moment"}))
    throw Malformed{"a direction and a moment are wanted, and nothing else"};
  return {vectorFrom(*six.find("direction")), vectorFrom(*six.find("moment"))};
}

std::uint32_t indexFrom(const JsonValue &value, std::size_t count) {
  const Rational number = numberFrom(value);
  if (!number.isInteger() || number < 0 || number >= count)
    throw Malformed{"an index is that of no vertex"};
  return static_cast<std::uint32_t>(number.words()->numerator);
}

SolidMesh<Rational> meshFrom(const JsonValue &value) {
  constexpr std::size_t fewest = 4;
  if (!value.hasExactly({"vertices", "faces"}))
    throw Malformed{"vertices and faces are wanted, and nothing else"};
  SolidMesh<Rational> mesh;
  mesh.vertices = pointsFrom(*value.find("vertices"), "a list of at least four points is wanted");
  for (const JsonValue &face : listFrom(*value.find("faces"), "a list of faces is wanted")) {
    auto &indices = mesh.faces.emplace_back();
    for (const JsonValue &index : listFrom(face, "a face is a list of at least three indices"))
      indices.push_back(indexFrom(index, mesh.vertices.size()));
    if (indices.size() < 3)
      throw Malformed{"a face is a list of at least three indices"};
  }
  if (mesh.vertices.size() < fewest || mesh.faces.size() < fewest)
    throw Malformed{"a solid has at least four vertices and four faces"};
  return mesh;
}

std::string degenerateWords(TriangleShape shape) {
  return shape == TriangleShape::Coincident ? "two of its points coincide" : "its points lie on one line";
}

} // namespace

// --- The operands

void Operands::refuse(FaultCode code, const std::string &message) {
  if (!m_fault || code < m_fault->code)
    m_fault = Fault{code, message};
}

/// What `from` makes of an operand; nothing, and the fault noted, where it is missing or malformed.
template <class From> auto Operands::read(const std::string &name, From from) {
  std::optional<decltype(from(m_question))> result;
  if (const auto value = m_question.find(name)) {
    try {
      result = from(*value);
    } catch (const Malformed &malformed) {
      refuse(FaultCode::BadOperand,
             "The operand " + name + " is not of a listed form: " + malformed.words + ".");
    }
  } else {
    refuse(FaultCode::MissingOperand, "The operand " + name + " is not there.");
  }
  return result;
}

Rational Operands::number(const std::string &name) { return read(name, numberFrom).value_or(0); }

ExactVec3 Operands::vector(const std::string &name) { return read(name, vectorFrom).value_or(ExactVec3()); }

ExactVec3 Operands::direction(const std::string &name) {
  const auto vector = read(name, vectorFrom);
  if (vector && isZero(*vector))
    refuse(FaultCode::ZeroVector, "The vector " + name + " is zero.");
  return vector.value_or(ExactVec3());
}

Plane<Rational> Operands::plane(const std::string &name) {
  bool fromPoints = false;
  const auto plane = read(name, [&](const JsonValue &value) { return planeFrom(value, fromPoints); });
  if (plane && isZero(plane->normal)) {
    if (fromPoints)
      refuse(FaultCode::CollinearPoints, "The three points of " + name + " lie on one line.");
    else
      refuse(FaultCode::ZeroNormal, "The normal of " + name + " is zero.");
  }
  return plane.value_or(Plane<Rational>());
}

Ray<Rational> Operands::ray(const std::string &name) {
  const auto ray = read(name, rayFrom);
  if (ray && isZero(ray->direction))
    refuse(FaultCode::ZeroVector, "The direction of " + name + " is zero.");
  return ray.value_or(Ray<Rational>());
}

Line<Rational> Operands::line(const std::string &name) {
  bool fromPlucker = false;
  const auto line = read(name, [&](const JsonValue &value) { return lineFrom(value, fromPlucker); });
  if (line && !fromPlucker && isZero(line->direction))
    refuse(FaultCode::ZeroVector, "The direction of " + name + " is zero.");
  return line.value_or(Line<Rational>());
}

Line<Rational> Operands::realLine(const std::string &name) {
  Line<Rational> line = this->line(name);
  if (!isReal(line))
    refuse(FaultCode::NotALine, "The Plücker coordinates of " + name + " are not those of a line.");
  return line;
}

Triangle<Rational> Operands::triangle(const std::string &name) {
  const auto triangle = read(name, triangleFrom);
  if (triangle)
    if (const TriangleShape shape = shapeOf(*triangle); shape != TriangleShape::Proper)
      refuse(FaultCode::DegenerateTriangle, "The triangle is degenerate: " + degenerateWords(shape) + ".");
  return triangle.value_or(Triangle<Rational>());
}

std::vector<Triangle<Rational>> Operands::triangles(const std::string &name) {
  return read(name,
              [](const JsonValue &value) {
                std::vector<Triangle<Rational>> triangles;
                for (const JsonValue &triangle : listFrom(value, "a list of triangles is wanted"))
                  triangles.push_back(triangleFrom(triangle));
                return triangles;
              })
      .value_or(std::vector<Triangle<Rational>>());
}

Sphere<Rational> Operands::sphere(const std::string &name) {
  return read(name,
              [](const JsonValue &value) -> Sphere<Rational> {
                if (!value.hasExactly({"center", "radius"}))
                  throw Malformed{"a center and a radius are wanted, and nothing else"};
                Sphere<Rational> sphere{vectorFrom(*value.find("center")), numberFrom(*value.find("radius"))};
                if (sphere.radius <= 0)
                  throw Malformed{"the radius is not positive"};
                return sphere;
              })
      .value_or(Sphere<Rational>{{}, 1});
}

Polygon<Rational> Operands::polygon(const std::string &name) {
  const auto corners = read(name, [](const JsonValue &value) {
    constexpr auto wanted = "a list of at least three points is wanted";
    auto points = pointsFrom(value, wanted);
    if (points.size() < 3)
      throw Malformed{wanted};
    return points;
  });
  if (!corners)
    return {};
  const PolygonShape shape = shapeOf(*corners);
  if (shape == PolygonShape::NotPlanar)
    refuse(FaultCode::NotPlanar, "The corners of the polygon do not lie in one plane.");
  if (shape == PolygonShape::NotConvex)
    refuse(FaultCode::NotConvex, "The polygon is not convex, or a corner of it is straight or stands twice.");
  return *corners;
}

ConvexSolid<Rational> Operands::solid(const std::string &name) {
  const auto mesh = read(name, meshFrom);
  if (!mesh)
    return {};
  switch (shapeOf(*mesh)) {
  case SolidShape::NotPlanar:
    refuse(FaultCode::NotPlanar, "The corners of a face of the solid do not lie in one plane.");
    break;
  case SolidShape::NotConvex:
    refuse(FaultCode::NotConvex,
           "The solid or a face of it is not convex, or a face is not counterclockwise seen from outside.");
    break;
  case SolidShape::NotClosed:
    refuse(FaultCode::NotClosed, "The solid is not closed: an edge is not shared by two faces.");
    break;
  case SolidShape::Convex:
    return solidOf(*mesh);
  }
  return {};
}

} // namespace halfspace
