#include "geometry/solid_shape.h"
#include "lessons/object/solid.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/claims/ray_at_faces.h"

#include <algorithm>

namespace halfspace::test {
namespace {

/// What the line of a ray has in common with a convex solid.
enum class Common { Nothing, Point, Surface, Inside };

enum class Part { Face, Edge, Corner };

struct RayAtSolid {
  explicit RayAtSolid(Objects objects)
      : mesh(meshOf(*objects[0])), L(objectAs<RayObject>(*objects[1]).value()) {
    for (const auto &indices : mesh.faces) {
      Corners &face = faces.emplace_back();
      for (const std::uint32_t index : indices)
        face.push_back(mesh.vertices[index]);
      normals.push_back(normalOf(face));
    }
    isConvex = !isFlat() && areFacesConvex();
    if (isConvex && isRay())
      cut();
  }

  bool isRay() const { return !vanishes(L.direction); }
  bool isFlat() const { return areInOnePlane(mesh.vertices); }
  bool areFacesFlat() const { return std::all_of(faces.begin(), faces.end(), areInOnePlane); }
  /// Whether each face is convex, and each corner that is not its own lies behind its plane.
  bool areFacesConvex() const {
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (!test::isConvex(faces[f]) || !isAllBehind(f))
        return false;
    return true;
  }
  bool isAllBehind(std::size_t f) const {
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
      const Rational height = product(normals[f], ExactVec3(mesh.vertices[i] - faces[f][0]));
      const bool isOwn = std::find(mesh.faces[f].begin(), mesh.faces[f].end(), i) != mesh.faces[f].end();
      if (isOwn ? height != 0 : height >= 0)
        return false;
    }
    return true;
  }
  bool hasDoubleCorner() const { return hasDouble(mesh.vertices); }

  /// The line cut off at each face's plane leaves what it has in common with the solid.
  void cut() {
    std::optional<Rational> first;
    std::optional<Rational> last;
    bool isOnFace = false;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const Rational height = product(normals[f], ExactVec3(L.origin - faces[f][0]));
      const Rational slope = product(normals[f], L.direction);
      isOnFace = isOnFace || (slope == 0 && height == 0);
      if (slope == 0 && height > 0)
        return;
      if (slope < 0)
        first = first ? std::max(*first, Rational(-height / slope)) : -height / slope;
      if (slope > 0)
        last = last ? std::min(*last, Rational(-height / slope)) : -height / slope;
    }
    if (*first > *last)
      return;
    begin = *first;
    end = *last;
    common = begin == end ? Common::Point : isOnFace ? Common::Surface : Common::Inside;
  }

  bool isLine() const { return isConvex && isRay(); }
  bool has(Common what) const { return isLine() && common == what; }
  bool meets() const { return isLine() && common != Common::Nothing; }

  /// Whether the line has an edge of the face that goes around it this way, 1 or −1.
  bool hasTurn(std::size_t f, int way) const {
    for (std::size_t i = 0; i < faces[f].size(); ++i)
      if (turnAround(L, faces[f][i], cornerOf(faces[f], i + 1)).sign() == way)
        return true;
    return false;
  }
  bool hasOneTurn(std::size_t f) const { return hasTurn(f, 1) != hasTurn(f, -1); }

  /// In the planes of how many faces the line's point lies.
  long facesAt(const Rational &t) const {
    const ExactVec3 point = L.origin + L.direction * t;
    long count = 0;
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (product(normals[f], ExactVec3(point - faces[f][0])) == 0)
        ++count;
    return count;
  }
  bool isCorner(const Rational &t) const {
    const ExactVec3 point = L.origin + L.direction * t;
    return std::find(mesh.vertices.begin(), mesh.vertices.end(), point) != mesh.vertices.end();
  }
  Part partAt(const Rational &t) const {
    return isCorner(t) ? Part::Corner : facesAt(t) == 2 ? Part::Edge : Part::Face;
  }

