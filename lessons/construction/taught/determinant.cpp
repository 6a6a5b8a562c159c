// The determinant of three vectors: the volume of the box that they span, with the sign of their order; and
// the cross product with a cross product (the identity of note PG 6.2).
#include "geometry/project_vector.h"
#include "geometry/three_vectors.h"
#include "lessons/construction/parts/expansion.h"
#include "lessons/construction/parts/spanned_box.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/vector.h"

#include <array>
#include <tuple>

namespace halfspace {
namespace {

struct In : Naming {
  Given<VectorObject> u;
  Given<VectorObject> v;
  Given<VectorObject> w;
};

struct Out : Computed<In> {
  explicit Out(const In &objects) : Computed(objects) {}

  const ExactVec3 &start = in.u.object.start; ///< all is drawn from there: a vector is the same everywhere
  ThreeVectors<Rational> three = relateVectors(in.u.object.vector, in.v.object.vector, in.w.object.vector);
  const Rational &det = three.determinant;
  Rational baseSquared = dot(three.normal, three.normal);
  bool hasBase = baseSquared != 0;
  bool hasVolume = det != 0;
  /// Whether the box would hold more with a w that is upright and as long.
  bool canGrow = det * det < baseSquared * dot(in.w.object.vector, in.w.object.vector);

