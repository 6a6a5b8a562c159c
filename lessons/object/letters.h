// The letters that the notes give to the objects of a scene, as terms that know the coordinates they are.
#pragma once

#include "lessons/object/object.h"
#include "lessons/term/chain.h"

#include <string>
#include <string_view>

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

/// A name of ASCII letters and digits as it is spelled: `P12` is P with the index 12, a word stands upright.
[[nodiscard]] Symbol symbolOf(std::string_view name);

/// `role` is that of the object in the construction.
[[nodiscard]] PlaneTerms termsOf(const PlaneObject &plane, const std::string &role);
[[nodiscard]] RayTerms termsOf(const RayObject &ray, const std::string &role);
[[nodiscard]] TriangleTerms termsOf(const TriangleObject &triangle, const std::string &role);
/// A point goes by the letter of its role.
[[nodiscard]] Term termOf(const PointObject &point, const std::string &role);

/// P = (x, y, z): any point of space.
[[nodiscard]] Term anyPoint();

/// ax + by + cz + d = 0, for the points of the plane.
[[nodiscard]] Chain equationOf(const PlaneObject &plane);

/// Whether the vector is one unit long.
[[nodiscard]] bool isUnit(const Term &vector);

/// The name with its value, in plain text: `t = −10/3`, or `t ≈ 0.271828` when it is rounded.
[[nodiscard]] std::string equation(const Term &name);

} // namespace halfspace
