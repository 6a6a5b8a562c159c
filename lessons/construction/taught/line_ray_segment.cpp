// One formula, A + t v, for a line, a ray and a segment; and whether a point is on them, which each of its
// coordinates is asked for itself.
#include "geometry/place_on_line.h"
#include "geometry/point_line.h"
#include "lessons/construction/parts/components.h"
#include "lessons/construction/parts/sorted_line.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/line.h"

#include <algorithm>

namespace halfspace {
namespace {

struct In : Naming {
  Given<LineObject> g;
  Given<PointObject> P; ///< one that is meant to be on the line
  Given<PointObject> Q; ///< one of which that is asked
};

PlaceOnLine<Rational> placeOf(const In &in, const Given<PointObject> &point) {
  return placeOnLine(point.object.at, in.g.object.point, in.g.object.direction);
}

/// A coordinate of Q and of the line.
struct Asking {
  std::string axis;
  Term A, v, Q; ///< A_x, v_x, Q_x
  Term t;       ///< t_x, which leads from A_x to Q_x
  bool hasSteps;
  bool isRight; ///< A_x is Q_x

  /// Whether no t leads to Q, for the sake of this coordinate alone.
  [[nodiscard]] bool isNever() const { return !hasSteps && !isRight; }
};

Asking askingOf(const In &in, const LineTerms &line, const Term &Q, const PlaceOnLine<Rational> &place,
                std::size_t index) {
  const std::string axis = axisNames.at(index);
  const auto component = static_cast<int>(index);
  const auto &steps = place.steps.at(index);
  return {axis,
          componentOf(line.A, indexed(in.g.letters[0], axis), component),
          componentOf(line.v, indexed(in.g.letters[1], axis), component),
          componentOf(Q, indexed(in.Q.symbol, axis), component),
          drawnName(in, letter("t", axis), steps.value_or(0)),
          steps.has_value(),
          in.Q.object.at[component] == in.g.object.point[component]};
}

struct Out : Computed<In>, LineTerms {
  explicit Out(const In &objects) : Computed(objects), LineTerms(termsOf(objects.g)) {}

  PlaceOnLine<Rational> walked = placeOf(in, in.P);
  PlaceOnLine<Rational> sought = placeOf(in, in.Q);
  bool isLine = walked.which != LinePlace::ZeroDirection;
  bool isWalked = isLine && walked.which != LinePlace::Off;
  bool isReached = isLine && sought.which != LinePlace::Off;

  Term P = termOf(in.P);
  Term Q = termOf(in.Q);
  Term B = madeName("B", ExactVec3(in.g.object.point + in.g.object.direction));
  Term t = walkedSteps();
  Term tQ = ownName(letter("t", in.Q.symbol.letter), sought.t).marked(mark("tQ"));
  std::array<Asking, 3> coordinates{askingOf(in, *this, Q, sought, 0), askingOf(in, *this, Q, sought, 1),
                                    askingOf(in, *this, Q, sought, 2)};

  /// No line tells t, because in the scene it is chosen; where it is asked, P has the answer.
  [[nodiscard]] Term walkedSteps() const {
    const Term steps = drawnName(letter("t"), walked.t);
    return isWalked ? steps.standingFor(dot(P - A, v) / dot(v, v)) : steps;
  }
  /// t_x, t_y and t_z: those that there are.
  [[nodiscard]] std::vector<Term> allSteps() const {
    std::vector<Term> all;
    for (const Asking &each : coordinates)
      if (each.hasSteps)
        all.push_back(each.t);
    return all;
  }
};

std::string_view nameOf(LinePlace which) {
  switch (which) {
  case LinePlace::Before:
    return "before";
  case LinePlace::Segment:
    return "segment";
  case LinePlace::Beyond:
    return "beyond";
  case LinePlace::Off:
    return "off";
  case LinePlace::ZeroDirection:
    break;
  }
  return "zero-direction";
}

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.sought.which));
  const std::string t = equation(at.tQ);
  switch (at.sought.which) {
  case LinePlace::Segment:
    return {caseName, words("{t}: {Q} lies on the segment from {A} to {B}.", at.letters, {{"t", t}})};
  case LinePlace::Beyond:
    return {caseName,
            words("{t} is larger than 1: {Q} lies on the ray, beyond {B}.", at.letters, {{"t", t}})};
  case LinePlace::Before:
    return {caseName,
            words("{t} is negative: {Q} lies on the line {g}, behind {A}, where the ray never goes.",
                  at.letters, {{"t", t}})};
  case LinePlace::Off:
    return {caseName, words("No t leads from {A} to {Q}: it lies beside the line {g}.", at.letters)};
  case LinePlace::ZeroDirection:
    break;
  }
  return zeroLineWords(at, caseName);
}