  Term u = termOf(in.u);
  Term v = termOf(in.v);
  Term w = termOf(in.w);
  Term n = drawnName(vectorLetter("n"), three.normal);
  Term D = ownName(letter("D"), det).marked(mark("box"));
  Term V = ownName(letter("V"), abs(det)).marked(mark("box"));
  Term T = ownName(letter("T"), Rational(abs(det) / 6)).marked(mark("tetrahedron"));
  /// How far w reaches along n.
  Term h =
      drawnName(letter("h"), hasBase ? std::optional<TermValue>(overRoot(det, baseSquared)) : std::nullopt);
  Term p = drawnName(vectorLetter("p"), three.other);
  Term q = drawnName(vectorLetter("q"), three.twice);
};

bool isZeroVector(const Term &vector) { return isZero(vectorOf(vector)); }

/// Two vectors along one line; requires that there are some.
std::pair<Term, Term> twoAlongOneLine(const Out &at) {
  if (isZero(at.three.normal))
    return {at.u, at.v};
  return isZero(at.three.other) ? std::pair(at.v, at.w) : std::pair(at.u, at.w);
}

CaseWords tell(const Out &at) {
  switch (at.three.which) {
  case ThreeVectorsCase::RightHanded:
    return {"right-handed", words("{D} is positive: {u}, {v} and {w}, in this order, are right-handed.",
                                  at.letters, {{"D", equation(at.D)}})};
  case ThreeVectorsCase::LeftHanded:
    return {"left-handed", words("{D} is negative: {u}, {v} and {w}, in this order, are left-handed.",
                                 at.letters, {{"D", equation(at.D)}})};
  case ThreeVectorsCase::Flat:
    return {"flat", words("D = 0: {u}, {v} and {w} lie in one plane, and the box is flat.", at.letters)};
  case ThreeVectorsCase::Parallel: {
    const auto [first, second] = twoAlongOneLine(at);
    return {"parallel",
            words("{first} and {second} lie along one line: the box is flat, and D = 0.",
                  {{"first", plainText(first)}, {"second", plainText(second)}}),
            true};
  }
  case ThreeVectorsCase::ZeroVector:
    break;
  }
  const Term &zero = isZeroVector(at.u) ? at.u : isZeroVector(at.v) ? at.v : at.w;
  return {"zero-vector",
          words("{zero} is the zero vector: there is no box, and D = 0.", {{"zero", plainText(zero)}}), true};
}

ToldValue orientationValue(const Out &at) {
  return {words("orientation"), at.det > 0   ? Word{"right-handed", words("right-handed")}
                                : at.det < 0 ? Word{"left-handed", words("left-handed")}
                                             : Word{"none", words("none")}};
}

/// What becomes of the volume when w stands upright on the base, and is as long as before.
ToldValue straightenedValue(const Out &at) {
  return {words("volume with {w} upright", at.letters),
          at.canGrow ? Word{"larger", words("larger")} : Word{"same", words("the same")}};
}

WorkingLine crossLine(const Term &result, const Term &first, const Term &second,
                      std::vector<WrongTerm> mistakes = {}) {
  const WordValues both{{"first", plainText(first)}, {"second", plainText(second)}};
  mistakes.push_back({cross(second, first), words("{answer} is the cross product the other way round.")});
  return asked(withProducts(result == cross(first, second)),
               isZeroVector(result) ? words("The zero vector: {first} and {second} span no plane.", both)
                                    : words("Perpendicular to {first} and to {second}.", both),
               std::move(mistakes));
}

std::string areaWords(const Out &at) {
  return at.hasBase ? words("The area of the base, the parallelogram of {u} and {v}.", at.letters)
                    : words("0: {u} and {v} span no base.", at.letters);
}

std::string heightWords(const Out &at) {
  if (at.det > 0)
    return words("This is how far {w} reaches along n: the height of the box.", at.letters);
  if (at.det < 0)
    return words("Negative: {w} and n point to different sides of the base.", at.letters);
  return isZeroVector(at.w) ? words("0: {w} is the zero vector.", at.letters)
                            : words("0: {w} lies in the plane of the base.", at.letters);
}

WorkingLine heightLine(const Out &at) {
  const Term product = dot(at.n, at.w);
  return asked(
      withNumbers(at.h == product / norm(at.n)), heightWords(at),
      {{product, words("{answer} is n·{w}: divide by |n|.", at.letters)},
       {product / dot(at.n, at.n), words("{answer} is divided by n·n: divide by its root, |n|.")},
       {norm(at.w), words("{answer} is the length of {w}, not how far it reaches along n.", at.letters)}});
}

std::string determinantWords(const Out &at) {
  if (!at.hasVolume)
    return words("0: the box has no volume.");
  return at.det > 0 ? words("Positive: {w} and n are on the same side of the base.", at.letters)
                    : words("Negative: {w} and n are on different sides of the base.", at.letters);
}

WorkingLine determinantLine(const Out &at) {
  return asked(withProducts(at.D == dot(at.n, at.w)), determinantWords(at),
               {{-at.D, words("{answer} has the wrong sign.")}});
}

/// The determinant of the same vectors from another one on.
LineRow<Out> movedOnRow(const char *line, Term Out::*first, Term Out::*second, Term Out::*third) {
  return {line, always,
          [=](const Out &at) { return withProducts(dot(cross(at.*first, at.*second), at.*third)); },
          [=](const Out &at) {
            return words("Moved on in a circle, to {first}, {second}, {third}: this is D again.",
                         {{"first", plainText(at.*first)},
                          {"second", plainText(at.*second)},
                          {"third", plainText(at.*third)}});
          }};
}

WorkingLine lastColumnLine(const Out &at) {
  return expansionLine(at.D, {at.u, at.v, at.w}, 2,
                       words("By its last column: each number of {w} times what is left without its row and "
                             "column. Signs: plus, minus, plus.",
                             at.letters));
}

/// One number from each column and each row: along the diagonals that fall, and then those that rise.
Term sixProducts(const Term &whole) {
  const Term square = columnsPutIn(whole);
  std::vector<Term> products;
  for (const std::size_t step : {1U, 2U})
    for (std::size_t row = 0; row < 3; ++row) {
      const Term each = product({square->parts[3 * row], square->parts[3 * ((row + step) % 3) + 1],
                                 square->parts[3 * ((row + 2 * step) % 3) + 2]});
      products.push_back(step == 1 ? each : -each);
    }
  return sum(std::move(products));
}

WorkingLine sixLine(const Out &at) {
  const Term whole = determinant(3, {at.u, at.v, at.w});
  return asked((at.D == whole).then(sixProducts(whole)).then(calculated(whole)),
               words("Three products with plus and three with minus."));
}

WorkingLine tetrahedronLine(const Out &at) {
  return asked(
      withNumbers(at.T == norm(at.D) / 6),
      at.hasVolume ? words("The volume of the tetrahedron: a sixth of the box.")
                   : words("0: the four corners lie in one plane."),
      {{norm(at.D) / 3, words("{answer} is a third. The base is a triangle, only half a parallelogram: "
                              "divide by 6.")}});
}

WorkingLine twiceLine(const Out &at) {
  return crossLine(at.q, at.u, at.p,
                   {{cross(at.n, at.w), words("{answer} is ({u} × {v}) × {w}: here the parentheses stand "
                                              "around the last two.",
                                              at.letters)}});
}

WorkingLine ruleLine(const Out &at) {
  const auto &[u, v, w] = std::tie(at.u, at.v, at.w);
  return asked(
      withNumbers(at.q == dot(u, w) * v - dot(u, v) * w),
      words("Each of {v} and {w} is multiplied by the dot product of the other two.", at.letters),
      {{dot(u, v) * v - dot(u, w) * w, words("{answer} has the two dot products in each other's place.")},
       {dot(u, v) * w - dot(u, w) * v, words("{answer} has the wrong sign: {v} has the plus.", at.letters)}});
}

LineTable<Out> lines() {
  return {{"n", always, [](const Out &at) { return crossLine(at.n, at.u, at.v); }},
          {"area", always, [](const Out &at) { return withProducts(norm(at.n) == root(dot(at.n, at.n))); },
           areaWords},
          {"height", &Out::hasBase, heightLine},
          {"det", always, determinantLine},
          {"volume", always, [](const Out &at) { return withNumbers(at.V == norm(at.D)); },
           says("The volume of the box: the determinant without its sign.")},
          {"swapped", always, [](const Out &at) { return withProducts(dot(cross(at.v, at.u), at.w)); },
           says("{u} and {v} have changed places: this is −D.")},
          movedOnRow("moved-on", &Out::v, &Out::w, &Out::u),
          movedOnRow("moved-twice", &Out::w, &Out::u, &Out::v),
          {"expansion", always, lastColumnLine},
          {"six", always, sixLine},
          {"tetrahedron", always, tetrahedronLine},
          {"p", always, [](const Out &at) { return crossLine(at.p, at.v, at.w); }},
          {"q", always, twiceLine},
          {"rule", always, ruleLine}};
}

/// From the tip of w straight down to the plane of the base.
void drawHeight(Figure &figure, const Out &at) {
  const ExactVec3 along = at.three.normal * Rational(at.det / at.baseSquared);
  const ExactVec3 tip = at.start + at.in.w.object.vector;
  const Place foot = place(ExactVec3(tip - along));
  const Place back = place(at.start) - foot;
  figure.add(SegmentMark{drawn(at.h, Role::Derived, Subject::Measure), place(tip), foot});
  if (tip - along != at.start)
    figure.add(SegmentMark{{at.h->mark + "/base", Role::Helper, Subject::Measure}, place(at.start), foot});
  figure.add(RightAngleMark{{at.h->mark + "/angle", Role::Helper, Subject::Measure},
                            foot,
                            place(along),
                            tip - along != at.start ? back : place(at.u)});
}

/// Cross products are drawn this long in every picture: only their directions matter.
constexpr double drawnProductLength = 2;

Figure draw(const Out &at) {
  Figure figure;
  const Place from = place(at.start);
  const auto &[u, v, w] = std::tie(at.in.u.object.vector, at.in.v.object.vector, at.in.w.object.vector);
  addSpannedBox(figure, {at.mark("box"), Role::Given, Subject::Neutral}, at.start, {u, v, w});
  addDirection(figure, at.n, from, drawnProductLength, Role::Derived, Subject::Plane);
  addParallelogram(figure, {at.n->mark + "/base", Role::Helper, Subject::Plane}, at.start, u, v);
  addDirection(figure, at.p, from, drawnProductLength, Role::Derived, Subject::Plane);
  addParallelogram(figure, {at.p->mark + "/face", Role::Helper, Subject::Plane}, at.start, v, w);
  addDirection(figure, at.q, from, drawnProductLength, Role::Result, Subject::Measure);
  if (!at.hasVolume)
    return figure;
  drawHeight(figure, at);
  figure.add(PolygonMark{{at.T->mark, Role::Result, Subject::Measure},
                         {from + place(u), from + place(v), from + place(w)}});
  return figure;
}

/// A vector in the plane of the other two, w upright on the base, and two along one line.
std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (at.three.which == ThreeVectorsCase::Parallel || at.three.which == ThreeVectorsCase::ZeroVector)
    return all;
  const std::array objects{at.in.u.object, at.in.v.object, at.in.w.object};
  const std::array letters{plainText(at.u), plainText(at.v), plainText(at.w)};
  const auto add = [&](const Conditions &when, std::string sentence, std::size_t changed,
                       const ExactVec3 &vector) {
    all.push_back({when, std::move(sentence), std::array{"u", "v", "w"}.at(changed),
                   VectorObject{objects.at(changed).start, vector}});
  };
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const ExactVec3 &vector = objects.at(i).vector;
    const std::size_t next = (i + 1) % objects.size();
    const ExactVec3 across = cross(objects.at(next).vector, objects.at((i + 2) % objects.size()).vector);
    if (at.hasVolume)
      add(is("det", "0"), words("{u}, {v} and {w} would lie in one plane.", at.letters), i,
          projectVector(vector, across).rejection);
    if (dot(vector, objects.at(next).vector) != 0)
      add(is("case", "parallel"),
          words("{first} and {second} would lie along one line.",
                {{"first", letters.at(i)}, {"second", letters.at(next)}}),
          i, projectVector(vector, objects.at(next).vector).projection);
  }
  if (at.hasVolume && at.canGrow)
    add(is("straightened", "same"), words("{w} would be perpendicular to {u} and {v}.", at.letters), 2,
        projectVector(objects[2].vector, at.three.normal).projection);
  return all;
}

} // namespace

Construction determinant() {
  return taught<Out, VectorObject, VectorObject, VectorObject>(
      {.id = "determinant",
       .title = [] { return words("determinant, volume"); },
       .roles = {"u", "v", "w"},
       .letters = {"n", "D", "V", "T", "h", "p", "q"},
       .cases = {"right-handed", "left-handed", "flat", "parallel", "zero-vector"},
       .values = {{named::number("det"), always, &Out::D},
                  {named::number("volume"), always, &Out::V},
                  {named::number("tetrahedron"), always, &Out::T},
                  {named::vector("normal"), always, &Out::n},
                  {named::number("base_area"), always, [](const Out &at) { return norm(at.n); }},
                  {named::number("height"), &Out::hasBase, [](const Out &at) { return norm(at.h); }},
                  {named::word("orientation", {"right-handed", "left-handed", "none"}), always,
                   orientationValue},
                  {named::word("straightened", {"larger", "same"}), always, straightenedValue},
                  {named::vector("double_cross"), always, &Out::q}},
       .lines = lines(),
       .marks = {"box", "n", "h", "tetrahedron", "p", "q"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
