#include "lessons/construction/parts/made_plane.h"

#include "lessons/construction/parts/several_planes.h"

#include <utility>

namespace halfspace {

PlaneTerms madePlane(const Naming &naming, const std::string &name, const Term &point,
                     const TermValue &normal) {
  return {madeName(naming, name, "P0", point->value).standingFor(point), madeName(naming, name, "n", normal)};
}

PlaneObject planeOf(const PlaneTerms &plane) { return {vectorOf(plane.P0), vectorOf(plane.n)}; }

void addMadePlane(Figure &figure, const Naming &naming, const std::string &name, const PlaneTerms &plane,
                  const Look &look) {
  const Place point = place(plane.P0);
  MarkBase patch{naming.mark(name), Role::Result, Subject::Measure, latexOf(naming.made.at(name).symbol)};
  patch.numbers = "\\colon\\ {" + latexOf(equationOf(plane)) + "}";
  figure.add(inLook(look, PlanePatchMark{std::move(patch), point, place(plane.n), {}}));
  ArrowMark normal = arrowOf(plane.n, point, Role::Result, Subject::Measure);
  normal.isFree = true;
  figure.add(inLook(look, std::move(normal)));
  figure.add(inLook(look, pointOf(plane.P0, Role::Derived, Subject::Measure)));
}

WorkingLine constantLine(const Term &d, const PlaneTerms &plane, std::string sentence) {
  return asked(withProducts(d == -dot(plane.n, plane.P0)), std::move(sentence));
}

WorkingLine equationLine(const Naming &naming, const std::string &name, const PlaneTerms &plane,
                         const Term &d) {
  const Term left = dot(plane.n, anyPoint()) + d;
  return askedEquation(condition((0 == left).then(calculated(left).marked(naming.mark(name)))),
                       words("A point P = (x, y, z) lies in {plane} exactly when it makes this 0.",
                             {{"plane", plainText(naming.made.at(name).symbol)}}));
}

ToldValue coefficientsValue(const PlaneTerms &plane) {
  const auto &[normal, offset] = planeOf(planeOf(plane));
  return {list({unknown("a"), unknown("b"), unknown("c"), unknown("d")}),
          std::vector<Surd>{normal.x, normal.y, normal.z, offset}};
}

} // namespace halfspace