  SolidMesh<Rational> mesh;
  std::vector<Corners> faces; ///< of the mesh
  RayObject L;
  std::vector<ExactVec3> normals; ///< of the faces, outwards
  bool isConvex = false;
  Common common = Common::Nothing;
  Rational begin, end; ///< of what the line has in common with the solid
};

/// Whether it holds of the face that a line is about; of one of them, where the line has no number.
template <class Condition> bool holdsOfFace(const RayAtSolid &at, const Said &said, Condition condition) {
  if (said.line.rfind("face", 0) == 0)
    return condition(std::stoul(said.line.substr(std::string_view("face").size())));
  for (std::size_t face = 0; face < at.faces.size(); ++face)
    if (condition(face))
      return true;
  return false;
}

/// Where all that the line passes goes around it one way.
auto oneWayClaim(Common common, int way = 0) {
  return [common, way](const RayAtSolid &at, const Said &said) {
    return at.has(common) && holdsOfFace(at, said, [&](std::size_t face) {
             return at.hasOneTurn(face) && (way == 0 || at.hasTurn(face, way));
           });
  };
}

/// The ends of the edge that a line is about.
std::pair<ExactVec3, ExactVec3> edgeOf(const RayAtSolid &at, const Said &said) {
  const auto sides = edgesByEnds(at.mesh.faces);
  const auto &[from, to, face] = sides.at(2 * numberIn(said.line));
  return {at.mesh.vertices[from], at.mesh.vertices[to]};
}
Rational turnOf(const RayAtSolid &at, const Said &said) {
  const auto [from, to] = edgeOf(at, said);
  return turnAround(at.L, from, to);
}

/// Of the point that a line is about: t1 where the line goes in, t2 where it comes out.
const Rational &parameterOf(const RayAtSolid &at, const Said &said) {
  return said.line.back() == '1' ? at.begin : at.end;
}

bool hasNoDirection(const RayAtSolid &at) { return !at.isRay(); }
bool meets(const RayAtSolid &at) { return at.meets(); }

Claims caseClaims() {
  return claimsAbout<RayAtSolid>({
      {"The direction {r} is the zero vector: the ray goes nowhere.", hasNoDirection},
      {"All corners lie in one plane: the solid is flat and has no inside.",
       [](const RayAtSolid &at) { return at.isFlat(); }},
      {"The corners of a face do not lie in one plane: its edges enclose no flat face.",
       [](const RayAtSolid &at) { return !at.areFacesFlat(); }},
      {"{first} and {second} are the same point.", [](const RayAtSolid &at) { return at.hasDoubleCorner(); }},
      {"{first} and {second} are the same point: a face has a corner too many, and the signs alone do not "
       "decide.",
       [](const RayAtSolid &at) { return at.hasDoubleCorner() && !at.isFlat() && at.areFacesFlat(); }},
      {"A face bends inwards, crosses itself or has a straight corner: the solid does not count as convex, "
       "and the signs are not asked.",
       [](const RayAtSolid &at) {
         return !at.isConvex && !at.isFlat() && at.areFacesFlat() && !at.hasDoubleCorner();
       }},
      {"The line goes through none of the faces: it misses the solid.",
       [](const RayAtSolid &at) { return at.has(Common::Nothing); }},
      {"The line goes through the solid, but {t1} and {t2} are negative: it is behind the ray's start.",
       [](const RayAtSolid &at) { return at.has(Common::Inside) && at.end < 0; }},
      {"The ray starts on the solid and leads away from it: it has only its start in common with it.",
       [](const RayAtSolid &at) { return at.has(Common::Inside) && at.end == 0; }},
      {"The ray touches the solid in one point alone, {H1}, with {t1}.",
       [](const RayAtSolid &at) { return at.has(Common::Point) && at.begin >= 0; }},
      {"The line touches the solid in one point alone, {H1}. But {t1} is negative: that is behind the ray's "
       "start.",
       [](const RayAtSolid &at) { return at.has(Common::Point) && at.begin < 0; }},
      {"The line runs along the surface, from {t1} to {t2}: in a face or an edge, without going inside.",
       [](const RayAtSolid &at) { return at.has(Common::Surface) && at.end >= 0; }},
      {"The line runs along the surface, but {t1} and {t2} are negative: the solid is behind the ray's "
       "start.",
       [](const RayAtSolid &at) { return at.has(Common::Surface) && at.end < 0; }},
  });
}

