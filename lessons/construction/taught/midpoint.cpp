// The point in the middle between two points: their mean, and half of the way from one to the other.
#include "lessons/construction/parts/two_points.h"
#include "lessons/construction/taught.h"

namespace halfspace {
namespace {

struct Out : WayBetweenPoints {
  explicit Out(const TwoPoints &objects) : WayBetweenPoints(objects) {}

  Term M = madeName("M", ExactVec3((in.A.object.at + in.B.object.at) / Rational(2)));
};

CaseWords tell(const Out &at) {
  if (at.areApart)
    return {"apart", words("{M} is in the middle between {A} and {B}, equally far from both.", at.letters)};
  return {"same", words("{A} and {B} are the same point, and so is {M}.", at.letters)};
}

WorkingLine meanLine(const Out &at) {
  return asked(withNumbers(at.M == (at.A + at.B) / 2),
               words("The midpoint: each coordinate is the mean of those of {A} and {B}.", at.letters),
               {{at.A + at.B, words("{answer} is {A} + {B}: take half of it.", at.letters)},
                {(at.B - at.A) / 2,
                 words("{answer} is half of the way from {A} to {B}, without the start {A}.", at.letters)},
                {(at.A - at.B) / 2,
                 words("{answer} is half of the way from {B} to {A}: add the points instead.", at.letters)}});
}

Figure draw(const Out &at) {
  Figure figure;
  if (at.areApart)
    figure.add(arrowOf(at.w, place(at.A), Role::Derived, Subject::Point));
  figure.add(pointOf(at.M, Role::Result, Subject::Measure));
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  if (!at.areApart)
    return {};
  return {{is("case", "same"), words("{A}, {B} and {M} would be the same point.", at.letters), "B",
           PointObject{at.in.A.object.at}}};
}

} // namespace

Construction midpoint() {
  return taught<Out, PointObject, PointObject>(
      {.id = "midpoint",
       .title = [] { return words("midpoint"); },
       .roles = {"A", "B"},
       .makes = {{"M", always, &Out::M}},
       .letters = {"w"},
       .cases = {"apart", "same"},
       .values = {{named::vector("point"), always, &Out::M}},
       .lines = {{"mean", always, meanLine},
                 {"w", always, wayLine},
                 {"half", always,
                  [](const Out &at) { return withNumbers(at.M == at.A + Term(Rational(1, 2)) * at.w); },
                  says("The same point: half of the way from {A} to {B}.")}},
       .marks = {"w", "M"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
