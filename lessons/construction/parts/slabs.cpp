#include "lessons/construction/parts/slabs.h"

#include "lessons/construction/parts/ray_marks.h"
#include "lessons/construction/parts/sorted_line.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

Slab slabOf(const Naming &naming, const Given<BoxObject> &box, const Given<RayObject> &ray,
            const RayBox<Rational> &meet, std::size_t place) {
  const auto [P0, lengths] = termsOf(box);
  const auto [Q, r] = termsOf(ray);
  const auto axis = static_cast<int>(place);
  const std::string index = axisNames.at(place);
  const SlabCrossing<Rational> &crossing = meet.slabs.at(place);
  Symbol lowest = box.letters[0]; // x₀ of P₀
  lowest.letter = index;
  const Term low = componentOf(P0, lowest, axis);
  const auto own = [&](const Symbol &symbol, const TermValue &value, const char *mark) {
    return name(naming.own(indexed(symbol, index)), value).marked(naming.mark(mark + index));
  };
  const auto pointAfter = [&](const Rational &t) {
    return ExactVec3(ray.object.origin + ray.object.direction * t);
  };
  return {place,
          crossing,
          low,
          low + lengths.at(place),
          componentOf(Q, indexed(ray.letters[0], index), axis),
          componentOf(r, indexed(ray.letters[1], index), axis),
          own(word("in"), crossing.in, "in-"),
          own(word("out"), crossing.out, "out-"),
          own(letter("A"), pointAfter(crossing.in), "in-"),
          own(letter("B"), pointAfter(crossing.out), "out-")};
}

std::string wayInWords(const Slab &slab) {
  const WordValues values{
      {"step", plainText(slab.step)}, {"axis", slab.axisName()}, {"plane", slab.nameOf(slab.near())}};
  if (slab.isFlat())
    return words("The two planes of the {axis} slab are one: {plane}.", values);
  return slab.isForwards()
             ? words("{step} is positive, so {axis} grows: the plane {plane} comes first.", values)
             : words("{step} is negative, so {axis} shrinks: the plane {plane} comes first.", values);
}

/// Where the line goes through one of the slab's planes.
WorkingLine crossingLine(const Slab &slab, const Term &t, const Term &plane, const Term &other,
                         std::string sentence) {
  return asked(
      withNumbers(t == (plane - slab.start) / slab.step), std::move(sentence),
      {{(other - slab.start) / slab.step,
        words("{answer} belongs to the other plane, {other}: here it is {plane}.",
              {{"plane", slab.nameOf(plane)}, {"other", slab.nameOf(other)}})},
       {plane - slab.start,
        words("{answer} is not divided yet by {step}.", {{"step", plainText(slab.step)}})},
       {plane / slab.step, words("{answer} is right only where {start} is 0: take {start} away first.",
                                 {{"start", plainText(slab.start)}})}});
}

std::string startWords(const Slab &slab) {
  const WordValues values{
      {"start", plainText(slab.start)}, {"step", plainText(slab.step)}, {"axis", slab.axisName()}};
  switch (slab.crossing.which) {
  case SlabCase::Within:
    return words("The start is in the {axis} slab, and {step} = 0: the ray never leaves this slab.", values);
  case SlabCase::Beside:
    return words("The start is not in the {axis} slab, and {step} = 0: the ray never comes into this slab.",
                 values);
  case SlabCase::Crossed:
    break;
  }
  return slab.hasStart() ? words("The start is in the {axis} slab.", values)
                         : words("The start is not in the {axis} slab.", values);
}

/// A plane of a slab is drawn so much beyond what lies in it: this part of the box's longest side.
constexpr double planeMargin = 0.3;

