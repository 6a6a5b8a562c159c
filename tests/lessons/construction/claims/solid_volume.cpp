#include "lessons/object/corners.h"
#include "lessons/object/kind.h"
#include "lessons/object/solid.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/flat_corners.h"

namespace halfspace::test {
namespace {

/// The corners alone tell: no tetrahedra are put together. Of a line the determinant is told by its numbers.
struct SolidAlone {
  explicit SolidAlone(Objects objects) : corners(meshOf(*objects[0]).vertices) {
    for (const std::size_t corner : cornersOf(*objects[0]))
      base.push_back((*objects[0])[corner]);
  }

  bool isFlat() const { return areInOnePlane(corners); }
  bool isSkew() const { return !base.empty() && !areInOnePlane(base); }
  bool isSelfMeeting() const {
    return !isFlat() && !isSkew() && !base.empty() && doesBoundaryMeetItself(base);
  }
  bool isSolid() const { return !isFlat() && !isSkew() && !isSelfMeeting(); }

  CornerList corners;
  CornerList base; ///< of a prism
};

bool hasVolume(const SolidAlone &at) { return !at.isSkew(); }
bool isFlat(const SolidAlone &at) { return at.isFlat(); }
bool isSelfMeeting(const SolidAlone &at) { return at.isSelfMeeting(); }
bool isSkew(const SolidAlone &at) { return at.isSkew(); }
bool isSolid(const SolidAlone &at) { return at.isSolid(); }

} // namespace

namespace claims {

Claims solid_volume() {
  return claimsAbout<SolidAlone>({
      {"The volume of the solid is {V}.", isSolid},
      {"All corners lie in one plane: the solid is flat and has no volume.", isFlat},
      {"The boundary of the base meets itself: {V} counts each part as often as the boundary goes round it, "
       "and "
       "negative where it goes the other way round.",
       isSelfMeeting},
      {"The corners of the base do not lie in one plane: it is no face, and there is no solid that has a "
       "volume.",
       isSkew},
      {"Six times the volume of a tetrahedron: from the first corner to three of a face.",
       [](const SolidAlone &at) { return hasVolume(at) && !at.isFlat(); }},
      // A tetrahedron and a box are convex: no corner sees a face of theirs from outside.
      {"Negative: seen from the first corner this part of a face is turned the other way round, and its "
       "tetrahedron is taken away.",
       [](const SolidAlone &at) { return hasVolume(at) && !at.isFlat() && !at.base.empty(); }},
      {"0: the first corner and these three lie in one plane.", hasVolume},
      {"Each determinant is six times the volume of its tetrahedron, with its sign.",
       [](const SolidAlone &at) { return hasVolume(at) && !at.isFlat(); }},
      {"0: a flat solid has no volume.", isFlat},
  });
}

} // namespace claims
} // namespace halfspace::test