WorkingLine directionLine(const Out &at) {
  return asked(withNumbers(at.v == at.B - at.A),
               words("From {A} to {B}: a point minus a point is a vector.", at.letters),
               {{at.A - at.B,
                 words("{answer} leads from {B} to {A}: take the start away from the end.", at.letters)}});
}

WorkingLine mixedLine(const Out &at) {
  return asked(withNumbers(at.P == (1 - at.t) * at.A + at.t * at.B),
               words("The same point as a mixture of {A} and {B}.", at.letters),
               {{at.t * at.A + (1 - at.t) * at.B,
                 words("{answer} has the weights exchanged: t is that of {B}.", at.letters)}});
}

std::string rangeWords(const Out &at) {
  switch (at.walked.which) {
  case LinePlace::Before:
    return words("Negative: {P} lies behind {A}, on the line but not on the ray.", at.letters);
  case LinePlace::Beyond:
    return words("Larger than 1: {P} lies beyond {B}, on the ray but not on the segment.", at.letters);
  default:
    return words("Neither negative nor larger than 1: {P} lies on the segment.", at.letters);
  }
}

WordValues wordsOf(const Asking &each) {
  return {{"axis", each.axis},
          {"start", plainText(each.A)},
          {"step", plainText(each.v)},
          {"end", plainText(each.Q)}};
}

/// Where v does not change the coordinate.
WorkingLine fixedLine(const Asking &each) {
  const WordValues names = wordsOf(each);
  return line(
      {compared(each.v, 0), compared(each.Q, each.A)},
      each.isRight
          ? words("No step changes {axis}, and {end} is {start} already: every t is right here.", names)
          : words("No step changes {axis}, and {end} is not {start}: no t is right here.", names));
}

WorkingLine stepsLine(const Asking &each) {
  if (!each.hasSteps)
    return fixedLine(each);
  const WordValues names = wordsOf(each);
  return asked(
      withNumbers(each.t == (each.Q - each.A) / each.v),
      words("So many steps of {step} lead from {start} to {end}.", names),
      {{each.Q / each.v, words("{answer} is right only where {start} is 0: take {start} away first.", names)},
       {each.Q - each.A, words("{answer} is not divided yet by {step}.", names)},
       {(each.A - each.Q) / each.v,
        words("{answer} has the wrong sign: take the start {start} away from {end}.", names)}});
}

/// t_Q = t_x = t_y = t_z
WorkingLine commonLine(const Out &at) {
  const std::vector<Term> all = at.allSteps();
  Chain chain = at.tQ == all.front();
  for (std::size_t i = 1; i < all.size(); ++i)
    chain = chain == all[i];
  return line(withResult(chain),
              words("One t is right for all coordinates: {Q} lies on the line.", at.letters));
}

WorkingLine agreeLine(const Out &at) {
  if (at.isReached)
    return commonLine(at);
  const auto never = std::find_if(at.coordinates.begin(), at.coordinates.end(),
                                  [](const Asking &each) { return each.isNever(); });
  if (never != at.coordinates.end())
    return line(compared(never->Q, never->A),
                words("Every point of the line has the {axis} of {A}, and {Q} has another: no t leads there.",
                      at.letters, {{"axis", never->axis}}));
  return sortedLine(at.allSteps(), words("They are not all the same: no t leads to {Q}.", at.letters));
}

