#include "lessons/object/quadric.h"

#include <algorithm>

namespace halfspace {
namespace {

ExactVec3 unit(int axis) {
  ExactVec3 vector(0);
  vector[axis] = 1;
  return vector;
}

ExactVec3 times(const std::array<ExactVec3, 3> &rows, const ExactVec3 &vector) {
  return {dot(rows[0], vector), dot(rows[1], vector), dot(rows[2], vector)};
}

// Where the probes lie: the place itself, one step each way along the axes, one along two of them, and two
// oblique ones that the polynomial must fit besides.
constexpr std::size_t itself = 0;
constexpr std::size_t forward = 1;
constexpr std::size_t backward = 4;
constexpr std::size_t between = 7;
constexpr std::size_t oblique = 10;

std::size_t on(std::size_t first, int axis) { return first + static_cast<std::size_t>(axis); }

/// The two axes that differ from this one.
std::pair<int, int> othersThan(int axis) { return {(axis + 1) % 3, (axis + 2) % 3}; }

} // namespace

std::array<ExactVec3, Quadric::probeCount> Quadric::probes(const ExactVec3 &around) {
  std::array<ExactVec3, probeCount> places;
  places.fill(around);
  for (int axis = 0; axis < 3; ++axis) {
    const auto [first, second] = othersThan(axis);
    places.at(on(forward, axis)) += unit(axis);
    places.at(on(backward, axis)) -= unit(axis);
    places.at(on(between, axis)) += unit(first) + unit(second);
  }
  places[oblique] += ExactVec3(-2, 3, 5);
  places[oblique + 1] += ExactVec3(4, 3, -7);
  return places;
}

std::optional<Quadric> Quadric::through(const ExactVec3 &around,
                                        std::span<const Rational, probeCount> values) {
  Quadric quadric;
  quadric.m_origin = around;
  quadric.m_constant = values[itself];
  for (int axis = 0; axis < 3; ++axis) {
    const Rational &ahead = values[on(forward, axis)];
    const Rational &behind = values[on(backward, axis)];
    quadric.m_slope[axis] = (ahead - behind) / 2;
    quadric.row(axis)[axis] = (ahead + behind) / 2 - quadric.m_constant;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto [first, second] = othersThan(axis);
    const Rational mixed = values[on(between, axis)] - quadric.at(around + unit(first) + unit(second));
    quadric.row(first)[second] = quadric.row(second)[first] = mixed / 2;
  }
  const auto places = probes(around);
  for (std::size_t probe = oblique; probe < probeCount; ++probe)
    if (quadric.at(places.at(probe)) != values[probe])
      return {};
  return quadric.isCurved() ? std::optional(quadric) : std::nullopt;
}

std::optional<Quadric> Quadric::of(const Function &function) {
  std::array<Rational, probeCount> values;
  const auto places = probes(ExactVec3(0));
  std::transform(places.begin(), places.end(), values.begin(), function);
  return through(ExactVec3(0), values);
}

bool Quadric::isCurved() const {
  // Rows that are all multiples of one vector are those of the square of a linear form.
  return std::any_of(m_form.begin(), m_form.end(), [this](const ExactVec3 &row) {
    return std::any_of(m_form.begin(), m_form.end(),
                       [&](const ExactVec3 &other) { return !isZero(cross(row, other)); });
  });
}

Rational Quadric::at(const ExactVec3 &place) const {
  const ExactVec3 from = place - m_origin;
  return dot(from, times(m_form, from)) + dot(m_slope, from) + m_constant;
}

ExactVec3 Quadric::gradient(const ExactVec3 &place) const {
  return times(m_form, place - m_origin) * Rational(2) + m_slope;
}

Quadric::OnLine Quadric::along(const ExactVec3 &from, const ExactVec3 &way) const {
  return {dot(way, times(m_form, way)), dot(way, gradient(from)), at(from)};
}

} // namespace halfspace
