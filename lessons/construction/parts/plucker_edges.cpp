#include "lessons/construction/parts/plucker_edges.h"

#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/letters.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

/// The part of an edge that its arrow covers: the head stands clear of the corner, near the middle.
constexpr double arrowPart = 0.6;

} // namespace

EdgeTerms edgeTerms(const Naming &naming, std::size_t index, const Line<Rational> &edge,
                    const Rational &product, const Term &from, const Term &way) {
  const std::string number = std::to_string(index);
  const Term p = drawnName(naming, letter("p", number), product);
  const Term e = ownName(naming, vectorLetter("e", number), edge.direction).marked(p->mark).standingFor(way);
  const Term m = ownName(naming, vectorLetter("m", number), edge.moment).standingFor(cross(from, e));
  return {e, m, p, product};
}

WorkingLine momentLine(const Term &moment, const Term &point, const Term &direction, std::string sentence) {
  return asked(withProducts(moment == cross(point, direction)), std::move(sentence),
               {{cross(direction, point),
                 words("{answer} is the cross product the other way round: begin with the point.")}});
}

std::vector<WrongTerm> productMistakes(const Term &d1, const Term &m1, const Term &d2, const Term &m2) {
  return {{dot(d1, d2) + dot(m1, m2),
           words("{answer} multiplies direction by direction and moment by moment: cross over, each "
                 "direction with the other line's moment.")},
          {dot(d1, m1) + dot(d2, m2),
           words("{answer} multiplies each direction by its own line's moment: take the other's.")},
          {dot(d1, m2) - dot(d2, m1), words("{answer} subtracts the second product: the two are added.")}};
}

WorkingLine productLine(const RayTerms &ray, const Term &m, const EdgeTerms &edge, std::string sentence) {
  return asked(
      withNumbers((edge.p == permuted(ray.r, m, edge.e, edge.m)) == dot(ray.r, edge.m) + dot(edge.e, m)),
      std::move(sentence), productMistakes(ray.r, m, edge.e, edge.m));
}

void addEdge(Figure &figure, const EdgeTerms &edge, const Term &from, const Term &to, std::string numbers) {
  if (isZero(vectorOf(edge.e)))
    return;
  const Subject subject = edge.product > 0   ? Subject::EdgeU
                          : edge.product < 0 ? Subject::EdgeV
                                             : Subject::Measure;
  MarkBase base = drawn(edge.p, Role::Derived, subject);
  base.numbers = std::move(numbers);
  figure.add(SegmentMark{std::move(base), place(from), place(to)});
  figure.add(
      ArrowMark{{edge.p->mark + "/way", Role::Derived, subject}, place(from), place(edge.e) * arrowPart});
}

} // namespace halfspace
