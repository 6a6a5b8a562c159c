// The six numbers of a line, its Plücker coordinates: direction and moment (note PL).
#include "geometry/line.h"
#include "geometry/point_line.h"
#include "lessons/construction/parts/line_moment.h"
#include "lessons/construction/parts/plucker_edges.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<LineObject> g;
};

Symbol distanceLetter(const In &in) {
  Symbol letter = word("dist");
  letter.owner = in.g.id;
  return letter;
}

struct Out : Computed<In>, LineTerms {
  explicit Out(const In &objects) : Computed(objects), LineTerms(termsOf(objects.g)) {}

  Line<Rational> line = lineAlong(in.g.object.point, in.g.object.direction);
  bool isReal = halfspace::isReal(line);
  bool meetsOrigin = passesThroughOrigin(line);

  Term m = momentOf(in.g).marked(mark("m"));
  /// The line's point nearest to the origin.
  Term N = name(besideLettersOf(in.g, letter("N")), isReal ? nearestToOrigin(line) : ExactVec3(0))
               .marked(mark("N"));
  Term dist = name(distanceLetter(in),
                   measurePointLine(ExactVec3(0), in.g.object.point, in.g.object.direction).distance)
                  .marked(mark("dist"));
};

CaseWords tell(const Out &at) {
  if (!at.isReal)
    return zeroLineWords(at, "zero-direction");
  if (at.meetsOrigin)
    return {"line",
            words("The moment is the zero vector: the line {g} goes through the origin.", at.letters)};
  return {"line", words("The six numbers of the line {g} are {direction} and {moment}.", at.letters,
                        {{"direction", equation(at.v)}, {"moment", equation(at.m)}})};
}

WorkingLine ownMomentLine(const Out &at) {
  return asked(withProducts(at.m == cross(at.A, at.v)),
               at.meetsOrigin
                   ? words("The moment: the zero vector, because the line goes through the origin.")
                   : words("The moment: perpendicular to the line, and to the arrow from the origin to {A}.",
                           at.letters),
               {{cross(at.v, at.A),
                 words("{answer} is the cross product the other way round: {v} × {A}.", at.letters)}});
}

WorkingLine sameLine(const Out &at) {
  return asked(withProducts(cross(at.N, at.v)),
               vectorOf(at.N) == vectorOf(at.A)
                   ? words("{point} is {A} itself here, so the moment is the same.", at.letters,
                           {{"point", equation(at.N)}})
                   : words("{point} is another point of the line, and gives the same moment as {A}.",
                           at.letters, {{"point", equation(at.N)}}),
               {{cross(at.v, at.N),
                 words("{answer} is the cross product the other way round: begin with the point.")}});
}

WorkingLine scaledLine(const Out &at) {
  return line(withResult(cross(at.A, 2 * at.v)),
              words("Twice the direction gives twice the moment: six other numbers for the same line."));
}

std::string relationWords(const Out &at) {
  return at.meetsOrigin
             ? words("Always 0, and here the cross product {A} × {v} is the zero vector.", at.letters)
             : words("Always 0: the cross product {A} × {v} is perpendicular to {v}.", at.letters);
}

WorkingLine nearestLine(const Out &at) {
  return asked(withNumbers(at.N == cross(at.v, at.m) / dot(at.v, at.v)),
               words("The point of the line that is nearest to the origin."),
               {{cross(at.m, at.v) / dot(at.v, at.v),
                 words("{answer} is on the other side of the origin: the direction comes first.")}});
}

WorkingLine distanceLine(const Out &at) {
  return asked(withNumbers(at.dist == norm(at.m) / norm(at.v)),
               at.meetsOrigin
                   ? words("A moment of zero: the line goes through the origin.")
                   : words("How far the line is from the origin. |{m}| alone says it only when |{v}| = 1.",
                           at.letters, {{"m", plainText(at.m)}}),
               {{norm(at.m) / dot(at.v, at.v),
                 words("{answer} is divided by {v}·{v}: divide by its root, |{v}|.", at.letters)}});
}

/// The moment stands on the plane through the origin and the line: the triangle from the origin to v.
void drawMoment(Figure &figure, const Out &at) {
  const Place start = place(at.A);
  const Place tip = start + place(at.v);
  figure.add(momentArrow(at.m, at.in.g.look));
  PolygonMark triangle{{at.m->mark + "/triangle", Role::Helper, Subject::Measure}, {}};
  triangle.corners = {Place(0), start, tip};
  figure.add(std::move(triangle));
  figure.add(
      RightAngleMark{{at.m->mark + "/angle", Role::Helper, Subject::Measure}, Place(0), place(at.m), start});
}

/// The way from the origin to the nearest point.
void drawDistance(Figure &figure, const Out &at) {
  const Place nearest = place(at.N);
  figure.add(SegmentMark{drawn(at.dist, Role::Result, Subject::Measure), Place(0), nearest});
  figure.add(RightAngleMark{
      {at.dist->mark + "/angle", Role::Helper, Subject::Measure}, nearest, -nearest, place(at.v)});
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.isReal)
    return figure;
  figure.reaches = {{at.in.g.id, place(at.N)}};
  if (!at.meetsOrigin) {
    drawMoment(figure, at);
    drawDistance(figure, at);
  }
  figure.add(pointOf(at.N, Role::Result, Subject::Measure));
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  if (!at.isReal || at.meetsOrigin)
    return {};
  const auto &[point, direction] = at.in.g.object;
  return {{is("through_origin", "true"), words("The line would go through the origin."), "g",
           LineObject{point - nearestToOrigin(at.line), direction}}};
}

} // namespace

Construction line_pluecker() {
  return taught<Out, LineObject>(
      {.id = "line-pluecker",
       .title = [] { return words("Plücker coordinates of the lines"); },
       .roles = {"g"},
       .cases = {"line", "zero-direction"},
       .values = {{named::vector("direction"), &Out::isReal, [](const Out &at) { return at.v; }},
                  {named::vector("moment"), &Out::isReal, &Out::m},
                  {named::number("relation"), &Out::isReal, [](const Out &at) { return dot(at.v, at.m); }},
                  {named::word("through_origin", {"true", "false"}), &Out::isReal,
                   [](const Out &at) {
                     return ToldValue(words("through the origin"), trueOrFalse(at.meetsOrigin));
                   }},
                  {named::vector("nearest_to_origin"), &Out::isReal, &Out::N},
                  {named::number("origin_distance"), &Out::isReal, &Out::dist}},
       .lines = {{"moment", &Out::isReal, ownMomentLine},
                 {"scaled", &Out::isReal, scaledLine},
                 {"relation", &Out::isReal, [](const Out &at) { return withProducts(dot(at.v, at.m)); },
                  relationWords},
                 {"nearest", &Out::isReal, nearestLine},
                 {"same", &Out::isReal, sameLine},
                 {"distance", &Out::isReal, distanceLine}},
       .marks = {"m", "dist", "N"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
