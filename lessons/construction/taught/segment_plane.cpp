// Where a segment crosses a plane: f at its ends tells whether, and at which part of the way (note PG 3.4).
#include "geometry/case_names.h"
#include "geometry/intersect_segment_plane.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/several_planes.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/segment.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<SegmentObject> s;
  Given<PlaneObject> E;
};

struct Out : Computed<In>, SegmentTerms, PlaneTerms {
  explicit Out(const In &objects)
      : Computed(objects), SegmentTerms(termsOf(objects.s)), PlaneTerms(termsOf(objects.E)) {}

  SegmentPlane<Rational> meet = intersectSegmentPlane(in.s.object.from, in.s.object.to, planeOf(in.E.object));
  bool hasPlane = meet.which != SegmentPlaneCase::ZeroNormal;
  bool hasPoint = meet.which == SegmentPlaneCase::Crosses || meet.which == SegmentPlaneCase::Touches;
  /// Of the whole line.
  bool isMet = hasPoint || meet.which == SegmentPlaneCase::Beside;

  Term fA = applied(own(letter("f")), A, meet.atFrom);
  Term fB = applied(own(letter("f")), B, meet.atTo);
  Term t = ownName(letter("t"), meet.t);
  Term S = madeName("S", meet.point);
};

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.which) {
  case SegmentPlaneCase::Crosses:
    return {caseName,
            words("{f_A} and {f_B} have different signs: the segment {s} crosses the plane {E} in {point}.",
                  at.letters,
                  {{"f_A", equation(at.fA)}, {"f_B", equation(at.fB)}, {"point", equation(at.S)}})};
  case SegmentPlaneCase::Touches:
    return {caseName, words("f({end}) = 0: the segment {s} touches the plane {E} with its end {end} alone.",
                            at.letters, {{"end", plainText(at.meet.atFrom == 0 ? at.A : at.B)}})};
  case SegmentPlaneCase::Beside:
    return {caseName, words("{f_A} and {f_B} have the same sign: the whole segment {s} is on one side of the "
                            "plane {E} and does not reach it.",
                            at.letters, {{"f_A", equation(at.fA)}, {"f_B", equation(at.fB)}})};
  case SegmentPlaneCase::Parallel:
    return {caseName, words("{f_A}, and f({B}) is the same number: the segment {s} is parallel to the plane "
                            "{E}.",
                            at.letters, {{"f_A", equation(at.fA)}})};
  case SegmentPlaneCase::InPlane:
    return {caseName, words("f is 0 all along the segment {s}: it lies in the plane {E}.", at.letters)};
  case SegmentPlaneCase::ZeroLength:
    return {caseName, words("{A} and {B} are the same point: the segment {s} has no length.", at.letters),
            true};
  case SegmentPlaneCase::ZeroNormal:
    break;
  }
  return zeroNormalWords(at);
}

/// f at an end.
WorkingLine sideLine(const Out &at, const Term &f, const Term &end) {
  const WordValues letters{{"end", plainText(end)}, {"n", plainText(at.n)}};
  const Real &value = *numberOf(f);
  return asked(withNumbers(f == dot(at.n, end - at.P0)),
               sign(value) > 0 ? words("Positive: {end} lies on the side that {n} points to.", letters)
               : sign(value) < 0
                   ? words("Negative: {end} lies on the side that {n} points away from.", letters)
                   : words("0: {end} lies in the plane.", letters));
}

std::string partWords(const Out &at) {
  if (at.meet.t < 0)
    return words("Negative: the line of the segment meets the plane before {A}.", at.letters);
  if (at.meet.t > 1)
    return words("More than 1: the line of the segment meets the plane behind {B}.", at.letters);
  return at.meet.which == SegmentPlaneCase::Touches
             ? words("0 is {A}, and 1 is {B}: it is an end that lies in the plane.", at.letters)
             : words("Between 0 and 1: this part of the way from {A} to {B} leads to the plane.", at.letters);
}

