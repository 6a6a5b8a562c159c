#include "lessons/construction/parts/sided_points.h"

#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace halfspace {
namespace {

/// A ring that lies in the plane around a point of it: three thirds of a circle.
void drawRing(Figure &figure, const MarkBase &base, const Place &center, const ExactVec3 &normal) {
  const Place axis = unitOf(normal);
  const Place across =
      glm::normalize(glm::cross(axis, std::abs(axis.z) < 0.9 ? Place(0, 0, 1) : Place(1, 0, 0)));
  const Place along = glm::cross(axis, across);
  const double half = std::sqrt(0.75);
  const std::array thirds{across, -0.5 * across + half * along, -0.5 * across - half * along};
  for (std::size_t i = 0; i < thirds.size(); ++i) {
    MarkBase third = base;
    third.id = partOf(base.id, i);
    if (i > 0)
      third.numbers.clear();
    figure.add(ArcMark{std::move(third), center, thirds.at(i), thirds.at((i + 1) % thirds.size())});
  }
}

} // namespace

SidedPoint sidedPoint(const Naming &naming, const std::string &role, const Given<PlaneObject> &plane,
                      const Given<PointObject> &point) {
  const auto &[through, normal] = plane.object;
  const auto measured = measurePointPlane(point.object.at, planeThrough(through, normal));
  const Term at = termOf(point);
  return {role, at, applied(naming.own(letter("f")), at, measured.f).marked(naming.mark("side-" + role)),
          measured};
}

std::string namesOf(const std::vector<Term> &points) {
  std::string names;
  for (const Term &point : points)
    names += (names.empty() ? "" : ", ") + plainText(point);
  return names;
}

WorkingLine valueLine(const Naming &naming, const PlaneTerms &plane, const SidedPoint &sided) {
  const Term &point = sided.point;
  return asked(
      withNumbers(sided.f == dot(plane.n, point - plane.P0)), {},
      {{dot(plane.n, point), words("{answer} is {n}·{point}: {P0} is to be subtracted from {point} first.",
                                   naming.letters, {{"point", plainText(point)}})}});
}

void drawSide(Figure &figure, const Given<PlaneObject> &plane, const SidedPoint &sided, std::string number) {
  const Place point = place(sided.point);
  const Place foot = place(sided.measured.foot);
  const auto base = [&](Role role, Subject subject) {
    MarkBase mark{sided.f->mark, role, subject};
    mark.numbers = std::move(number);
    return mark;
  };
  switch (sided.measured.which) {
  case PointPlaneCase::Positive:
    figure.add(inLook(plane.look, SegmentMark{base(Role::Derived, Subject::Plane), foot, point}));
    break;
  case PointPlaneCase::Negative:
    figure.add(SegmentMark{base(Role::Helper, Subject::EdgeV), foot, point});
    break;
  case PointPlaneCase::On:
    drawRing(figure, base(Role::Derived, Subject::Neutral), point, plane.object.normal);
    break;
  case PointPlaneCase::ZeroNormal:
    return;
  }
  figure.reaches.push_back({plane.id, foot});
}

void addIntoPlane(const PlaneObject &plane, const SidedPoint &sided, const Conditions &when,
                  std::vector<SpecialCase> &all) {
  if (sided.measured.which == PointPlaneCase::On)
    return;
  const WordValues letters{{"point", plainText(sided.point)}};
  const ExactVec3 &foot = sided.measured.foot;
  all.push_back({when, words("{point} would lie in the plane.", letters), sided.role, PointObject{foot}});
  all.push_back({when, words("The plane would go through {point}.", letters), "E",
                 PlaneObject{plane.point + vectorOf(sided.point) - foot, plane.normal}});
}

} // namespace halfspace
