// Solids by their corners and faces, put together otherwise than the program does.
#pragma once

#include "lessons/object/corners.h"
#include "lessons/object/kind.h"
#include "tests/lessons/construction/expected/flat_corners.h"

namespace halfspace::test {

using Face = std::vector<std::size_t>;

/// A solid by its corners, faces that are counterclockwise from outside, and what is wrong with it.
struct Body {
  CornerList corners;
  std::vector<Face> faces;
  Names names; ///< of the corners
  const char *problem = nullptr;
};

inline std::string numbered(const std::string &letter, std::size_t index) {
  const std::string digits = std::to_string(index);
  return letter + "_" + (digits.size() > 1 ? "{" + digits + "}" : digits);
}

inline ExactVec3 twiceAreaOf(const CornerList &corners) {
  ExactVec3 area{0, 0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += perpendicular(ExactVec3(corners[i] - corners[0]),
                          ExactVec3(corners[(i + 1) % corners.size()] - corners[0]));
  return area;
}

inline CornerList cornersOf(const Body &body, const Face &face) {
  CornerList corners;
  for (const std::size_t corner : face)
    corners.push_back(body.corners[corner]);
  return corners;
}

/// Seen from each edge all other corners lie to its left.
inline bool isConvex(const CornerList &corners) {
  const ExactVec3 area = twiceAreaOf(corners);
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t k = 2; k < corners.size(); ++k)
      if (determinant(area, corners[(i + 1) % corners.size()] - corners[i],
                      corners[(i + k) % corners.size()] - corners[i]) <= 0)
        return false;
  return true;
}

inline void turnInsideOut(Body &body) {
  for (Face &face : body.faces)
    std::reverse(face.begin() + 1, face.end());
}

inline Body bodyOfBox(const Object &box) {
  Body body;
  for (int i = 0; i < 8; ++i) {
    body.corners.emplace_back(box[0].x + (i % 2) * box[1].x, box[0].y + (i / 2 % 2) * box[2].x,
                              box[0].z + (i / 4) * box[3].x);
  }
  body.names = {{"P_0", quantity(box[0])},
                {"a", quantity(box[1].x)},
                {"b", quantity(box[2].x)},
                {"c", quantity(box[3].x)}};
  body.faces = {{4, 5, 7, 6}, {0, 2, 3, 1}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  if (box[1].x == 0 || box[2].x == 0 || box[3].x == 0)
    body.problem = "flat";
  return body;
}

inline Body bodyOfTetrahedron(const Object &object) {
  Body body{{object[0], object[1], object[2], object[3]},
            {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}},
            {},
            nullptr};
  for (std::size_t i = 0; i < 4; ++i)
    body.names[numbered("P", i)] = quantity(object[i]);
  const Rational volume = determinant(object[1] - object[0], object[2] - object[0], object[3] - object[0]);
  if (volume > 0)
    turnInsideOut(body);
  if (volume == 0)
    body.problem = "flat";
  return body;
}

inline Body bodyOfPrism(const Object &object) {
  Body body;
  const ExactVec3 &way = object[1];
  for (const std::size_t corner : halfspace::cornersOf(object))
    body.corners.push_back(object[corner]);
  const CornerList base = body.corners;
  const std::size_t count = base.size();
  body.names["\\vec h"] = quantity(way);
  body.faces = {{0}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    body.corners.emplace_back(base[i] + way);
    body.names[numbered("P", i)] = quantity(base[i]);
    if (i > 0)
      body.faces[0].push_back(count - i);
    body.faces[1].push_back(i + count);
    body.faces.push_back({i, next, next + count, i + count});
  }
  if (product(twiceAreaOf(base), way) < 0)
    turnInsideOut(body);
  body.problem = areInOnePlane(body.corners) ? "flat"
                 : !areInOnePlane(base)      ? "not-planar"
                 : !isConvex(base)           ? "not-convex"
                                             : nullptr;
  return body;
}

inline Body bodyOf(const Object &object) {
  return kindOf(object) == "box"           ? bodyOfBox(object)
         : kindOf(object) == "tetrahedron" ? bodyOfTetrahedron(object)
                                           : bodyOfPrism(object);
}

} // namespace halfspace::test
