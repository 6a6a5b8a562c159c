// How far a point is from a line, by its foot (note PG 6.1: the part of a vector along another).
#include "geometry/point_line.h"
#include "geometry/case_names.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/letters.h"
#include "lessons/term/latex.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<PointObject> Q;
  Given<LineObject> g;
};

struct Out : Naming, LineTerms {
  PointLine<Rational> measured;
  Term Q, w;
  Term t, F;
  Term h, dist; ///< from the foot to Q, and its length
};

Out compute(const In &in) {
  const LineTerms g = termsOf(in.g);
  const Term Q = termOf(in.Q);
  const auto &[through, direction] = in.g.object;
  const ExactVec3 &point = in.Q.object.at;
  const auto measured = measurePointLine(point, through, direction);
  return {in,
          g,
          measured,
          Q,
          name(in.own(vectorLetter("w")), ExactVec3(point - through)).marked(in.mark("w")),
          name(in.own(letter("t")), measured.t),
          madeName(in, "F", measured.foot),
          name(in.own(vectorLetter("h")), ExactVec3(point - measured.foot)).marked(in.mark("h")),
          name(in.own(word("dist")), measured.distance).marked(in.mark("h"))};
}

CaseWords tell(const In &, const Out &at) {
  const std::string caseName(nameOf(at.measured.which));
  switch (at.measured.which) {
  case PointLineCase::Off:
    return {caseName, words("{Q} is beside the line {g}: {distance}.", at.letters,
                            {{"distance", equation(name(word("distance"), at.dist->value))}})};
  case PointLineCase::On:
    return {caseName, words("{Q} lies on the line {g}, and is its own foot.", at.letters)};
  case PointLineCase::ZeroDirection:
    break;
  }
  return {caseName,
          words("The direction {v} is the zero vector: it points nowhere, so there is no line.", at.letters),
          true};
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  if (at.measured.which == PointLineCase::ZeroDirection)
    return {};
  return {listed("t", at.t), listed("foot", at.F), listed("distance", at.dist)};
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (at.measured.which == PointLineCase::ZeroDirection)
    return {};
  return {{"F", PointObject{at.measured.foot}}};
}

WorkingLine wayLine(const Out &at) {
  return asked(withNumbers(at.w == at.Q - at.A), words("From {A} to {Q}.", at.letters));
}

WorkingLine parameterLine(const Out &at) {
  const Term wv = dot(at.w, at.v);
  const Term vv = dot(at.v, at.v);
  return asked(withNumbers(at.t == wv / vv),
               words("So many steps {v} lead from {A} to the foot: how far w reaches along {v}.", at.letters),
               {{wv, words("{answer} is w·{v}: divide by {v}·{v}.", at.letters)},
                {wv / norm(at.v), words("{answer} is divided by |{v}|: divide by {v}·{v}.", at.letters)}});
}

WorkingLine footLine(const Out &at) {
  return asked(withNumbers(at.F == at.A + at.t * at.v),
               words("The foot: the line's point nearest to {Q}.", at.letters));
}

WorkingLine perpendicularLine(const Out &at) {
  return asked(withNumbers(at.h == at.Q - at.F),
               words("From the foot to {Q}. It is perpendicular to the line: its dot product with {v} is 0.",
                     at.letters));
}

WorkingLine distanceLine(const Out &at) {
  return asked(withProducts((at.dist == norm(at.h)) == root(dot(at.h, at.h))),
               words("The distance is the length of this arrow."),
               {{dot(at.h, at.h), words("{answer} is h·h: its root is still to be taken.")}});
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  lines.add("w", [&at] { return wayLine(at); });
  if (at.measured.which == PointLineCase::ZeroDirection)
    return lines;
  lines.add("t", [&at] { return parameterLine(at); });
  lines.add("foot", [&at] { return footLine(at); });
  lines.add("h", [&at] { return perpendicularLine(at); });
  lines.add("distance", [&at] { return distanceLine(at); });
  return lines;
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  const Place q = place(at.Q);
  const Place through = place(at.A);
  if (q != through)
    figure.add(arrowOf(at.w, through, Role::Derived, Subject::Point));
  if (at.measured.which == PointLineCase::ZeroDirection)
    return figure;
  const Place foot = place(at.F);
  figure.add(pointOf(at.F, Role::Result, Subject::Measure));
  figure.reaches = {{in.g.id, foot}};
  if (at.measured.which == PointLineCase::On)
    return figure;
  figure.add(SegmentMark{{at.F->mark + "/way", Role::Helper, Subject::Measure}, foot, q});
  MarkBase way = drawn(at.h, Role::Result, Subject::Measure);
  figure.add(ArrowMark{std::move(way), foot, q - foot});
  figure.add(
      RightAngleMark{{at.F->mark + "/angle", Role::Helper, Subject::Measure}, foot, q - foot, place(at.v)});
  return figure;
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  std::vector<SpecialCase> all;
  if (at.measured.which == PointLineCase::ZeroDirection)
    return all;
  const auto &[through, direction] = in.g.object;
  const ExactVec3 &point = in.Q.object.at;
  if (at.measured.which == PointLineCase::Off)
    all.push_back(
        {"case = on", words("{Q} would lie on the line.", at.letters), "Q", PointObject{at.measured.foot}});
  if (at.measured.t != 0)
    all.push_back({"t = 0", words("The foot of {Q} would be {A}.", at.letters), "Q",
                   PointObject{ExactVec3(point - direction * at.measured.t)}});
  return all;
}

} // namespace

Construction point_line() {
  return makeConstruction<In, Out, PointObject, LineObject>(
      "point-line", {"Q", "g"}, {{"F", "point"}}, {"w", "t", "h", "dist"},
      {.cases = {"off", "on", "zero-direction"},
       .values = {named::number("t"), named::vector("foot"), named::number("distance")},
       .lines = {"w", "t", "foot", "h", "distance"},
       .marks = {"w", "F", "h"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
