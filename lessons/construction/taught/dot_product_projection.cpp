// The dot product of two vectors, and what each is along the other and across it (notes PG 6.1 and RP).
#include "geometry/project_vector.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/vector.h"
#include "lessons/object/letters.h"
#include "lessons/term/angle.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/prime.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <tuple>

namespace halfspace {
namespace {

struct In : Naming {
  Given<VectorObject> v;
  Given<VectorObject> w;
};

struct Out : Naming {
  ProjectedVector<Rational> wOntoV, vOntoW;
  int sign; ///< of v·w: −1, 0, 1
  bool areParallel;
  Term v, w;
  Term product;       ///< v·w
  Term theta, cosine; ///< of the angle between them
  Term e;             ///< the unit vector of v
  Term vPrime;        ///< w projected onto v: a multiple of v
  Term wPrime;        ///< v projected onto w
  Term h;             ///< what is left of w: across v

  [[nodiscard]] bool hasZero() const { return isZero(vectorOf(v)) || isZero(vectorOf(w)); }
};

/// The unit vector of a direction; the zero vector has none.
std::vector<Surd> unitCoordinates(const ExactVec3 &direction) {
  const Rational square = dot(direction, direction);
  std::vector<Surd> unit;
  unit.reserve(3);
  for (int axis = 0; axis < 3; ++axis)
    unit.push_back(square == 0 ? Surd() : overRoot(direction[axis], square));
  return unit;
}

/// 0 where there is no angle.
Surd cosineBetween(const ExactVec3 &v, const ExactVec3 &w) {
  const Rational squares = dot(v, v) * dot(w, w);
  return squares == 0 ? Surd() : overRoot(dot(v, w), squares);
}

/// What becomes of a vector's letter when another is projected onto it.
Term primeOf(const Given<VectorObject> &onto, const ExactVec3 &projection, const std::string &mark) {
  return name(primed(onto.letters[1]), projection).marked(mark);
}

Out compute(const In &in) {
  const ExactVec3 &v = in.v.object.vector;
  const ExactVec3 &w = in.w.object.vector;
  const auto wOntoV = projectVector(w, v);
  const auto vOntoW = projectVector(v, w);
  const Term theta = name(in.own(letter("θ")), std::nullopt).marked(in.mark("theta"));
  return {in,
          wOntoV,
          vOntoW,
          dot(v, w).sign(),
          isZero(cross(v, w)),
          termOf(in.v),
          termOf(in.w),
          dot(termOf(in.v), termOf(in.w)),
          theta,
          applied(word("cos"), theta, cosineBetween(v, w)),
          name(in.own(vectorLetter("e")), unitCoordinates(v)).marked(in.mark("e")),
          primeOf(in.v, wOntoV.projection, in.mark("vprime")),
          primeOf(in.w, vOntoW.projection, in.mark("wprime")),
          name(in.own(vectorLetter("h")), wOntoV.rejection).marked(in.mark("h"))};
}

CaseWords tell(const In &, const Out &at) {
  const std::string product = equation(at.product);
  if (at.hasZero())
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

/// The numbers of one projection, as the query has them.
NamedValue projectionValues(std::string name, const ProjectedVector<Rational> &parts) {
  const auto coordinates = [](const ExactVec3 &vector) {
    return std::vector<Surd>{vector.x, vector.y, vector.z};
  };
  return {std::move(name),
          {},
          std::vector<NamedValue>{{"scalar", {}, parts.scalar},
                                  {"projection", {}, coordinates(parts.projection)},
                                  {"rejection", {}, coordinates(parts.rejection)}}};
}

const char *signName(int sign) { return sign > 0 ? "positive" : sign < 0 ? "negative" : "zero"; }

std::vector<NamedValue> valuesOf(const In &in, const Out &at) {
  const ExactVec3 &v = in.v.object.vector;
  const ExactVec3 &w = in.w.object.vector;
  std::vector<NamedValue> values{listed("dot", at.product),
                                 {"sign", words("sign of the dot product"), signName(at.sign)},
                                 {"length_v", norm(at.v), Surd::root(dot(v, v))},
                                 {"length_w", norm(at.w), Surd::root(dot(w, w))}};
  if (!isZero(v)) {
    values.push_back(listed("unit_v", at.e));
    values.push_back(projectionValues("onto_v", at.wOntoV));
  }
  if (!isZero(w))
    values.push_back(projectionValues("onto_w", at.vOntoW));
  if (!at.hasZero())
    values.push_back(listed("cos_angle", at.cosine));
  return values;
}

std::vector<MadeObject> make(const In &, const Out &) { return {}; }

WorkingLine productLine(const Out &at) {
  return asked(withProducts(at.product),
               words("Multiply x by x, y by y and z by z, and add the three products."));
}

WorkingLine lengthLine(const Term &vector) {
  return asked(withProducts(norm(vector) == root(dot(vector, vector))));
}

WorkingLine cosineLine(const Out &at) {
  const std::string degrees = relatedText(degreesOf(at.cosine)); // with its relation
  return asked(withNumbers(at.cosine == at.product / (norm(at.v) * norm(at.w))),
               words("θ{degrees}°: the angle between {v} and {w}.", at.letters, {{"degrees", degrees}}));
}

WorkingLine reachLine(const Out &at) {
  return asked(
      withNumbers((norm(at.w) * at.cosine).marked(at.vPrime->mark) == at.product / norm(at.v)),
      words("So far does {w} reach along {v}. It is negative when {w} reaches backwards.", at.letters),
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

WorkingLine unitProductLine(const Out &at) {
  return asked(withNumbers(dot(at.w, at.e)),
               at.hasZero()
                   ? words("With a unit vector there is nothing to divide by.")
                   : words("The same number once more: with a unit vector there is nothing to divide by."));
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

WorkingLine restLine(const Out &at) {
  return asked(withNumbers(at.h == at.w - at.vPrime),
               words("What is left of {w} when its part along {v} is taken away.", at.letters));
}

WorkingLine perpendicularLine(const Out &at) {
  return line(withProducts(dot(at.h, at.v)),
              isZero(at.wOntoV.rejection) ? words("0, because nothing is left.")
                                          : words("Always 0: the rest is perpendicular to {v}.", at.letters));
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  lines.add("dot", [&at] { return productLine(at); });
  lines.add("length-v", [&at] { return lengthLine(at.v); });
  lines.add("length-w", [&at] { return lengthLine(at.w); });
  if (!at.hasZero())
    lines.add("cosine", [&at] { return cosineLine(at); });
  if (!at.hasZero())
    lines.add("reach", [&at] { return reachLine(at); });
  if (!isZero(vectorOf(at.v))) {
    lines.add("unit", [&at] { return unitLine(at); });
    lines.add("unit-dot", [&at] { return unitProductLine(at); });
    lines.add("projection", [&at] { return projectionLine(at); });
    lines.add("rest", [&at] { return restLine(at); });
    lines.add("perpendicular", [&at] { return perpendicularLine(at); });
  }
  if (!isZero(vectorOf(at.w)))
    lines.add("other-projection", [&at] { return otherProjectionLine(at); });
  return lines;
}

/// A vector drawn once more from where the other starts, so that both start from one point: it is the same
/// vector there.
void drawMoved(Figure &figure, const std::string &leader, const Place &from,
               const Given<VectorObject> &moved) {
  if (from != place(moved.object.start))
    figure.add(
        inLook(moved.look, ArrowMark{{leader + "/moved", Role::Ghost}, from, place(moved.object.vector)}));
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

Figure draw(const In &in, const Out &at) {
  Figure figure;
  const VectorObject &v = in.v.object;
  const VectorObject &w = in.w.object;
  const Place from = place(v.start);
  if (!at.hasZero()) {
    drawMoved(figure, at.theta->mark, from, in.w);
    figure.add(
        ArcMark{drawn(at.theta, Role::Derived, Subject::Neutral), from, place(v.vector), place(w.vector)});
  }
  if (!isZero(v.vector)) {
    figure.add(
        inLook(in.v.look, ArrowMark{drawn(at.e, Role::Derived, Subject::Neutral), from, unitOf(v.vector)}));
    drawProjection(figure, at.vPrime, in.w, in.v);
    if (!isZero(at.wOntoV.rejection))
      figure.add(arrowOf(at.h, from + place(at.vPrime), Role::Result, Subject::Measure));
  }
  if (!isZero(w.vector))
    drawProjection(figure, at.wPrime, in.v, in.w);
  return figure;
}

/// What w would be, turned or stretched, for which something special holds.
std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  std::vector<SpecialCase> all;
  if (at.hasZero() || at.sign == 0)
    return all;
  const auto add = [&](const char *when, std::string sentence, const ExactVec3 &w) {
    all.push_back({when, std::move(sentence), "w", VectorObject{in.w.object.start, w}});
  };
  if (at.areParallel)
    return all;
  add("case = right", words("{v} and {w} would be perpendicular.", at.letters), at.wOntoV.rejection);
  add(at.sign > 0 ? "case = same-direction" : "case = opposite",
      words("{v} and {w} would lie along one line.", at.letters), at.wOntoV.projection);
  return all;
}

} // namespace

Construction dot_product_projection() {
  const auto projection = [](const char *name) {
    return named::group(name,
                        {named::number("scalar"), named::vector("projection"), named::vector("rejection")});
  };
  return makeConstruction<In, Out, VectorObject, VectorObject>(
      "dot-product-projection", {"v", "w"}, {}, {"θ", "e", "h"},
      {.cases = {"acute", "right", "obtuse", "same-direction", "opposite", "zero-vector"},
       .values = {named::number("dot"), named::word("sign", {"positive", "zero", "negative"}),
                  named::number("length_v"), named::number("length_w"), named::vector("unit_v"),
                  projection("onto_v"), projection("onto_w"), named::number("cos_angle")},
       .lines = {"dot", "length-v", "length-w", "cosine", "reach", "unit", "unit-dot", "projection", "rest",
                 "perpendicular", "other-projection"},
       .marks = {"theta", "e", "vprime", "h", "wprime"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
