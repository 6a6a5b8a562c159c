#include "lessons/object/kinds/polygon.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/flat_corners.h"

namespace halfspace::test {
namespace {

struct CornersAround {
  explicit CornersAround(Objects objects)
      : corners(objectAs<PolygonObject>(*objects[0])->corners), isLine(areOnOneLine(corners)),
        isPlanar(areInOnePlane(corners)) {}

  bool isFace() const { return isPlanar && !isLine; }
  bool isSimple() const { return isFace() && !doesBoundaryMeetItself(corners); }
  bool isSelfMeeting() const { return isFace() && doesBoundaryMeetItself(corners); }

  CornerList corners;
  bool isLine;
  bool isPlanar;
};

bool isSimple(const CornersAround &at) { return at.isSimple(); }
bool isSelfMeeting(const CornersAround &at) { return at.isSelfMeeting(); }
bool isLine(const CornersAround &at) { return at.isLine; }
bool isSkew(const CornersAround &at) { return !at.isPlanar; }

} // namespace

namespace claims {

Claims polygon_area() {
  return claimsAbout<CornersAround>({
      {"The boundary does not meet itself. The area of the polygon is {A}.", isSimple},
      {"The boundary meets itself: {A} counts each part as often as the boundary goes round it, and negative "
       "where it goes the other way round.",
       isSelfMeeting},
      {"All corners lie on one line: no area is left.", isLine},
      {"The corners do not lie in one plane: no flat polygon is there that has an area.", isSkew},
      {"Its length is twice the area of the triangle of {first}, {second} and {third}.", always},
      {"All triangles together. Where one goes round the other way its vector points backwards, and it is "
       "taken "
       "away.",
       [](const CornersAround &at) { return at.isPlanar; }},
      {"All triangles together. They do not lie in one plane.", isSkew},
      {"Half of the length: the area of the polygon.", isSimple},
      {"Half of the length: each part counts as often as the boundary goes round it, and negative where it "
       "goes "
       "the other way round.",
       isSelfMeeting},
      {"0: the corners lie on one line.", isLine},
  });
}

} // namespace claims
} // namespace halfspace::test
