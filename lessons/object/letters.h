// The letters of the objects of a scene, as terms that know the coordinates they are.
#pragma once

#include "lessons/object/given.h"
#include "lessons/term/chain.h"

#include <string>

namespace halfspace {

struct PlaneTerms {
  Term P0;
  Term n;
};

struct RayTerms {
  Term Q;
  Term r;
};

struct TriangleTerms {
  Term P0;
  Term P1;
  Term P2;
};

[[nodiscard]] PlaneTerms termsOf(const Given<PlaneObject> &plane);
[[nodiscard]] RayTerms termsOf(const Given<RayObject> &ray);
[[nodiscard]] TriangleTerms termsOf(const Given<TriangleObject> &triangle);
/// A point goes by its own name.
[[nodiscard]] Term termOf(const Given<PointObject> &point);

/// P = (x, y, z): any point of space.
[[nodiscard]] Term anyPoint();

/// ax + by + cz + d = 0, for the points of the plane.
[[nodiscard]] Chain equationOf(const PlaneTerms &plane);

/// The point or vector that a term comes to whose coordinates are fractions.
[[nodiscard]] ExactVec3 vectorOf(const Term &term);

/// Whether the vector is one unit long.
[[nodiscard]] bool isUnit(const Term &vector);

/// The name with its value, in plain text: `t = −10/3`, or `t ≈ 0.271828` when it is rounded.
[[nodiscard]] std::string equation(const Term &name);

} // namespace halfspace
