#include "tests/lessons/construction/claims/line_at_plane.h"

namespace halfspace::test {
namespace {

bool meetOnce(const LineAtPlane &at) { return at.vn != 0; }
bool areParallel(const LineAtPlane &at) { return at.isAlong() && !at.isPointInPlane(); }
bool isInPlane(const LineAtPlane &at) { return at.isAlong() && at.isPointInPlane(); }
bool isLine(const LineAtPlane &at) { return at.isLine(); }
bool isPlane(const LineAtPlane &at) { return at.isPlane(); }

} // namespace

namespace claims {

Claims line_plane() {
  return claimsAbout<LineAtPlane>({
      {"The weight {w} is not 0: the line {g} meets the plane {E} in {point}.", meetOnce},
      {"The weight is 0 and X is not: the line {g} is parallel to the plane {E}. They meet at infinity only.",
       areParallel},
      {"All four numbers are 0: the line {g} lies in the plane {E}.", isInPlane},
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
       [](const LineAtPlane &at) { return !at.isPlane(); }},
      {"The direction {v} is the zero vector: it points nowhere, so there is no line.",
       [](const LineAtPlane &at) { return !at.isLine(); }},
      {"The constant of {E}: its equation is {n}·P + {d} = 0.", isPlane},
      {"The moment of {g}.", isLine},
      {"The common point, times its weight.", meetOnce},
      {"A multiple of {v}: there is no common point, only the direction is left.", areParallel},
      {"All zero: no point of the line is special, because each is a common one.", isInPlane},
      {"Zero: {v} is perpendicular to {n}, so the line comes no nearer to the plane.",
       [](const LineAtPlane &at) { return at.isAlong(); }},
      {"The weight. It is 0 only when the line is parallel to the plane, or lies in it.", meetOnce},
      {"Divided by the weight: the common point.", meetOnce},
  });
}

} // namespace claims
} // namespace halfspace::test