LineTable<Out> lines() {
  LineTable<Out> all{
      {"tip", &Out::isLine, [](const Out &at) { return withNumbers(at.B == at.A + at.v); },
       says("One step from {A}: a point plus a vector is a point.")},
      {"v", &Out::isLine, directionLine},
      {"point", &Out::isWalked, [](const Out &at) { return withNumbers(at.P == at.A + at.t * at.v); },
       says("From {A} so many steps {v} lead to {P}.")},
      {"mixed", &Out::isWalked, mixedLine},
      {"weights", &Out::isWalked,
       [](const Out &at) {
         return resultsLine({1 - at.t, at.t},
                            words("The weight of {A} and that of {B}. Together they make 1.", at.letters));
       }},
      {"range", &Out::isWalked, [](const Out &at) {
         return sortedLine({0, at.t, 1}, rangeWords(at));
       }}};
  for (std::size_t i = 0; i < axisNames.size(); ++i)
    all.push_back(
        {axisNames.at(i), &Out::isLine, [i](const Out &at) { return stepsLine(at.coordinates.at(i)); }});
  all.push_back({"agree", &Out::isLine, agreeLine});
  return all;
}

// What lies beside the line, in scene units: below it the marks of a ruler, above it what belongs to the
// segment and to the ray.
constexpr double tickLength = 0.5;
constexpr double segmentDistance = 1.3;
constexpr double rayDistance = 1.7;
/// The ruler has the whole numbers from here on, so many.
constexpr int firstOfRuler = -1;
constexpr int countOfRuler = 4;

/// Perpendicular to the line, and as upright as it can be.
Place upFrom(const ExactVec3 &direction) {
  const ExactVec3 level(direction.x, direction.y, 0);
  const ExactVec3 up = ExactVec3(0, 0, 1) * dot(level, level) - level * direction.z;
  return isZero(up) ? Place(1, 0, 0) : unitOf(up);
}

SegmentMark tick(MarkBase base, const Out &at, const Place &from) {
  return {std::move(base), from, from - tickLength * upFrom(at.in.g.object.direction)};
}

/// A letter with what it comes to, at the ruler.
MarkBase valued(const Term &letter, Role role, Subject subject) {
  MarkBase base = drawn(letter, role, subject);
  base.numbers = relatedLatex(calculated(letter));
  return base;
}

void drawRuler(Figure &figure, const Out &at) {
  for (int i = 0; i < countOfRuler; ++i) {
    const int number = firstOfRuler + i;
    MarkBase base{partOf(at.mark("ruler"), static_cast<std::size_t>(i)), Role::Derived, Subject::Neutral};
    base.numbers = std::to_string(number);
    figure.add(tick(std::move(base), at, place(at.A) + static_cast<double>(number) * place(at.v)));
  }
}

/// The parts of the line that are the ray and the segment, drawn beside it.
void drawParts(Figure &figure, const Out &at) {
  const Place up = upFrom(at.in.g.object.direction);
  const Place start = place(at.A);
  const Place nearer = segmentDistance * up;
  MarkBase segment{at.mark("segment"), Role::Result, Subject::EdgeV};
  segment.numbers = "0\\le t\\le 1";
  figure.add(SegmentMark{std::move(segment), start + nearer, place(at.B) + nearer});
  MarkBase ray{at.mark("ray"), Role::Result, Subject::EdgeU};
  ray.numbers = "t\\ge 0";
  figure.add(RayMark{std::move(ray), start + rayDistance * up, unitOf(at.in.g.object.direction)});
}

void drawWalk(Figure &figure, const Out &at) {
  figure.reaches.push_back({at.in.g.id, place(at.P)});
  figure.add(tick(valued(at.t, Role::Derived, Subject::Measure), at, place(at.P)));
  if (at.walked.t == 0)
    return;
  const Term way = at.t * at.v;
  figure.add(ArrowMark{{at.mark("tv"), Role::Result, Subject::Measure, latexOf(way)},
                       place(at.A),
                       toDouble(at.walked.t) * place(at.v)});
}

