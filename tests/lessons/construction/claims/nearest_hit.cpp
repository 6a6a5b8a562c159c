#include "lessons/object/kinds/mesh.h"
#include "lessons/object/kinds/number.h"
#include "tests/lessons/construction/claims/ray_at_triangle.h"

#include <optional>

namespace halfspace::test {
namespace {

/// One triangle of all meshes, and what the ray has in common with it where it lies in its plane.
struct Piece {
  RayAtTriangle at;
  std::size_t number; ///< within its mesh, from 1 on

  /// From where to where along the ray: its line meets the border of a triangle in its plane where the common
  /// part begins and ends.
  std::optional<std::pair<Rational, Rational>> passage() const {
    if (!at.isInPlane())
      return {};
    std::vector<Rational> meetings;
    for (std::size_t i = 0; i < 3; ++i)
      addMeetings(at.corners.at(i), at.corners.at((i + 1) % 3), meetings);
    if (meetings.empty())
      return {};
    const auto [first, last] = std::minmax_element(meetings.begin(), meetings.end());
    if (*last < 0)
      return {};
    return std::pair(std::max(*first, Rational(0)), *last);
  }

  /// Of the ray's line with one side; both ends of a side that it runs along.
  void addMeetings(const ExactVec3 &from, const ExactVec3 &to, std::vector<Rational> &meetings) const {
    const ExactVec3 side = to - from;
    const ExactVec3 across = perpendicular(at.L.direction, side);
    const ExactVec3 way = from - at.L.origin;
    if (vanishes(across)) {
      if (vanishes(perpendicular(way, at.L.direction)))
        for (const ExactVec3 &end : {from, to})
          meetings.push_back(product(ExactVec3(end - at.L.origin), at.L.direction) /
                             product(at.L.direction, at.L.direction));
      return;
    }
    const Rational share = product(perpendicular(way, at.L.direction), across) / product(across, across);
    if (share >= 0 && share <= 1)
      meetings.push_back(product(perpendicular(way, side), across) / product(across, across));
  }

  bool runsAlong() const {
    const auto both = passage();
    return both && both->first < both->second;
  }
  bool touches() const {
    const auto both = passage();
    return both && both->first == both->second;
  }
};

/// A ray, a number, and meshes.
struct RayAmongMeshes {
  explicit RayAmongMeshes(Objects objects)
      : L(objectAs<RayObject>(*objects[0]).value()), i(objectAs<NumberObject>(*objects[1])->value) {
    for (const Object *object : objects.subspan(2)) {
      const auto mesh = objectAs<MeshObject>(*object).value();
      for (std::size_t index = 0; index < mesh.shape->triangleCount(); ++index) {
        const auto &[p0, p1, p2] = triangleOf(mesh, index);
        pieces.push_back({RayAtTriangle({p0, p1, p2}, L), index + 1});
        if (pieces.back().at.hits() && (!nearest || pieces.back().at.lambda() < *nearest))
          nearest = pieces.back().at.lambda();
      }
    }
  }

  bool isRay() const { return !vanishes(L.direction); }
  bool hits() const { return nearest.has_value(); }
  bool isFirst(const Piece &piece) const { return piece.at.hits() && piece.at.lambda() == *nearest; }
  long ties() const {
    return std::count_if(pieces.begin(), pieces.end(), [this](const Piece &each) { return isFirst(each); });
  }
  template <class Condition> bool any(Condition condition) const {
    return std::any_of(pieces.begin(), pieces.end(), condition);
  }
  /// The triangle that is looked at, by its number among all.
  const Piece *chosen() const {
    for (std::size_t each = 0; each < pieces.size(); ++each)
      if (i == Rational(static_cast<int>(each) + 1))
        return &pieces[each];
    return nullptr;
  }