/// Of a ray that goes in through one part of the solid and comes out through another.
auto throughClaim(Part in, Part out) {
  return [in, out](const RayAtSolid &at) {
    return at.has(Common::Inside) && at.begin >= 0 && at.partAt(at.begin) == in && at.partAt(at.end) == out;
  };
}

/// Of one that starts inside.
auto fromInsideClaim(Part out) {
  return [out](const RayAtSolid &at) {
    return at.has(Common::Inside) && at.begin < 0 && at.end > 0 && at.partAt(at.end) == out;
  };
}

Claims throughClaims() {
  return claimsAbout<RayAtSolid>({
      {"The ray goes in through {in} at {t1}, and comes out through {out} at {t2}.",
       throughClaim(Part::Face, Part::Face)},
      {"The ray goes in through {in} at {t1}, and comes out through the edge of {out} and {outOther} at "
       "{t2}.",
       throughClaim(Part::Face, Part::Edge)},
      {"The ray goes in through {in} at {t1}, and comes out through a corner of {out} at {t2}.",
       throughClaim(Part::Face, Part::Corner)},
      {"The ray goes in through the edge of {in} and {inOther} at {t1}, and comes out through {out} at {t2}.",
       throughClaim(Part::Edge, Part::Face)},
      {"The ray goes in through the edge of {in} and {inOther} at {t1}, and comes out through the edge of "
       "{out} and {outOther} at {t2}.",
       throughClaim(Part::Edge, Part::Edge)},
      {"The ray goes in through the edge of {in} and {inOther} at {t1}, and comes out through a corner of "
       "{out} at {t2}.",
       throughClaim(Part::Edge, Part::Corner)},
      {"The ray goes in through a corner of {in} at {t1}, and comes out through {out} at {t2}.",
       throughClaim(Part::Corner, Part::Face)},
      {"The ray goes in through a corner of {in} at {t1}, and comes out through the edge of {out} and "
       "{outOther} at {t2}.",
       throughClaim(Part::Corner, Part::Edge)},
      {"The ray goes in through a corner of {in} at {t1}, and comes out through a corner of {out} at {t2}.",
       throughClaim(Part::Corner, Part::Corner)},
      {"The ray starts inside: {t1} is behind its start. It comes out through {out} at {t2}.",
       fromInsideClaim(Part::Face)},
      {"The ray starts inside: {t1} is behind its start. It comes out through the edge of {out} and "
       "{outOther} at {t2}.",
       fromInsideClaim(Part::Edge)},
      {"The ray starts inside: {t1} is behind its start. It comes out through a corner of {out} at {t2}.",
       fromInsideClaim(Part::Corner)},
  });
}

Claims nameClaims() {
  return claimsAbout<RayAtSolid>({
      {"the face {axis}{value}", always},
      {"the face {corners}", always},
      {"the base", always},
      {"the top", always},
      {"the side at {edge}", always},
  });
}

