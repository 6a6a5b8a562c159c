#include "lessons/object/kinds/polygon.h"
#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

#include <numeric>

namespace halfspace::test {
namespace {

using Corners = std::vector<ExactVec3>;

ExactVec3 edgeOf(const Corners &corners, std::size_t i) {
  return corners[(i + 1) % corners.size()] - corners[i];
}

/// Twice the area vector.
ExactVec3 areaOf(const Corners &corners) {
  ExactVec3 area{0, 0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += perpendicular(corners[i], corners[(i + 1) % corners.size()]);
  return area;
}

bool isPlanar(const Corners &corners) {
  for (const ExactVec3 &a : corners)
    for (const ExactVec3 &b : corners)
      for (const ExactVec3 &c : corners)
        if (determinant(a - corners[0], b - corners[0], c - corners[0]) != 0)
          return false;
  return true;
}

/// Seen from each edge all other corners lie to its left.
bool isConvex(const Corners &corners) {
  const ExactVec3 area = areaOf(corners);
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t k = 2; k < corners.size(); ++k)
      if (determinant(area, edgeOf(corners, i), corners[(i + k) % corners.size()] - corners[i]) <= 0)
        return false;
  return true;
}

/// The volumes between the ray's direction and the ways from its start to the ends of each edge.
std::vector<Rational> productsOf(const Corners &corners, const RayObject &ray) {
  std::vector<Rational> products;
  for (std::size_t i = 0; i < corners.size(); ++i)
    products.push_back(
        determinant(ray.direction, corners[i] - ray.origin, corners[(i + 1) % corners.size()] - ray.origin));
  return products;
}

/// Where a point of the plane lies, by the areas that it makes with the edges.
void locate(const Corners &corners, const ExactVec3 &point, Recomputed &expected) {
  std::vector<int> zero;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Rational area = determinant(areaOf(corners), edgeOf(corners, i), point - corners[i]);
    if (area < 0) {
      expected.values["location"] = "outside";
      return;
    }
    if (area == 0)
      zero.push_back(static_cast<int>(i));
  }
  expected.values["location"] = zero.empty() ? "interior" : zero.size() == 1 ? "edge" : "vertex";
  if (zero.size() == 1)
    expected.values["feature"] = zero.front();
  if (const auto corner = std::find(corners.begin(), corners.end(), point); corner != corners.end())
    expected.values["feature"] = static_cast<int>(corner - corners.begin());
}

void addWeights(const Corners &corners, const ExactVec3 &point, Recomputed &expected) {
  const ExactVec3 area = areaOf(corners);
  const auto weight = [&](std::size_t edge) -> Rational {
    return determinant(area, edgeOf(corners, edge), point - corners[edge]) / product(area, area);
  };
  expected.values["barycentric"] = numbers({weight(1), weight(2), weight(0)});
  expected.names["\\rho"] = quantity(weight(1));
  expected.names["\\sigma"] = quantity(weight(2));
  expected.names["\\tau"] = quantity(weight(0));
}

void recomputeMeeting(const Corners &corners, const RayObject &ray, Recomputed &expected) {
  const ExactVec3 normal =
      perpendicular(ExactVec3(corners[1] - corners[0]), ExactVec3(corners[2] - corners[0]));
  expected.names["\\vec n"] = quantity(normal);
  const Rational along = product(normal, ray.direction);
  const Rational away = product(normal, ExactVec3(corners[0] - ray.origin));
  if (along == 0) {
    expected.caseName = away == 0 ? "in-plane" : "parallel";
    return;
  }
  const Rational t = away / along;
  const ExactVec3 point = ray.origin + ray.direction * t;
  locate(corners, point, expected);
  const bool isOutside = std::get<std::string>(expected.values["location"]) == "outside";
  expected.caseName = isOutside ? "miss" : t < 0 ? "behind" : "hit";
  expected.values["t"] = number(t);
  expected.values["point"] = numbers(point);
  expected.names["t"] = quantity(t);
  expected.names["I"] = quantity(point);
  if (corners.size() == 3)
    addWeights(corners, point, expected);
}

/// The edge whose product beats those of all others, each with its sign squared away.
void addLargest(const std::vector<Rational> &products, Recomputed &expected) {
  for (std::size_t i = 0; i < products.size(); ++i) {
    const auto beatsOther = [&](const Rational &other) {
      return &other == &products[i] || other * other < products[i] * products[i];
    };
    if (std::all_of(products.begin(), products.end(), beatsOther))
      expected.values["largest_edge"] = static_cast<int>(i);
  }
}

void recomputeProducts(const Corners &corners, const RayObject &ray, Recomputed &expected) {
  expected.names = {{"Q", quantity(ray.origin)},
                    {"\\vec r", quantity(ray.direction)},
                    {"\\vec m", quantity(perpendicular(ray.origin, ray.direction))}};
  const auto products = productsOf(corners, ray);
  SignedSquares list;
  Rational sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::string index = std::to_string(i);
    list.push_back(signedSquare(products[i]));
    sum += products[i];
    expected.names["P_" + index] = quantity(corners[i]);
    expected.names["\\vec e_" + index] = quantity(edgeOf(corners, i));
    expected.names["\\vec m_" + index] = quantity(perpendicular(corners[i], edgeOf(corners, i)));
    expected.names["p_" + index] = quantity(products[i]);
    if (vanishes(edgeOf(corners, i)))
      expected.vanished.insert("it.p" + index);
  }
  const auto [least, most] = std::minmax_element(products.begin(), products.end());
  const char *signs = *least == 0 && *most == 0 ? "zero" : *least < 0 && *most > 0 ? "mixed" : "same";
  expected.values = {{"products", list}, {"sum", number(sum)}, {"signs", signs}};
  expected.names["S"] = quantity(sum);
  addLargest(products, expected);
}