  RayObject L;
  Rational i;
  std::vector<Piece> pieces;
  std::optional<Rational> nearest; ///< the smallest λ of a hit
};

/// Whether a piece is one that can be named like this: barn 3.
bool isNamed(const Piece &piece, const Said &said) {
  const std::string name = said.at("fragment");
  return name.substr(name.rfind(' ') + 1) == std::to_string(piece.number);
}

bool hits(const RayAmongMeshes &at) { return at.hits(); }

/// So many are hit at the smallest λ, and the one that is named is among them.
auto tiesClaim(long count) {
  return [count](const RayAmongMeshes &at, const Said &said) {
    return at.ties() == count &&
           at.any([&](const Piece &each) { return at.isFirst(each) && isNamed(each, said); });
  };
}

Claims caseClaims() {
  return claimsAbout<RayAmongMeshes>({
      {"The ray hits {fragment} first, at {lambda}.", tiesClaim(1)},
      {"The ray hits {fragment} and one other first, both at {lambda}.", tiesClaim(2)},
      {"The ray hits {fragment} and {others} others first, all at {lambda}.",
       [](const RayAmongMeshes &at, const Said &said) {
         return at.ties() > 2 && tiesClaim(std::stol(said.at("others")) + 1)(at, said);
       }},
      {"The ray runs along {fragment}, in its plane: it hits no triangle at a single point.",
       [](const RayAmongMeshes &at, const Said &said) {
         return !at.hits() &&
                at.any([&](const Piece &each) { return each.runsAlong() && isNamed(each, said); });
       }},
      {"The ray touches {fragment} at one point, within its plane, and that does not count as a hit. It hits "
       "no triangle.",
       [](const RayAmongMeshes &at, const Said &said) {
         return !at.hits() &&
                at.any([&](const Piece &each) { return each.touches() && isNamed(each, said); });
       }},
      {"No triangle has a hit with λ ≥ 0: the ray meets nothing.",
       [](const RayAmongMeshes &at) {
         return at.isRay() && !at.hits() &&
                !at.any([](const Piece &each) { return each.runsAlong() || each.touches(); });
       }},
      {"Before, it runs along {fragment}, in its plane, and that does not count as a hit.",
       [](const RayAmongMeshes &at, const Said &said) {
         return at.hits() && at.any([&](const Piece &each) {
           return each.runsAlong() && each.passage()->first < *at.nearest && isNamed(each, said);
         });
       }},
      {"Before, it touches {fragment} within its plane, and that does not count as a hit.",
       [](const RayAmongMeshes &at, const Said &said) {
         return at.hits() && at.any([&](const Piece &each) {
           return each.touches() && each.passage()->first < *at.nearest && isNamed(each, said);
         });
       }},
      {"{i} is the number of no triangle: they are numbered from 1 to {count}.",
       [](const RayAmongMeshes &at, const Said &said) {
         return !at.chosen() && said.at("count") == std::to_string(at.pieces.size());
       }},
      {"{i} is the number of a triangle without an area.",
       [](const RayAmongMeshes &at) { return at.chosen() && !at.chosen()->at.isTriangle(); }},
      {"{told} {more}", always},
  });
}

Claims lineClaims() {
  return claimsAbout<RayAmongMeshes>({
      {"In their order, each with the number of its triangle. The ray stops at the first one that is 0 or "
       "more.",
       hits},
      {"In their order, each with the number of its triangle. None is 0 or more, so none is a hit.",
       [](const RayAmongMeshes &at) {
         return !at.hits() && at.any([](const Piece &each) { return each.at.isBehind(); });
       }},
      {"A corner of the triangle, as seen from {P}.",
       [](const RayAmongMeshes &at) { return at.chosen() && at.chosen()->at.isTriangle(); }},
      {"The smallest λ ≥ 0 of all hits, put into the ray.", hits},
  });
}

} // namespace

namespace claims {

Claims nearest_hit() { return together({caseClaims(), lineClaims(), zeroDirectionClaims(0)}); }

} // namespace claims
} // namespace halfspace::test
