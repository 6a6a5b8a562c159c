// The cross product of two vectors: its direction, its coordinates, its length as an area, and u⊥ as a
// quarter turn (notes PG 2 and PG 6.2).
#include "lessons/construction/parts/ray_triangle_cases.h"
#include "lessons/construction/parts/two_vectors.h"
#include "lessons/construction/taught.h"
#include "lessons/term/angle.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <tuple>

namespace halfspace {
namespace {

struct In : Naming {
  Given<VectorObject> u;
  Given<VectorObject> v;
};

/// The triangle whose corners are the start and the tips of two vectors from one point.
Triangle<Rational> triangleOf(const ExactVec3 &u, const ExactVec3 &v) { return {ExactVec3(0), u, v}; }

/// 0 where there is no angle.
Surd sineOf(const TrianglePerps<Rational> &perps) {
  const Rational squares = perps.uu * perps.vv;
  return squares == 0 ? Surd() : Surd::root(Rational(-perps.denominator / squares));
}

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  /// n = u×v and u⊥ = n×u, as the lessons of a ray and a triangle have them.
  TrianglePerps<Rational> perps = perpsOf(triangleOf(in.u.object.vector, in.v.object.vector));
  bool isProper = perps.denominator != 0; ///< whether u and v span a parallelogram
  bool hasAngle = perps.uu != 0 && perps.vv != 0;

