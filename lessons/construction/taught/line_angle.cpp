// The angle at which two lines run to each other, whether they meet or not, by their directions.
#include "geometry/angle.h"
#include "geometry/closest_points.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/acute_angle.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/line.h"
#include "lessons/term/angle.h"

namespace halfspace {
namespace {

struct In : Naming {
  Given<LineObject> g;
  Given<LineObject> h;
};

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  const LineObject &first = in.g.object;
  const LineObject &second = in.h.object;
  AcuteAngle<Rational> angle = measureAcuteAngle(first.direction, second.direction);
  ClosestPoints<Rational> closest =
      closestPoints(first.point, first.direction, second.point, second.direction);
  bool hasAngle = angle.which != AcuteAngleCase::ZeroVector;
  bool isRight = angle.which == AcuteAngleCase::Perpendicular;

  LineTerms g = termsOf(in.g);
  LineTerms h = termsOf(in.h);
  Term phi = ownName(letter("φ"), std::nullopt).marked(mark("phi"));
  Term cosine = applied(word("cos"), phi, angle.cosine);

  [[nodiscard]] WrittenNumber degrees() const { return degreesOf(cosine); }
};

CaseWords tell(const Out &at) {
  switch (at.angle.which) {
  case AcuteAngleCase::Parallel:
    return {"parallel", at.closest.which == ClosestPointsCase::Coincident
                            ? words("{g} and {h} are the same line: the angle is 0°.", at.letters)
                            : words("{g} and {h} are parallel: the angle is 0°.", at.letters)};
  case AcuteAngleCase::Perpendicular:
    return {"perpendicular",
            words("{g.v}·{h.v} = 0: {g} and {h} are perpendicular to each other.", at.letters)};
  case AcuteAngleCase::Oblique:
    return {"oblique", at.closest.which == ClosestPointsCase::Meet
                           ? words("The lines {g} and {h} meet at the angle φ{degrees}°.", at.letters,
                                   {{"degrees", relatedText(at.degrees())}})
                           : words("The lines {g} and {h} do not meet. Their directions have the angle "
                                   "φ{degrees}°.",
                                   at.letters, {{"degrees", relatedText(at.degrees())}})};
  case AcuteAngleCase::ZeroVector:
    break;
  }
  return zeroLinesWords(at, "zero-direction", isZero(at.first.direction), isZero(at.second.direction));
}

std::string productWords(const Out &at) {
  const int sign = at.angle.product.sign();
  return sign > 0   ? words("Positive: the directions are less than 90° apart.")
         : sign < 0 ? words("Negative: the directions are more than 90° apart. The angle of the lines is at "
                            "most 90°, so the sign will be left out.")
                    : words("Zero: the directions are perpendicular to each other, and so are the lines.");
}

std::string cosineWords(const Out &at) {
  return at.angle.product < 0
             ? words("φ{degrees}°: the angle of the lines. The directions are 180° − φ apart.",
                     {{"degrees", relatedText(at.degrees())}})
             : words("φ{degrees}°: the angle of the lines, and of their directions.",
                     {{"degrees", relatedText(at.degrees())}});
}

/// The directions from the point of the first line that is nearest to the second, which is the common one of
/// lines that meet; that of the second is turned round where they are more than 90° apart.
Figure draw(const Out &at) {
  Figure figure;
  if (!at.hasAngle || at.angle.which == AcuteAngleCase::Parallel)
    return figure;
  const Place point = place(at.closest.first);
  const Place second = at.angle.product < 0 ? -place(at.h.v) : place(at.h.v);
  addAngle(figure, {at.phi, at.degrees(), at.isRight}, point, {place(at.g.v), Subject::Ray, at.in.g.look},
           {second, Subject::Ray, at.in.h.look});
  figure.reaches = {{at.in.g.id, point}, {at.in.h.id, place(at.closest.second)}};
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  if (at.angle.which != AcuteAngleCase::Oblique)
    return {};
  const auto parts = projectVector(at.second.direction, at.first.direction);
  return {{is("case", "perpendicular"), words("The lines would be perpendicular to each other."), "h",
           LineObject{at.second.point, parts.rejection}},
          {is("case", "parallel"), words("The angle of the lines would be 0°."), "h",
           LineObject{at.second.point, parts.projection}}};
}

} // namespace

Construction line_angle() {
  return taught<Out, LineObject, LineObject>(
      {.id = "line-angle",
       .word = "angle",
       .title = [] { return words("angle of the lines"); },
       .roles = {"g", "h"},
       .letters = {"φ"},
       .cases = {"parallel", "oblique", "perpendicular", "zero-direction"},
       .values = {{named::number("dot"), &Out::hasAngle, [](const Out &at) { return dot(at.g.v, at.h.v); }},
                  {named::number("cosine"), &Out::hasAngle, &Out::cosine}},
       .lines = {{"dot", &Out::hasAngle, [](const Out &at) { return withProducts(dot(at.g.v, at.h.v)); },
                  productWords},
                 {"length-g", &Out::hasAngle, [](const Out &at) { return lengthLine(at.g.v); }},
                 {"length-h", &Out::hasAngle, [](const Out &at) { return lengthLine(at.h.v); }},
                 {"angle", &Out::hasAngle,
                  [](const Out &at) { return acuteLine(at.cosine, at.g.v, at.h.v, cosineWords(at)); }}},
       .marks = {"phi"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
