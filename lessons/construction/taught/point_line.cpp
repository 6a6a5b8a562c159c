// How far a point is from a line, by its foot (note PG 6.1: the part of a vector along another).
#include "geometry/point_line.h"
#include "geometry/case_names.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/line.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PointObject> Q;
  Given<LineObject> g;
};

struct Out : Computed<In>, LineTerms {
  explicit Out(const In &objects) : Computed(objects), LineTerms(termsOf(objects.g)) {}

  PointLine<Rational> measured = measurePointLine(in.Q.object.at, in.g.object.point, in.g.object.direction);
  bool hasLine = measured.which != PointLineCase::ZeroDirection;

  Term Q = termOf(in.Q);
  Term w = drawnName(vectorLetter("w"), ExactVec3(in.Q.object.at - in.g.object.point));
  Term t = ownName(letter("t"), measured.t);
  Term F = madeName("F", measured.foot);
  Term h = drawnName(vectorLetter("h"), ExactVec3(in.Q.object.at - measured.foot));
  Term dist = ownName(word("dist"), measured.distance).marked(mark("h")); ///< the length of h
};

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.measured.which));
  switch (at.measured.which) {
  case PointLineCase::Off:
    return {caseName, words("{Q} is beside the line {g}: {distance}.", at.letters,
                            {{"distance", equation(name(word(words("distance")), at.dist->value))}})};
  case PointLineCase::On:
    return {caseName, words("{Q} lies on the line {g}, and is its own foot.", at.letters)};
  case PointLineCase::ZeroDirection:
    break;
  }
  return zeroLineWords(at, caseName);
}

WorkingLine parameterLine(const Out &at) {
  const Term wv = dot(at.w, at.v);
  const Term vv = dot(at.v, at.v);
  return asked(
      withNumbers(at.t == wv / vv),
      words("It takes this many steps {v} to get from {A} to the foot: there the part of w along {v} ends.",
            at.letters),
      {{wv, words("{answer} is w·{v}: divide by {v}·{v}.", at.letters)},
       {wv / norm(at.v), words("{answer} is divided by |{v}|: divide by {v}·{v}.", at.letters)}});
}

WorkingLine distanceLine(const Out &at) {
  return asked(withProducts((at.dist == norm(at.h)) == root(dot(at.h, at.h))),
               words("The distance is the length of this arrow."),
               {{dot(at.h, at.h), words("{answer} is h·h: its root is still to be taken.")}});
}

Figure draw(const Out &at) {
  Figure figure;
  const Place q = place(at.Q);
  const Place through = place(at.A);
  if (q != through)
    figure.add(arrowOf(at.w, through, Role::Derived, Subject::Point));
  if (!at.hasLine)
    return figure;
  const Place foot = place(at.F);
  figure.add(pointOf(at.F, Role::Result, Subject::Measure));
  figure.reaches = {{at.in.g.id, foot}};
  if (at.measured.which == PointLineCase::On)
    return figure;
  figure.add(SegmentMark{{at.F->mark + "/way", Role::Helper, Subject::Measure}, foot, q});
  MarkBase way = drawn(at.h, Role::Result, Subject::Measure);
  figure.add(ArrowMark{std::move(way), foot, q - foot});
  figure.add(
      RightAngleMark{{at.F->mark + "/angle", Role::Helper, Subject::Measure}, foot, q - foot, place(at.v)});
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.hasLine)
    return all;
  const auto &[through, direction] = at.in.g.object;
  const ExactVec3 &point = at.in.Q.object.at;
  if (at.measured.which == PointLineCase::Off)
    all.push_back({is("case", "on"), words("{Q} would lie on the line.", at.letters), "Q",
                   PointObject{at.measured.foot}});
  if (at.measured.t != 0)
    all.push_back({is("t", "0"), words("The foot of {Q} would be {A}.", at.letters), "Q",
                   PointObject{ExactVec3(point - direction * at.measured.t)}});
  return all;
}

} // namespace

Construction point_line() {
  return taught<Out, PointObject, LineObject>(
      {.id = "point-line",
       .word = "distance",
       .title = [] { return words("distance from the line"); },
       .roles = {"Q", "g"},
       .makes = {{"F", &Out::hasLine, &Out::F}},
       .letters = {"w", "t", "h", "dist"},
       .cases = {"off", "on", "zero-direction"},
       .values = {{named::number("t"), &Out::hasLine, &Out::t},
                  {named::vector("foot"), &Out::hasLine, &Out::F},
                  {named::number("distance"), &Out::hasLine, &Out::dist}},
       .lines =
           {{"w", always, [](const Out &at) { return withNumbers(at.w == at.Q - at.A); },
             says("From {A} to {Q}.")},
            {"t", &Out::hasLine, parameterLine},
            {"foot", &Out::hasLine, [](const Out &at) { return withNumbers(at.F == at.A + at.t * at.v); },
             says("The foot: the line's point nearest to {Q}.")},
            {"h", &Out::hasLine, [](const Out &at) { return withNumbers(at.h == at.Q - at.F); },
             says("From the foot to {Q}. It is perpendicular to the line: its dot product with {v} is 0.")},
            {"distance", &Out::hasLine, distanceLine}},
       .marks = {"w", "F", "h"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
