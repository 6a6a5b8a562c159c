#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/expected/bodies.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// Pairs of neighbours, by the lower corner and then by the higher one. Each runs as the first face has it.
struct Edge {
  std::size_t from;
  std::size_t to;
};

std::vector<Edge> edgesOf(const Body &body) {
  std::map<std::pair<std::size_t, std::size_t>, Edge> edges;
  for (const Face &face : body.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Edge edge{face[i], face[(i + 1) % face.size()]};
      edges.try_emplace(std::minmax({edge.from, edge.to}), edge);
    }
  std::vector<Edge> all;
  for (const auto &[ends, edge] : edges)
    all.push_back(edge);
  return all;
}

/// The volume between the ray's direction and the ways from its start to the ends of the edge.
Rational productWith(const Body &body, const Edge &edge, const RayObject &ray) {
  return determinant(ray.direction, body.corners[edge.from] - ray.origin, body.corners[edge.to] - ray.origin);
}

/// How the line goes through the half-space behind a face: at t = away/along.
struct Slab {
  ExactVec3 normal;
  Rational along;
  Rational away;
};

std::vector<Slab> slabsOf(const Body &body, const RayObject &ray) {
  std::vector<Slab> slabs;
  for (const Face &face : body.faces) {
    const ExactVec3 normal = twiceAreaOf(cornersOf(body, face));
    slabs.push_back({normal, product(normal, ray.direction),
                     product(normal, ExactVec3(body.corners[face[0]] - ray.origin))});
  }
  return slabs;
}

/// The part of the line behind all faces, and the faces where it begins and ends.
struct Chord {
  std::size_t in = 0;
  std::size_t out = 0;
  Rational from;
  Rational to;
};

std::optional<Chord> chordOf(const std::vector<Slab> &slabs) {
  std::optional<Chord> chord;
  std::optional<std::pair<Rational, std::size_t>> first;
  std::optional<std::pair<Rational, std::size_t>> last;
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const auto &[normal, along, away] = slabs[i];
    if (along == 0 && away < 0)
      return {};
    if (along == 0)
      continue;
    const Rational t = away / along;
    auto &bound = along < 0 ? first : last;
    if (!bound || (along < 0 ? t > bound->first : t < bound->first))
      bound = {t, i};
  }
  if (!first || !last || first->first > last->first)
    return {};
  return Chord{first->second, last->second, first->first, last->first};
}

std::string locationIn(const Body &body, std::size_t face, const ExactVec3 &point) {
  const CornerList corners = cornersOf(body, body.faces[face]);
  int onEdges = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (determinant(twiceAreaOf(corners), corners[(i + 1) % corners.size()] - corners[i],
                    point - corners[i]) == 0)
      ++onEdges;
  return onEdges == 0 ? "interior" : onEdges == 1 ? "edge" : "vertex";
}

void addContact(const Body &body, const RayObject &ray, std::size_t face, const Rational &t,
                const std::string &group, std::size_t index, Recomputed &expected) {
  const ExactVec3 point = ray.origin + ray.direction * t;
  const CornerList corners = cornersOf(body, body.faces[face]);
  expected.values[group + ".point"] = numbers(point);
  expected.values[group + ".face"] = static_cast<int>(face);
  expected.values[group + ".location"] = locationIn(body, face, point);
  expected.names[numbered("t", index)] = quantity(t);
  expected.names[numbered("H", index)] = quantity(point);
  expected.names[numbered("\\vec n", index)] =
      quantity(perpendicular(ExactVec3(corners[1] - corners[0]), ExactVec3(corners[2] - corners[0])));
}

void recomputeMeeting(const Body &body, const RayObject &ray, Recomputed &expected) {
  const std::vector<Slab> slabs = slabsOf(body, ray);
  const auto chord = chordOf(slabs);
  expected.caseName = !chord ? "miss" : chord->to < 0 ? "behind" : "hit";
  expected.values["contacts"] = "none";
  if (!chord)
    return;
  const bool isAlong = std::any_of(slabs.begin(), slabs.end(),
                                   [](const Slab &slab) { return slab.along == 0 && slab.away == 0; });
  expected.values["contacts"] = chord->from == chord->to ? "one" : isAlong ? "along" : "two";
  expected.values["t"] = SignedSquares{signedSquare(chord->from), signedSquare(chord->to)};
  addContact(body, ray, chord->in, chord->from, "entered", 1, expected);
  addContact(body, ray, chord->out, chord->to, "left", 2, expected);
}

