#include "lessons/object/kinds/box.h"
#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

#include <set>

namespace halfspace::test {
namespace {

const std::array<std::string, 3> axisNames{"x", "y", "z"};

/// A box as the places of its six faces, and where the ray's line goes through their planes.
struct Faces {
  explicit Faces(Objects objects)
      : K(objectAs<BoxObject>(*objects[0]).value()), L(objectAs<RayObject>(*objects[1]).value()) {
    const std::array lengths{K.a, K.b, K.c};
    for (int axis = 0; axis < 3; ++axis)
      planes.at(std::size_t(axis)) = {K.lowest[axis], K.lowest[axis] + lengths.at(std::size_t(axis))};
  }

  /// On which side of a plane the line is changes evenly from the start to one step later.
  [[nodiscard]] Rational parameterAt(std::size_t axis, const Rational &plane) const {
    const Rational here = L.origin[int(axis)] - plane;
    const Rational next = (L.origin + L.direction)[int(axis)] - plane;
    return here / (here - next);
  }
  [[nodiscard]] bool isCrossed(std::size_t axis) const { return L.direction[int(axis)] != 0; }
  [[nodiscard]] bool has(const ExactVec3 &point, std::size_t axis) const {
    const auto &[low, high] = planes.at(axis);
    return (point[int(axis)] - low) * (high - point[int(axis)]) >= 0;
  }
  [[nodiscard]] bool has(const ExactVec3 &point) const {
    return has(point, 0) && has(point, 1) && has(point, 2);
  }
  [[nodiscard]] ExactVec3 at(const Rational &t) const { return L.origin + L.direction * t; }

  BoxObject K;
  RayObject L;
  std::array<std::pair<Rational, Rational>, 3> planes;
};

std::string originOf(const Faces &faces) {
  if (!faces.has(faces.L.origin))
    return "outside";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto &[low, high] = faces.planes.at(axis);
    if (faces.L.origin[int(axis)] == low || faces.L.origin[int(axis)] == high)
      return "on";
  }
  return "inside";
}

/// The plane through which the line goes at a parameter, where it goes through those of one slab alone there;
/// `ways` are the ways in, or those out.
std::string faceAt(const Faces &faces, const std::map<std::size_t, Rational> &ways, const Rational &t) {
  std::string face;
  for (const auto &[axis, way] : ways)
    if (way == t)
      face = face.empty() ? axisNames.at(axis) +
                                (faces.at(t)[int(axis)] == faces.planes.at(axis).first ? "-low" : "-high")
                          : "several";
  return face;
}

/// By slabs that are crossed.
struct Ways {
  explicit Ways(const Faces &faces) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (faces.isCrossed(axis)) {
        const auto &[low, high] = faces.planes.at(axis);
        std::multiset<Rational> both{faces.parameterAt(axis, low), faces.parameterAt(axis, high)};
        in[axis] = *both.begin();
        out[axis] = *both.rbegin();
        ins.insert(in[axis]);
        outs.insert(out[axis]);
      }
  }

  std::map<std::size_t, Rational> in, out;
  std::multiset<Rational> ins, outs;
};

void addSlab(Recomputed &expected, const Faces &faces, const Ways &ways, std::size_t axis) {
  const std::string &name = axisNames.at(axis);
  if (!faces.isCrossed(axis)) {
    expected.values[name + ".way"] = faces.has(faces.L.origin, axis) ? "within" : "beside";
    return;
  }
  expected.values[name + ".way"] = "crossed";
  expected.values[name + ".first"] = faces.L.direction[int(axis)] < 0 ? "high" : "low";
  expected.values[name + ".in"] = number(ways.in.at(axis));
  expected.values[name + ".out"] = number(ways.out.at(axis));
  expected.names["\\operatorname{in}_" + name] = quantity(ways.in.at(axis));
  expected.names["\\operatorname{out}_" + name] = quantity(ways.out.at(axis));
  expected.names["A_" + name] = quantity(faces.at(ways.in.at(axis)));
  expected.names["B_" + name] = quantity(faces.at(ways.out.at(axis)));
}