WorkingLine partLine(const Out &at) {
  return asked(
      withNumbers(at.t == at.fA / (at.fA - at.fB)), partWords(at),
      {{at.fB / (at.fB - at.fA), words("{answer} is the part from {B} on: start at {A}.", at.letters)},
       {at.fA / (at.fA + at.fB),
        words("{answer} has a sum below the fraction line: f changes by the difference.")},
       {at.fA / (at.fB - at.fA),
        words("{answer} has the wrong sign: f({A}) is the first one below the fraction line, too.",
              at.letters)}});
}

WorkingLine pointLine(const Out &at) {
  return asked(withNumbers(at.S == at.A + at.t * (at.B - at.A)),
               words("The only point that the segment and the plane share."),
               {{at.B + at.t * (at.B - at.A), words("{answer} starts at {B}: start at {A}.", at.letters)}});
}

/// From an end straight to the plane, where it is not in it.
void drawHeight(Figure &figure, const Out &at, const char *name, const ExactVec3 &end) {
  const ExactVec3 up = projectVector(ExactVec3(end - at.in.E.object.point), at.in.E.object.normal).projection;
  const Place foot = place(ExactVec3(end - up));
  figure.reaches.push_back({at.in.E.id, foot});
  if (!isZero(up))
    figure.add(SegmentMark{{at.mark(name), Role::Helper, Subject::Measure}, place(end), foot});
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.hasPlane)
    return figure;
  const auto &[from, to] = at.in.s.object;
  drawHeight(figure, at, "fA", from);
  if (from != to)
    drawHeight(figure, at, "fB", to);
  if (at.hasPoint)
    figure.add(pointOf(at.S, Role::Result, Subject::Measure));
  return figure;
}

/// The last end brought into the plane, or as high as the first one; a parallel segment laid into the plane.
std::vector<SpecialCase> nearby(const Out &at) {
  const ExactVec3 &from = at.in.s.object.from;
  const ExactVec3 &to = at.in.s.object.to;
  const Plane<Rational> plane = planeOf(at.in.E.object);
  const Rational &before = at.meet.atFrom;
  const Rational &after = at.meet.atTo;
  std::vector<SpecialCase> all;
  const auto add = [&](const SegmentObject &changed, std::string sentence) {
    const auto which = intersectSegmentPlane(changed.from, changed.to, plane).which;
    if (which != at.meet.which && which != SegmentPlaneCase::ZeroLength)
      all.push_back({is("case", nameOf(which)), std::move(sentence), "s", changed});
  };
  /// Of a point moved along the normal until f is so much more.
  const auto lifted = [&](const ExactVec3 &point, const Rational &f) {
    return ExactVec3(point + plane.normal * Rational(f / dot(plane.normal, plane.normal)));
  };
  const auto layDown = [&] {
    add({lifted(from, -before), lifted(to, -after)}, words("The segment would lie in the plane."));
  };
  if (at.meet.which == SegmentPlaneCase::Parallel || (at.isMet && before == 0))
    layDown();
  if (!at.isMet || before == 0)
    return all;
  add({from, lifted(to, -after)}, words("The segment would touch the plane with {B}.", at.letters));
  add({from, lifted(to, Rational(before - after))}, words("The segment would be parallel to the plane."));
  return all;
}

} // namespace

Construction segment_plane() {
  return taught<Out, SegmentObject, PlaneObject>(
      {.id = "segment-plane",
       .word = "intersect",
       .title = [] { return words("where the segment crosses the plane"); },
       .roles = {"s", "E"},
       .makes = {{"S", &Out::hasPoint, &Out::S}},
       .letters = {"f", "t"},
       .cases = {"crosses", "touches", "beside", "parallel", "in-plane", "zero-length", "zero-normal"},
       .values = {{named::number("f_A"), &Out::hasPlane, &Out::fA},
                  {named::number("f_B"), &Out::hasPlane, &Out::fB},
                  {named::number("t"), &Out::isMet, &Out::t},
                  {named::vector("point"), &Out::hasPoint, &Out::S}},
       .lines = {{"f-A", &Out::hasPlane, [](const Out &at) { return sideLine(at, at.fA, at.A); }},
                 {"f-B", &Out::hasPlane, [](const Out &at) { return sideLine(at, at.fB, at.B); }},
                 {"t", &Out::isMet, partLine},
                 {"point", &Out::hasPoint, pointLine}},
       .marks = {"fA", "fB", "S"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