/// The points of the line that have one coordinate of Q each. On the line they are Q itself, and have one t.
void drawSteps(Figure &figure, const Out &at) {
  for (const Asking &each : at.coordinates) {
    if (!each.hasSteps)
      continue;
    const Place there = place(at.A) + toDouble(rationalOf(each.t)) * place(at.v);
    figure.reaches.push_back({at.in.g.id, there});
    MarkBase base = valued(each.t, Role::Derived, Subject::Neutral);
    if (at.isReached)
      base.label = base.numbers = "";
    figure.add(tick(std::move(base), at, there));
    if (!at.isReached)
      figure.add(SegmentMark{{each.t->mark + "/way", Role::Helper, Subject::Neutral}, place(at.Q), there});
  }
  if (at.isReached)
    figure.add(inLook(at.in.Q.look, tick(valued(at.tQ, Role::Result, Subject::Point), at, place(at.Q))));
}

Figure draw(const Out &at) {
  Figure figure;
  if (!at.isLine)
    return figure;
  figure.add(pointOf(at.B, Role::Given, Subject::Ray));
  drawRuler(figure, at);
  drawParts(figure, at);
  if (at.isWalked)
    drawWalk(figure, at);
  drawSteps(figure, at);
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  if (at.sought.which != LinePlace::Off)
    return {};
  const auto &[through, direction] = at.in.g.object;
  return {{is("on", "yes"), words("{Q} would lie on the line {g}.", at.letters), "Q",
           PointObject{measurePointLine(at.in.Q.object.at, through, direction).foot}}};
}

Word wordOf(LinePlace which) {
  const std::string name(nameOf(which));
  switch (which) {
  case LinePlace::Before:
    return {name, words("behind the start")};
  case LinePlace::Segment:
    return {name, words("on the segment")};
  case LinePlace::Beyond:
    return {name, words("on the ray alone")};
  case LinePlace::Off:
  case LinePlace::ZeroDirection:
    break;
  }
  return {name, words("beside the line")};
}

ValueTable<Out> stepRows() {
  ValueTable<Out> all;
  for (std::size_t i = 0; i < axisNames.size(); ++i)
    all.push_back({named::number("t_" + std::string(axisNames.at(i))),
                   [i](const Out &at) { return at.coordinates.at(i).hasSteps; },
                   [i](const Out &at) { return at.coordinates.at(i).t; }});
  return all;
}

ValueTable<Out> values() {
  return joined<ValueRow<Out>>(
      {{{named::vector("direction"), always, &Out::v},
        {named::vector("tip"), &Out::isLine, &Out::B},
        {named::number("t"), &Out::isWalked, &Out::t},
        {named::word("part", {"before", "segment", "beyond", "off"}), &Out::isLine,
         [](const Out &at) {
           return ToldValue(words("place of {P}", at.letters), wordOf(at.walked.which));
         }}},
       stepRows(),
       {{named::word("on", {"yes", "no"}), &Out::isLine,
         [](const Out &at) {
           return ToldValue(words("{Q} is on the line", at.letters), yesOrNo(at.isReached));
         }},
        {named::number("t_Q"), &Out::isReached, &Out::tQ}}});
}

} // namespace

Construction line_ray_segment() {
  return taught<Out, LineObject, PointObject, PointObject>(
      {.id = "line-ray-segment",
       .title = [] { return words("is the point on the line?"); },
       .roles = {"g", "P", "Q"},
       .makes = {{"B", &Out::isLine, &Out::B}},
       .letters = {"t", "tx", "ty", "tz", "tQ"},
       .cases = {"before", "segment", "beyond", "off", "zero-direction"},
       .values = values(),
       .lines = lines(),
       .marks = {"B", "ruler", "segment", "ray", "t", "tv", "tx", "ty", "tz", "tQ"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