/// The box's face in a plane of the slab, a little larger; so large that it has the point where the line goes
/// through, if that is no farther away than the box is long.
PolygonMark patchOf(const Slab &slab, const Term &plane, const Term &point, const BoxObject &box,
                    MarkBase base) {
  const Place low = place(box.lowest);
  const Place high = place(box.highest());
  const double longest = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const double unit = longest > 0 ? longest : 1;
  const auto across = static_cast<int>(slab.axis);
  const auto ends = [&](int axis) {
    const double through = slab.isCrossed() ? place(point)[axis] : low[axis];
    return std::pair(std::clamp(through, low[axis] - unit, low[axis]) - planeMargin * unit,
                     std::clamp(through, high[axis], high[axis] + unit) + planeMargin * unit);
  };
  const int u = (across + 1) % 3;
  const int v = (across + 2) % 3;
  const auto [lowU, highU] = ends(u);
  const auto [lowV, highV] = ends(v);
  PolygonMark patch{std::move(base), {}};
  for (const auto &[atU, atV] : {std::pair(lowU, lowV), {highU, lowV}, {highU, highV}, {lowU, highV}}) {
    Place corner{};
    corner[across] = toDouble(rationalOf(plane));
    corner[u] = atU;
    corner[v] = atV;
    patch.corners.push_back(corner);
  }
  return patch;
}

} // namespace

bool Slab::isForwards() const { return rationalOf(step) > 0; }
bool Slab::isFlat() const { return rationalOf(low) == rationalOf(high); }
bool Slab::hasStart() const {
  return rationalOf(low) <= rationalOf(start) && rationalOf(start) <= rationalOf(high);
}
std::string Slab::nameOf(const Term &plane) const { return axisName() + relatedText(calculated(plane)); }

std::array<Slab, 3> slabsOf(const Naming &naming, const Given<BoxObject> &box, const Given<RayObject> &ray,
                            const RayBox<Rational> &meet) {
  return {slabOf(naming, box, ray, meet, 0), slabOf(naming, box, ray, meet, 1),
          slabOf(naming, box, ray, meet, 2)};
}

WorkingLine wayInLine(const Slab &slab) {
  return crossingLine(slab, slab.in, slab.near(), slab.far(), wayInWords(slab));
}

WorkingLine wayOutLine(const Slab &slab) {
  return crossingLine(slab, slab.out, slab.far(), slab.near(),
                      words("The line leaves the {axis} slab through the plane {plane}.",
                            {{"axis", slab.axisName()}, {"plane", slab.nameOf(slab.far())}}));
}

WorkingLine startLine(const Slab &slab) {
  return sortedLine({slab.low, slab.start, slab.high}, startWords(slab));
}

void drawSlab(Figure &figure, const Naming &naming, const Slab &slab, const Given<BoxObject> &box,
              const Given<RayObject> &ray) {
  const Subject subject = std::array{Subject::Plane, Subject::EdgeV, Subject::Measure}.at(slab.axis);
  const std::string id = naming.mark("slab-" + slab.axisName());
  const auto base = [&](const char *part, const Term &plane) {
    return MarkBase{id + part, Role::Helper, subject, slab.axisName() + relatedLatex(calculated(plane))};
  };
  figure.add(patchOf(slab, slab.near(), slab.inPoint, box.object, base("", slab.near())));
  figure.add(patchOf(slab, slab.far(), slab.outPoint, box.object, base("/far", slab.far())));
  if (!slab.isCrossed() || isZero(ray.object.direction))
    return;
  for (const auto &[point, t] :
       {std::pair(slab.inPoint, slab.crossing.in), {slab.outPoint, slab.crossing.out}}) {
    addWayTo(figure, ray, point, t >= 0);
    figure.add(pointOf(point, t >= 0 ? Role::Derived : Role::Ghost, subject));
  }
}

Word wordOf(SlabCase which) {
  switch (which) {
  case SlabCase::Crossed:
    return {"crossed", words("crossed")};
  case SlabCase::Within:
    return {"within", words("always in it")};
  case SlabCase::Beside:
    break;
  }
  return {"beside", words("never in it")};
}

} // namespace halfspace
