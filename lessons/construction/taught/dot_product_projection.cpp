// The dot product of two vectors, and what each is along the other and across it (notes PG 6.1 and RP).
#include "geometry/angle.h"
#include "geometry/project_vector.h"
#include "lessons/construction/parts/two_vectors.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"
#include "lessons/term/angle.h"
#include "lessons/term/prime.h"

#include <tuple>

namespace halfspace {
namespace {

struct In : Naming {
  Given<VectorObject> v;
  Given<VectorObject> w;
};

/// What becomes of a vector's letter when another is projected onto it.
Term primeOf(const Given<VectorObject> &onto, const ExactVec3 &projection, const std::string &mark) {
  return name(primed(onto.letters[1]), projection).marked(mark);
}

/// The unit vector of a direction; the zero vector has none.
std::vector<Surd> unitCoordinates(const ExactVec3 &direction) {
  const Rational square = dot(direction, direction);
  std::vector<Surd> unit;
  unit.reserve(3);
  for (int axis = 0; axis < 3; ++axis)
    unit.push_back(square == 0 ? Surd() : overRoot(direction[axis], square));
  return unit;
}

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  ProjectedVector<Rational> wOntoV = projectVector(in.w.object.vector, in.v.object.vector);
  ProjectedVector<Rational> vOntoW = projectVector(in.v.object.vector, in.w.object.vector);
  int sign = dot(in.v.object.vector, in.w.object.vector).sign(); ///< of v·w: −1, 0, 1
  bool areParallel = isZero(cross(in.v.object.vector, in.w.object.vector));
  bool hasV = !isZero(in.v.object.vector);
  bool hasW = !isZero(in.w.object.vector);
  bool hasAngle = hasV && hasW;