Recomputed recompute(Objects objects) {
  const Corners corners = objectAs<PolygonObject>(*objects[0]).value().corners;
  const auto ray = objectAs<RayObject>(*objects[1]).value();
  Recomputed expected;
  recomputeProducts(corners, ray, expected);
  if (vanishes(ray.direction)) {
    expected.vanished.insert("L.r");
    expected.caseName = "zero-direction";
  } else if (!isPlanar(corners)) {
    expected.caseName = "not-planar";
  } else if (!isConvex(corners)) {
    expected.caseName = "not-convex";
  } else {
    recomputeMeeting(corners, ray, expected);
    return expected;
  }
  expected.degenerate = true;
  // The normal has a meaning without a ray.
  expected.names["\\vec n"] =
      quantity(perpendicular(ExactVec3(corners[1] - corners[0]), ExactVec3(corners[2] - corners[0])));
  return expected;
}

/// d₁·m₂ + d₂·m₁ of the ray and an edge.
void addPermuted(std::vector<WrongAnswer> &all, const Corners &corners, std::size_t i, const RayObject &ray) {
  const ExactVec3 edge = edgeOf(corners, i);
  const ExactVec3 moment = perpendicular(ray.origin, ray.direction);
  const ExactVec3 edgeMoment = perpendicular(corners[i], edge);
  const Rational first = times(ray.direction, edgeMoment);
  const Rational second = times(edge, moment);
  const std::string id = "edge" + std::to_string(i);
  Line line(id, Rational(first + second), all);
  line.add("only the first product", first);
  line.add("only the second product", second);
  line.add("subtracted", Rational(first - second));
  line.add("not crossed over", Rational(times(ray.direction, edge) + times(moment, edgeMoment)));
  line.add("each with its own moment", Rational(times(ray.direction, moment) + times(edge, edgeMoment)));
  line.add("the sign lost", Rational(-first - second));
}

void addSum(std::vector<WrongAnswer> &all, const std::vector<Rational> &products) {
  const Rational sum = std::accumulate(products.begin(), products.end(), Rational(0));
  Line line("sum", sum, all);
  line.add("the sign lost", Rational(-sum));
  for (const Rational &product : products) {
    line.add("one product dropped", Rational(sum - product));
    line.add("one product subtracted", Rational(sum - 2 * product));
  }
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Corners corners = objectAs<PolygonObject>(*objects[0]).value().corners;
  const auto ray = objectAs<RayObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  if (vanishes(ray.direction) || !isPlanar(corners) || !isConvex(corners))
    return all;
  const auto products = productsOf(corners, ray);
  for (std::size_t i = 0; i < corners.size(); ++i)
    addPermuted(all, corners, i, ray);
  addSum(all, products);
  const ExactVec3 normal =
      perpendicular(ExactVec3(corners[1] - corners[0]), ExactVec3(corners[2] - corners[0]));
  if (times(normal, ray.direction) == 0)
    return all;
  addParameter(all, "t", normal, corners[0], ray);
  if (corners.size() != 3)
    return all;
  const Rational sum = std::accumulate(products.begin(), products.end(), Rational(0));
  for (const auto &[id, edge] : {std::pair("rho", 1U), std::pair("sigma", 2U), std::pair("tau", 0U)}) {
    Line line(id, Rational(products[edge] / sum), all);
    addFraction(line, products[edge], sum);
  }
  return all;
}

} // namespace

namespace expected {

Expected ray_polygon_pluecker() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