void nameLetters(Recomputed &expected, const Faces &faces) {
  const auto &[K, L, planes] = faces;
  expected.names = {
      {"P_0", quantity(K.lowest)}, {"Q", quantity(L.origin)}, {"\\vec r", quantity(L.direction)},
      {"a", quantity(K.a)},        {"b", quantity(K.b)},      {"c", quantity(K.c)}};
  for (int axis = 0; axis < 3; ++axis) {
    const std::string &name = axisNames.at(std::size_t(axis));
    expected.names[name + "_0"] = quantity(K.lowest[axis]);
    expected.names["Q_" + name] = quantity(L.origin[axis]);
    expected.names["r_" + name] = quantity(L.direction[axis]);
  }
}

Recomputed recompute(Objects objects) {
  const Faces faces(objects);
  Recomputed expected;
  nameLetters(expected, faces);
  expected.values["origin"] = originOf(faces);
  if (vanishes(faces.L.direction)) {
    expected.caseName = "zero-direction";
    expected.degenerate = true;
    expected.vanished.insert("L.r");
    return expected;
  }
  const Ways ways(faces);
  bool isBeside = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    addSlab(expected, faces, ways, axis);
    isBeside = isBeside || (!faces.isCrossed(axis) && !faces.has(faces.L.origin, axis));
  }
  expected.caseName = "miss";
  expected.values["contacts"] = "none";
  if (isBeside)
    return expected;
  const Rational in = *ways.ins.rbegin();
  const Rational out = *ways.outs.begin();
  expected.values["t_in"] = number(in);
  expected.values["t_out"] = number(out);
  expected.names["t_{\\text{in}}"] = quantity(in);
  expected.names["t_{\\text{out}}"] = quantity(out);
  if (!faces.has(faces.at(in))) // then it is in the box nowhere
    return expected;
  expected.caseName = out < 0 ? "behind" : "hit";
  expected.values["contacts"] = in == out ? "one" : "piece";
  expected.values["entry"] = numbers(faces.at(in));
  expected.values["exit"] = numbers(faces.at(out));
  expected.values["face_in"] = faceAt(faces, ways.in, in);
  expected.values["face_out"] = faceAt(faces, ways.out, out);
  expected.names["H_1"] = quantity(faces.at(in));
  expected.names["H_2"] = quantity(faces.at(out));
  return expected;
}

/// Of one way into a slab, or out of it.
void addWay(std::vector<WrongAnswer> &all, const std::string &id, const Rational &plane,
            const Rational &other, const Rational &start, const Rational &step) {
  Line line(id, Rational((plane - start) / step), all);
  addFraction(line, Rational(plane - start), step);
  line.addRatio("the other plane", Rational(other - start), step);
  line.addRatio("added", Rational(plane + start), step);
  line.addRatio("the start forgotten", plane, step);
  line.addRatio("the plane forgotten", start, step);
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Faces faces(objects);
  std::vector<WrongAnswer> all;
  const Recomputed expected = recompute(objects);
  if (expected.degenerate)
    return all;
  const Ways ways(faces);
  for (const auto &[axis, in] : ways.in) {
    const auto &[low, high] = faces.planes.at(axis);
    const Rational &step = faces.L.direction[int(axis)];
    const Rational &start = faces.L.origin[int(axis)];
    addWay(all, "in-" + axisNames.at(axis), step > 0 ? low : high, step > 0 ? high : low, start, step);
    addWay(all, "out-" + axisNames.at(axis), step > 0 ? high : low, step > 0 ? low : high, start, step);
  }
  if (!expected.values.contains("t_in"))
    return all;
  const Rational in = *ways.ins.rbegin();
  const Rational out = *ways.outs.begin();
  Line last("t-in", in, all);
  last.add("the smallest", *ways.ins.begin());
  last.add("the way out", out);
  Line first("t-out", out, all);
  first.add("the largest", *ways.outs.rbegin());
  first.add("the way in", in);
  if (!expected.values.contains("entry"))
    return all;
  addPointOnRay(all, "hit1", faces.L.origin, in, faces.L.direction);
  addPointOnRay(all, "hit2", faces.L.origin, out, faces.L.direction);
  return all;
}

} // namespace

namespace expected {

Expected ray_box_slabs() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