std::string placeOfStart(const Body &body, const RayObject &ray) {
  bool isOn = false;
  for (const Slab &slab : slabsOf(body, ray)) {
    if (slab.away < 0)
      return "outside";
    isOn = isOn || slab.away == 0;
  }
  return isOn ? "on" : "inside";
}

void recomputeEdges(const Body &body, const RayObject &ray, Recomputed &expected) {
  expected.names = body.names;
  expected.names["Q"] = quantity(ray.origin);
  expected.names["\\vec r"] = quantity(ray.direction);
  expected.names["\\vec m"] = quantity(perpendicular(ray.origin, ray.direction));
  SignedSquares products;
  for (const Edge &edge : edgesOf(body)) {
    const std::size_t index = products.size();
    const ExactVec3 way = body.corners[edge.to] - body.corners[edge.from];
    const Rational product = productWith(body, edge, ray);
    products.push_back(signedSquare(product));
    expected.names[numbered("\\vec e", index)] = quantity(way);
    expected.names[numbered("\\vec m", index)] = quantity(perpendicular(body.corners[edge.from], way));
    expected.names[numbered("p", index)] = quantity(product);
    if (vanishes(way))
      expected.vanished.insert("it.p" + std::to_string(index));
  }
  // Euler: corners − edges + faces = 2.
  const auto edges = static_cast<int>(body.corners.size() + body.faces.size()) - 2;
  expected.values = {{"products", products}, {"sides", number(2 * edges)}, {"edges", number(edges)}};
  expected.names["k"] = quantity(Rational(2 * edges));
  expected.names["N"] = quantity(Rational(edges));
}

Recomputed recompute(Objects objects) {
  const Body body = bodyOf(*objects[0]);
  const auto ray = objectAs<RayObject>(*objects[1]).value();
  Recomputed expected;
  recomputeEdges(body, ray, expected);
  if (!body.problem)
    expected.values["origin"] = placeOfStart(body, ray);
  if (vanishes(ray.direction)) {
    expected.vanished.insert("L.r");
    expected.caseName = "zero-direction";
  } else if (body.problem) {
    expected.caseName = body.problem;
  } else {
    recomputeMeeting(body, ray, expected);
    return expected;
  }
  expected.degenerate = true;
  return expected;
}

/// d₁·m₂ + d₂·m₁ of the ray and an edge.
void addPermuted(std::vector<WrongAnswer> &all, const Body &body, const Edge &edge, std::size_t index,
                 const RayObject &ray) {
  const ExactVec3 way = body.corners[edge.to] - body.corners[edge.from];
  const ExactVec3 moment = perpendicular(ray.origin, ray.direction);
  const ExactVec3 edgeMoment = perpendicular(body.corners[edge.from], way);
  const Rational first = times(ray.direction, edgeMoment);
  const Rational second = times(way, moment);
  Line line("edge" + std::to_string(index), Rational(first + second), all);
  line.add("only the first product", first);
  line.add("only the second product", second);
  line.add("subtracted", Rational(first - second));
  line.add("not crossed over", Rational(times(ray.direction, way) + times(moment, edgeMoment)));
  line.add("each with its own moment", Rational(times(ray.direction, moment) + times(way, edgeMoment)));
  line.add("the sign lost", Rational(-first - second));
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Body body = bodyOf(*objects[0]);
  const auto ray = objectAs<RayObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  if (vanishes(ray.direction) || body.problem)
    return all;
  const std::vector<Edge> edges = edgesOf(body);
  for (std::size_t i = 0; i < edges.size(); ++i)
    addPermuted(all, body, edges[i], i, ray);
  if (const auto chord = chordOf(slabsOf(body, ray)))
    for (const auto &[id, face] : {std::pair("t1", chord->in), std::pair("t2", chord->out)}) {
      const CornerList corners = cornersOf(body, body.faces[face]);
      addParameter(all, id,
                   perpendicular(ExactVec3(corners[1] - corners[0]), ExactVec3(corners[2] - corners[0])),
                   corners[0], ray);
    }
  return all;
}

} // namespace

namespace expected {

Expected ray_solid_pluecker() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