  Term u = termOf(in.u);
  Term v = termOf(in.v);
  Term n = drawnName(vectorLetter("n"), perps.normal);
  Term area = norm(n).marked(mark("area")); ///< of the parallelogram
  Term half = (norm(n) / 2).marked(mark("triangle"));
  Term theta = ownName(letter("θ"), std::nullopt).marked(mark("theta"));
  Term sine = applied(word("sin"), theta, sineOf(perps));
  Term cosine = applied(word("cos"), theta, cosineOf(perps));
  Term height = (norm(v) * sine).marked(mark("height")); ///< of the parallelogram over u
  Term uPerp = ownName(perpLetter("u"), perps.uPerp).marked(mark("uperp"));
  Term turned = (uPerp / norm(n)).marked(mark("turned")); ///< u after a quarter turn about n
};

CaseWords tell(const Out &at) {
  if (at.isProper)
    return {"proper", words("n is perpendicular to {u} and to {v}, and its length is the area of their "
                            "parallelogram.",
                            at.letters)};
  if (!at.hasAngle)
    return {"zero-vector",
            words("{zero} is the zero vector, and so is the cross product: there is no parallelogram.",
                  {{"zero", plainText(at.perps.uu == 0 ? at.u : at.v)}}),
            true};
  return at.perps.uv > 0
             ? CaseWords{"same-direction",
                         words("{u} and {v} point in the same direction: their cross product is the zero "
                               "vector, which points nowhere.",
                               at.letters),
                         true}
             : CaseWords{"opposite",
                         words("{u} and {v} point in opposite directions: their cross product is the zero "
                               "vector, which points nowhere.",
                               at.letters),
                         true};
}

/// Whether the cross product points upwards: a question that the right hand answers.
Word wayWord(const Out &at) {
  if (!at.isProper)
    return {"nowhere", words("nowhere")};
  const int sign = at.perps.normal.z.sign();
  return sign > 0   ? Word{"up", words("upwards")}
         : sign < 0 ? Word{"down", words("downwards")}
                    : Word{"level", words("level")};
}

WorkingLine crossLine(const Out &at) {
  return asked(withProducts(at.n == cross(at.u, at.v)),
               at.isProper
                   ? words("The first coordinate takes y and z, the second z and x, the third x and y.")
                   : words("The zero vector: {u} and {v} lie along one line.", at.letters),
               {{cross(at.v, at.u),
                 words("{answer} is the cross product the other way round: {v} × {u}.", at.letters)}});
}

/// That the product is perpendicular to one of the two: the mark is their right angle.
WorkingLine checkLine(const Out &at, const Term &vector, const std::string &rightAngle) {
  return line(withProducts(dot(at.n, vector).marked(at.mark(rightAngle))),
              at.isProper
                  ? words("0, because n is perpendicular to {vector}.", {{"vector", plainText(vector)}})
                  : words("0, because n is the zero vector."));
}

WorkingLine lengthLine(const Out &at) {
  return asked(withProducts(at.area == root(dot(at.n, at.n))),
               at.isProper ? words("The area of the parallelogram of {u} and {v}.", at.letters)
                           : words("0: there is no parallelogram, only a line or a point."));
}

WorkingLine heightLine(const Out &at) {
  return asked(withNumbers(at.height == norm(at.n) / norm(at.u)),
               words("The height of the parallelogram over {u}: its area divided by its base.", at.letters),
               {{norm(at.n) / dot(at.u, at.u),
                 words("{answer} is divided by {u}·{u}: divide by its root, |{u}|.", at.letters)},
                {norm(at.n) / norm(at.v),
                 words("{answer} is divided by |{v}|: that is the height over {v}.", at.letters)}});
}

WorkingLine triangleLine(const Out &at) {
  return asked(
      withNumbers(at.half), words("The triangle of {u} and {v} is half of it.", at.letters),
      {{norm(at.n), words("{answer} is the area of the parallelogram: the triangle is half of it.")}});
}

WorkingLine squaresLine(const Out &at) {
  const auto &[u, v] = std::tie(at.u, at.v);
  return asked(withNumbers(dot(at.n, at.n) == dot(u, u) * dot(v, v) - power(dot(u, v), 2)),
               words("The square of the area, from three dot products."),
               {{power(dot(u, v), 2) - dot(u, u) * dot(v, v),
                 words("{answer} has the wrong sign: ({u}·{v})² is what is taken away.", at.letters)}});
}

std::string sineWords(const Out &at) {
  return words("θ{degrees}°: the angle between {u} and {v}. The angle 180° − θ has the same sine.",
               at.letters, {{"degrees", relatedText(degreesOf(at.cosine))}}); // with its relation
}

WorkingLine reverseLine(const Out &at) {
  return asked(withProducts(cross(at.v, at.u)),
               at.isProper ? words("The opposite vector: in each coordinate the two products have changed "
                                   "places.")
                           : words("The zero vector in this order, too."),
               {{at.n, words("{answer} is {u} × {v}: here the order is the other one.", at.letters)}});
}

WorkingLine uPerpLine(const Out &at) {
  return asked(withProducts(at.uPerp == cross(at.n, at.u)),
               at.isProper ? words("It is perpendicular to n, and to {u}.", at.letters)
                           : words("The zero vector, because n is the zero vector."),
               {{cross(at.u, at.n),
                 words("{answer} is the cross product the other way round: {u} × n.", at.letters)}});
}

WorkingLine inPlaneLine(const Out &at) {
  const auto &[u, v] = std::tie(at.u, at.v);
  return asked(
      withNumbers(at.uPerp == dot(u, u) * v - dot(u, v) * u),
      words("The same vector, put together from {u} and {v}: so it lies in their plane.", at.letters));
}

WorkingLine turnedLine(const Out &at) {
  return asked(withNumbers(at.turned),
               words("{u} after a quarter turn about n. It is as long as {u}.", at.letters),
               {{at.uPerp / dot(at.n, at.n), words("{answer} is divided by n·n: divide by its root, |n|.")}});
}

LineTable<Out> lines() {
  return {{"cross", always, crossLine},
          {"check-u", always, [](const Out &at) { return checkLine(at, at.u, "right-u"); }},
          {"check-v", always, [](const Out &at) { return checkLine(at, at.v, "right-v"); }},
          {"length", always, lengthLine},
          {"height", &Out::isProper, heightLine},
          {"triangle", &Out::isProper, triangleLine},
          {"squares", always, squaresLine},
          {"sine", &Out::hasAngle,
           [](const Out &at) { return withNumbers(at.sine == norm(at.n) / (norm(at.u) * norm(at.v))); },
           sineWords},
          {"reverse", always, reverseLine},
          {"uperp", always, uPerpLine},
          {"in-plane", &Out::isProper, inPlaneLine},
          {"turned", &Out::isProper, turnedLine}};
}

/// u⊥ is drawn so many times as long as u at most: how long it is the words tell.
constexpr double longestPerp = 2;

void drawProduct(Figure &figure, const Out &at, const Place &from) {
  figure.add(arrowOf(at.n, from, Role::Result, Subject::Plane));
  for (const auto &[id, vector] : {std::pair("right-u", at.u), std::pair("right-v", at.v)})
    figure.add(
        RightAngleMark{{at.mark(id), Role::Helper, Subject::Measure}, from, place(at.n), place(vector)});
}

/// The parallelogram, the triangle that is half of it, and its height over u: from the tip of v to the line
/// of u.
void drawAreas(Figure &figure, const Out &at, const Place &from) {
  const Place u = place(at.u);
  const Place v = place(at.v);
  figure.add(parallelogramOf(at.area->mark, norm(at.n), from, u, v));
  figure.add(PolygonMark{{at.half->mark, Role::Derived, Subject::Plane}, {from, from + u, from + v}});
  addHeight(figure, at.height, from, at.in.u.object.vector, at.in.v.object.vector);
}

/// u⊥, and u turned into its direction.
void drawQuarterTurn(Figure &figure, const Out &at, const Place &from) {
  const Look &look = at.in.u.look;
  const MarkBase turned = drawn(at.turned, Role::Derived, Subject::EdgeU);
  const ArrowMark arrow{turned, from, place(at.turned)};
  const double length = glm::length(arrow.vector);
  const double times = std::min(longestPerp, toDouble(*numberOf(norm(at.n))));
  figure.add(inLook(look, arrowOfLength(drawn(at.uPerp, Role::Result, Subject::EdgeU), from, at.perps.uPerp,
                                        length * times)));
  figure.add(inLook(look, arrow));
  figure.add(RightAngleMark{
      {at.turned->mark + "/angle", Role::Helper, Subject::Measure}, from, place(at.u), arrow.vector});
}

Figure draw(const Out &at) {
  Figure figure;
  const Place from = place(at.in.u.object.start);
  if (at.hasAngle) {
    drawMoved(figure, at.theta->mark, from, at.in.v);
    figure.add(ArcMark{drawn(at.theta, Role::Derived, Subject::Neutral), from, place(at.u), place(at.v)});
  }
  if (!at.isProper)
    return figure;
  drawProduct(figure, at, from);
  drawAreas(figure, at, from);
  drawQuarterTurn(figure, at, from);
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  return turnedNearby(at.in.u, at.in.v, "v",
                      {is("uv", "0"), is("case", at.perps.uv > 0 ? "same-direction" : "opposite")});
}

ValueTable<Out> values() {
  return {{named::vector("cross"), always, &Out::n},
          {named::word("points", {"up", "down", "level", "nowhere"}), always,
           [](const Out &at) { return ToldValue(words("direction of the cross product"), wayWord(at)); }},
          {named::number("length"), always, [](const Out &at) { return norm(at.n); }},
          {named::number("parallelogram"), always,
           [](const Out &at) {
             return ToldValue(words("area of the parallelogram"), listed({}, norm(at.n)).value);
           }},
          {named::number("triangle"), always,
           [](const Out &at) { return ToldValue(words("area of the triangle"), listed({}, at.half).value); }},
          {named::number("height"), &Out::isProper, &Out::height},
          {named::number("uu"), always, [](const Out &at) { return dot(at.u, at.u); }},
          {named::number("uv"), always, [](const Out &at) { return dot(at.u, at.v); }},
          {named::number("vv"), always, [](const Out &at) { return dot(at.v, at.v); }},
          {named::number("squares"), always, [](const Out &at) { return dot(at.n, at.n); }},
          {named::number("length_u"), always, [](const Out &at) { return norm(at.u); }},
          {named::number("length_v"), always, [](const Out &at) { return norm(at.v); }},
          {named::number("sin_angle"), &Out::hasAngle, &Out::sine},
          {named::vector("u_perp"), always, &Out::uPerp},
          {named::vector("turned"), &Out::isProper, &Out::turned}};
}

} // namespace

Construction cross_product() {
  return taught<Out, VectorObject, VectorObject>(
      {.id = "cross-product",
       .word = "cross",
       .title = [] { return words("cross product"); },
       .roles = {"u", "v"},
       .letters = {"n", "θ"},
       .cases = {"proper", "same-direction", "opposite", "zero-vector"},
       .values = values(),
       .lines = lines(),
       .marks = {"theta", "n", "right-u", "right-v", "area", "triangle", "height", "uperp", "turned"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