Claims edgeClaims() {
  return claimsAbout<RayAtSolid>({
      {"The moment of the ray's line.", always},
      {"The edge, from one corner to the other.", always},
      {"The moment of its line.", always},
      {"Positive: seen with {r} pointing at you, the edge goes counterclockwise around the ray.",
       [](const RayAtSolid &at, const Said &said) { return turnOf(at, said) > 0; }},
      {"Negative: seen with {r} pointing at you, the edge goes clockwise around the ray.",
       [](const RayAtSolid &at, const Said &said) { return turnOf(at, said) < 0; }},
      {"Zero, because {r} is the zero vector: there is no ray.", hasNoDirection},
      {"Zero, because {e} is the zero vector: there is no edge.",
       [](const RayAtSolid &at, const Said &said) {
         const auto [from, to] = edgeOf(at, said);
         return from == to;
       }},
      {"Zero: the ray and the edge lie in one plane.",
       [](const RayAtSolid &at, const Said &said) {
         const auto [from, to] = edgeOf(at, said);
         return at.isRay() && from != to && turnOf(at, said) == 0;
       }},
      {"One product for two faces. Along {first} the edge runs as its arrow does, along {second} the other "
       "way: there the sign changes.",
       [](const RayAtSolid &at, const Said &said) { return turnOf(at, said) != 0; }},
      {"One product for {first} and {second}: 0, whichever way they run along the edge.",
       [](const RayAtSolid &at, const Said &said) { return turnOf(at, said) == 0; }},
      {"One product for each edge.", always},
      {"The edges of each face, face by face.", always},
      {"Each edge belongs to two faces, so it was counted twice.", always},
  });
}

Claims faceClaims() {
  return claimsAbout<RayAtSolid>({
      {"These are the products of {face}. They decide for a convex solid only.",
       [](const RayAtSolid &at) { return !at.isConvex; }},
      {"All are 0, because {r} is the zero vector: there is no line.", hasNoDirection},
      {"Both signs are there: the line misses {face}.",
       [](const RayAtSolid &at, const Said &said) {
         return at.isLine() && holdsOfFace(at, said, [&](std::size_t face) {
                  return at.hasTurn(face, 1) && at.hasTurn(face, -1);
                });
       }},
      {"All are 0: the line runs in the plane of {face}.",
       [](const RayAtSolid &at, const Said &said) {
         return at.isLine() && holdsOfFace(at, said, [&](std::size_t face) {
                  return product(at.normals[face], at.L.direction) == 0 &&
                         product(at.normals[face], ExactVec3(at.L.origin - at.faces[face][0])) == 0;
                });
       }},
      {"No two differ in sign. But the line only touches the solid, in one point, which lies on the border "
       "of {face}: it goes neither in nor out.",
       oneWayClaim(Common::Point)},
      {"No two differ in sign. But the line runs along the surface of the solid, and meets {face} at its "
       "border: it goes neither in nor out.",
       oneWayClaim(Common::Surface)},
      {"None is negative: the line comes out through {face}.", oneWayClaim(Common::Inside, 1)},
      {"None is positive: the line goes in through {face}.", oneWayClaim(Common::Inside, -1)},
      {"A normal of {face}, from two of its edges: it points outwards.", meets},
      {"Negative: that is behind the start {Q}.",
       [](const RayAtSolid &at, const Said &said) { return at.meets() && parameterOf(at, said) < 0; }},
      {"Not negative: the ray itself gets there.",
       [](const RayAtSolid &at, const Said &said) {
         return at.meets() && !at.has(Common::Inside) && parameterOf(at, said) >= 0;
       }},
      {"Not negative: the ray itself gets there, and goes in.",
       [](const RayAtSolid &at, const Said &said) {
         return at.has(Common::Inside) && said.line == "t1" && at.begin >= 0;
       }},
      {"Not negative: the ray itself gets there, and comes out.",
       [](const RayAtSolid &at, const Said &said) {
         return at.has(Common::Inside) && said.line == "t2" && at.end >= 0;
       }},
  });
}

} // namespace

namespace claims {

Claims ray_solid_pluecker() {
  return together({caseClaims(), throughClaims(), nameClaims(), edgeClaims(), faceClaims()});
}

} // namespace claims
} // namespace halfspace::test