  Term v = termOf(in.v);
  Term w = termOf(in.w);
  Term product = dot(v, w);
  Term theta = ownName(letter("θ"), std::nullopt).marked(mark("theta"));
  Term cosine = applied(word("cos"), theta, cosineBetween(in.v.object.vector, in.w.object.vector));
  Term e = drawnName(vectorLetter("e"), unitCoordinates(in.v.object.vector));
  Term vPrime = primeOf(in.v, wOntoV.projection, mark("vprime")); ///< w projected onto v: a multiple of v
  Term wPrime = primeOf(in.w, vOntoW.projection, mark("wprime")); ///< v projected onto w
  Term h = drawnName(vectorLetter("h"), wOntoV.rejection);        ///< what is left of w: across v
};

CaseWords tell(const Out &at) {
  const std::string product = equation(at.product);
  if (!at.hasAngle)
    return {"zero-vector",
            words("{zero} is the zero vector: it points nowhere, so it makes no angle, and nothing can be "
                  "projected onto it.",
                  {{"zero", plainText(isZero(vectorOf(at.v)) ? at.v : at.w)}}),
            true};
  if (at.areParallel)
    return at.sign > 0 ? CaseWords{"same-direction", words("{v} and {w} point in the same direction: nothing "
                                                           "is left across.",
                                                           at.letters)}
                       : CaseWords{"opposite", words("{v} and {w} point in opposite directions: nothing is "
                                                     "left across.",
                                                     at.letters)};
  if (at.sign == 0)
    return {"right", words("{product}: the vectors are perpendicular, and the projections are zero.",
                           {{"product", product}})};
  return at.sign > 0
             ? CaseWords{"acute", words("{product} is positive: the angle is smaller than 90°.",
                                        {{"product", product}})}
             : CaseWords{"obtuse", words("{product} is negative: the angle is larger than 90°, and the "
                                         "projections point backwards.",
                                         {{"product", product}})};
}

Word signWord(int sign) {
  return sign > 0   ? Word{"positive", words("positive")}
         : sign < 0 ? Word{"negative", words("negative")}
                    : Word{"zero", words("zero")};
}

WorkingLine lengthLine(const Term &vector) {
  return asked(withProducts(norm(vector) == root(dot(vector, vector))));
}

std::string angleWords(const Out &at) {
  const std::string degrees = relatedText(degreesOf(at.cosine)); // with its relation
  return words("θ{degrees}°: the angle between {v} and {w}.", at.letters, {{"degrees", degrees}});
}

std::string unitProductWords(const Out &at) {
  return at.hasAngle ? words("The same number once more: with a unit vector there is nothing to divide by.")
                     : words("With a unit vector there is nothing to divide by.");
}

WorkingLine reachLine(const Out &at) {
  return asked(
      withNumbers((norm(at.w) * at.cosine).marked(at.vPrime->mark) == at.product / norm(at.v)),
      words("This is how far {w} reaches along {v}. It is negative when {w} reaches backwards.", at.letters),
      {{at.product, words("{answer} is {v}·{w}: divide by |{v}|.", at.letters)},
       {at.product / dot(at.v, at.v),
        words("{answer} is divided by {v}·{v}: divide by its root, |{v}|.", at.letters)},
       {at.product / norm(at.w),
        words("{answer} is divided by |{w}|: that is how far {v} reaches along {w}.", at.letters)}});
}

WorkingLine unitLine(const Out &at) {
  return asked(withNumbers(at.e == at.v / norm(at.v)),
               words("The arrow of length 1 in the direction of {v}.", at.letters),
               {{at.v / dot(at.v, at.v),
                 words("{answer} is divided by {v}·{v}: divide by its root, |{v}|.", at.letters)}});
}

WorkingLine projectionLine(const Out &at) {
  const auto &[v, product] = std::tie(at.v, at.product);
  return asked(
      withNumbers(at.vPrime == (product / dot(v, v)) * v),
      words("{w} projected onto {v}: the shadow as an arrow.", at.letters),
      {{product * v,
        words("{answer} is ({v}·{w}){v}. That is the projection only when |{v}| = 1: divide by {v}·{v}.",
              at.letters)},
       {(product / norm(v)) * v,
        words("{answer} is divided by |{v}| once. {v} itself has this length too: divide by {v}·{v}.",
              at.letters)},
       {at.wPrime, words("{answer} is the projection of {v} onto {w}.", at.letters)}});
}

WorkingLine otherProjectionLine(const Out &at) {
  const auto &[w, product] = std::tie(at.w, at.product);
  return asked(
      withNumbers(at.wPrime == (product / dot(w, w)) * w), words("{v} projected onto {w}.", at.letters),
      {{product * w,
        words("{answer} is ({v}·{w}){w}. That is the projection only when |{w}| = 1: divide by {w}·{w}.",
              at.letters)},
       {at.vPrime, words("{answer} is the projection of {w} onto {v}.", at.letters)}});
}

WorkingLine perpendicularLine(const Out &at) {
  return line(withProducts(dot(at.h, at.v)),
              isZero(at.wOntoV.rejection) ? words("0, because nothing is left.")
                                          : words("Always 0: the rest is perpendicular to {v}.", at.letters));
}

LineTable<Out> lines() {
  return {
      {"dot", always, [](const Out &at) { return withProducts(at.product); },
       says("Multiply x by x, y by y and z by z, and add the three products.")},
      {"length-v", always, [](const Out &at) { return lengthLine(at.v); }},
      {"length-w", always, [](const Out &at) { return lengthLine(at.w); }},
      {"cosine", &Out::hasAngle,
       [](const Out &at) { return withNumbers(at.cosine == at.product / (norm(at.v) * norm(at.w))); },
       angleWords},
      {"reach", &Out::hasAngle, reachLine},
      {"unit", &Out::hasV, unitLine},
      {"unit-dot", &Out::hasV, [](const Out &at) { return withNumbers(dot(at.w, at.e)); }, unitProductWords},
      {"projection", &Out::hasV, projectionLine},
      {"rest", &Out::hasV, [](const Out &at) { return withNumbers(at.h == at.w - at.vPrime); },
       says("What is left of {w} when its part along {v} is taken away.")},
      {"perpendicular", &Out::hasV, perpendicularLine},
      {"other-projection", &Out::hasW, otherProjectionLine}};
}

/// The projection of a vector onto another from where that starts, with the way across from the vector's tip.
void drawProjection(Figure &figure, const Term &prime, const Given<VectorObject> &vector,
                    const Given<VectorObject> &onto) {
  const Place from = place(onto.object.start);
  const Place foot = from + place(prime);
  const Place across = place(vector.object.vector) - place(prime);
  drawMoved(figure, prime->mark, from, vector);
  if (!isZero(vectorOf(prime)))
    figure.add(inLook(onto.look, arrowOf(prime, from, Role::Result, Subject::Neutral)));
  if (across == Place(0))
    return;
  figure.add(SegmentMark{{prime->mark + "/way", Role::Helper, Subject::Measure}, foot, foot + across});
  figure.add(RightAngleMark{
      {prime->mark + "/angle", Role::Helper, Subject::Measure}, foot, place(onto.object.vector), across});
}

Figure draw(const Out &at) {
  Figure figure;
  const auto &[v, w] = std::tie(at.in.v, at.in.w);
  const Place from = place(v.object.start);
  if (at.hasAngle) {
    drawMoved(figure, at.theta->mark, from, w);
    figure.add(ArcMark{drawn(at.theta, Role::Derived, Subject::Neutral), from, place(at.v), place(at.w)});
  }
  if (at.hasV) {
    const MarkBase unit = drawn(at.e, Role::Derived, Subject::Neutral);
    figure.add(inLook(v.look, ArrowMark{unit, from, unitOf(v.object.vector)}));
    drawProjection(figure, at.vPrime, w, v);
    if (!isZero(at.wOntoV.rejection))
      figure.add(arrowOf(at.h, from + place(at.vPrime), Role::Result, Subject::Measure));
  }
  if (at.hasW)
    drawProjection(figure, at.wPrime, v, w);
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  return turnedNearby(at.in.v, at.in.w, "w",
                      {is("case", "right"), is("case", at.sign > 0 ? "same-direction" : "opposite")});
}

/// The numbers of one projection, as the query has them.
ValueRow<Out> projectionRow(const char *name, When<Out> stands, ProjectedVector<Rational> Out::*parts) {
  const auto coordinates = [](const ExactVec3 &vector) {
    return Value(std::vector<Surd>{vector.x, vector.y, vector.z});
  };
  return valueGroup<Out>(
      name, std::move(stands),
      {{named::number("scalar"), always, [=](const Out &at) { return Value((at.*parts).scalar); }},
       {named::vector("projection"), always,
        [=](const Out &at) { return coordinates((at.*parts).projection); }},
       {named::vector("rejection"), always,
        [=](const Out &at) { return coordinates((at.*parts).rejection); }}});
}

} // namespace

Construction dot_product_projection() {
  return taught<Out, VectorObject, VectorObject>(
      {.id = "dot-product-projection",
       .word = "dot",
       .title = [] { return words("dot product, projection"); },
       .roles = {"v", "w"},
       .letters = {"θ", "e", "h"},
       .cases = {"acute", "right", "obtuse", "same-direction", "opposite", "zero-vector"},
       .values = {{named::number("dot"), always, &Out::product},
                  {named::word("sign", {"positive", "zero", "negative"}), always,
                   [](const Out &at) {
                     return ToldValue(words("sign of the dot product"), signWord(at.sign));
                   }},
                  {named::number("length_v"), always, [](const Out &at) { return norm(at.v); }},
                  {named::number("length_w"), always, [](const Out &at) { return norm(at.w); }},
                  {named::vector("unit_v"), &Out::hasV, &Out::e},
                  projectionRow("onto_v", &Out::hasV, &Out::wOntoV),
                  projectionRow("onto_w", &Out::hasW, &Out::vOntoW),
                  {named::number("cos_angle"), &Out::hasAngle, &Out::cosine}},
       .lines = lines(),
       .marks = {"theta", "e", "vprime", "h", "wprime"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
