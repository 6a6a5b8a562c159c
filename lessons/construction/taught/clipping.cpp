// What a plane leaves of a triangle on its positive side: where f is 0 on an edge, and one walk around them.
#include "geometry/clip.h"
#include "geometry/triangle.h"
#include "lessons/construction/parts/sided_points.h"
#include "lessons/construction/taught.h"

#include <array>

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<PointObject> A;
  Given<PointObject> B;
  Given<PointObject> C;
};

/// An edge of the triangle on the walk from A to B to C and back to A; the first is edge 1.
struct Edge {
  std::string number;
  SidedPoint from;
  SidedPoint to;
  EdgeClip<Rational> clip;
  Term t; ///< the part of the edge up to the cut
  Term H; ///< the point where it is cut
};

Edge edgeOf(const Naming &naming, const std::string &number, const SidedPoint &from, const SidedPoint &to) {
  const auto clip = clipEdge(vectorOf(from.point), from.measured.f, vectorOf(to.point), to.measured.f);
  return {number,
          from,
          to,
          clip,
          ownName(naming, letter("t", number), clip.t),
          drawnName(naming, letter("H", number), clip.point)};
}

struct Out : Computed<In>, PlaneTerms {
  explicit Out(const In &objects) : Computed(objects), PlaneTerms(termsOf(objects.E)) {}

  bool hasPlane = !isZero(in.E.object.normal);
  bool isTriangle =
      shapeOf(Triangle<Rational>{in.A.object.at, in.B.object.at, in.C.object.at}) == TriangleShape::Proper;
  bool isClipped = hasPlane && isTriangle;

  std::array<SidedPoint, 3> corners{sidedPoint(in, "A", in.E, in.A), sidedPoint(in, "B", in.E, in.B),
                                    sidedPoint(in, "C", in.E, in.C)};
  std::array<Edge, 3> edges{edgeOf(in, "1", corners[0], corners[1]), edgeOf(in, "2", corners[1], corners[2]),
                            edgeOf(in, "3", corners[2], corners[0])};
  std::vector<Term> kept = keptPoints();
  bool isAnyKept = isClipped && !kept.empty();

  [[nodiscard]] bool isCut(std::size_t edge) const { return edges.at(edge).clip.isCut; }
  /// How many corners of the triangle lie on a side of the plane, or in it.
  [[nodiscard]] int countOf(PointPlaneCase which) const {
    int count = 0;
    for (const SidedPoint &corner : corners)
      count += corner.measured.which == which ? 1 : 0;
    return count;
  }

private:
  /// The corners of what is left, as the walk writes them.
  [[nodiscard]] std::vector<Term> keptPoints() const {
    const std::array clips{edges[0].clip, edges[1].clip, edges[2].clip};
    std::vector<Term> all;
    for (const auto &[edge, isCut] : keptCorners<Rational>(clips))
      all.push_back(isCut ? edges.at(edge).H : edges.at(edge).to.point);
    return all;
  }
};

CaseWords tell(const Out &at) {
  if (!at.hasPlane)
    return zeroNormalWords(at);
  if (!at.isTriangle)
    return {"no-triangle",
            words("{A}, {B} and {C} lie on one line: there is no triangle to clip.", at.letters), true};
  const int above = at.countOf(PointPlaneCase::Positive);
  const int below = at.countOf(PointPlaneCase::Negative);
  const WordValues kept{{"corners", namesOf(at.kept)}};
  if (below == 0)
    return {"whole", above == 0 ? words("All three f are 0: the triangle lies in the plane, and all of it "
                                        "is kept.")
                                : words("No f is negative: the whole triangle is kept.")};
  if (above > 0)
    return {"cut",
            at.kept.size() == 3
                ? words("The plane cuts the triangle. What is left is a triangle: {corners}.", kept)
                : words("The plane cuts the triangle. What is left is a quadrilateral: {corners}.", kept)};
  if (at.kept.empty())
    return {"nothing", words("All three f are negative: nothing of the triangle is kept.")};
  return {"touch", at.kept.size() == 1
                       ? words("Only {corners} lies in the plane, and all the rest is cut off: a single "
                               "point is left.",
                               kept)
                       : words("Only the edge between {first} and {last} lies in the plane, and all the "
                               "rest is cut off: a segment is left.",
                               {{"first", plainText(at.kept.front())}, {"last", plainText(at.kept.back())}})};
}

WordValues wordsOf(const Edge &edge) {
  return {{"from", plainText(edge.from.point)}, {"to", plainText(edge.to.point)}, {"H", plainText(edge.H)}};
}

WorkingLine partLine(const Out &at, std::size_t index) {
  const Edge &edge = at.edges.at(index);
  const Term &from = edge.from.f;
  const Term &to = edge.to.f;
  return asked(
      withNumbers(edge.t == from / (from - to)),
      words("This part of the way from {from} to {to} leads to where f is 0.", wordsOf(edge)),
      {{to / (to - from), words("{answer} is the part from {to} on: start at {from}.", wordsOf(edge))},
       {from / (from + to),
        words("{answer} has a sum below the fraction line: f changes by the difference.")},
       {from / (to - from), words("{answer} has the wrong sign: between the ends the part is positive.")}});
}

WorkingLine cutLine(const Out &at, std::size_t index) {
  const Edge &edge = at.edges.at(index);
  return asked(withNumbers(edge.H == edge.from.point + edge.t * (edge.to.point - edge.from.point)),
               words("Here the edge from {from} to {to} is cut.", wordsOf(edge)),
               {{edge.to.point + edge.t * (edge.to.point - edge.from.point),
                 words("{answer} starts at {to}: start at {from}.", wordsOf(edge))}});
}

WorkingLine evenLine(const Out &at, std::size_t index) {
  const Edge &edge = at.edges.at(index);
  return line(withNumbers((1 - edge.t) * edge.from.f + edge.t * edge.to.f),
              words("0: so {H} lies in the plane.", wordsOf(edge)));
}

std::string walkWords(const Edge &edge) {
  const WordValues names = wordsOf(edge);
  switch (edge.clip.which) {
  case EdgeCase::Kept:
    return words("Both {from} and {to} are kept: write down {to}.", names);
  case EdgeCase::Outside:
    return words("Neither {from} nor {to} is kept: write down nothing.", names);
  case EdgeCase::Leaves:
    return edge.clip.isCut ? words("{from} is kept and {to} is not: write down the cut {H}.", names)
                           : words("{from} is kept and {to} is not. The edge leaves the plane at {from} "
                                   "itself: write down nothing.",
                                   names);
  case EdgeCase::Enters:
    break;
  }
  return edge.clip.isCut
             ? words("{from} is not kept and {to} is: write down the cut {H}, then {to}.", names)
             : words("{from} is not kept and {to} is. The edge meets the plane at {to} itself: write down "
                     "only {to}.",
                     names);
}

WorkingLine walkLine(const Out &at, std::size_t index) {
  const Edge &edge = at.edges.at(index);
  return line({compared(edge.from.f, 0), compared(edge.to.f, 0)}, walkWords(edge));
}

bool isClipped(const Out &at, std::size_t /*edge*/) { return at.isClipped; }
bool isCut(const Out &at, std::size_t edge) { return at.isCut(edge); }

constexpr std::array roles{"A", "B", "C"};

LineTable<Out> cornerLines() {
  LineTable<Out> table;
  for (std::size_t i = 0; i < roles.size(); ++i)
    table.push_back({"f-" + std::string(roles.at(i)), always,
                     [i](const Out &at) { return valueLine(at, at, at.corners.at(i)); }});
  return table;
}

LineTable<Out> lines() {
  return joined<LineRow<Out>>(
      {cornerLines(),
       linesOfEach<Out>(
           3, isClipped,
           {{"t", partLine, isCut}, {"cut", cutLine, isCut}, {"even", evenLine, isCut}, {"walk", walkLine}},
           1),
       {{"list", &Out::isAnyKept, [](const Out &at) {
           return resultsLine(at.kept, words("The corners of what is left, in the order of the walk."));
         }}}});
}

void drawTriangle(Figure &figure, const Out &at) {
  for (const Edge &edge : at.edges)
    if (vectorOf(edge.from.point) != vectorOf(edge.to.point))
      figure.add(SegmentMark{{at.mark("edge" + edge.number), Role::Given, Subject::Triangle},
                             place(edge.from.point),
                             place(edge.to.point)});
}

/// What is left, with its new corners.
void drawKept(Figure &figure, const Out &at) {
  std::vector<Place> corners;
  for (const Term &corner : at.kept)
    corners.push_back(place(corner));
  MarkBase kept{at.mark("kept"), Role::Result, Subject::Triangle};
  if (corners.size() > 2)
    figure.add(PolygonMark{std::move(kept), std::move(corners)});
  else if (corners.size() == 2)
    figure.add(SegmentMark{std::move(kept), corners[0], corners[1]});
  for (const Edge &edge : at.edges) // also where a step does not name them
    if (edge.clip.isCut)
      figure.add(PointMark{{at.mark("kept/" + edge.number), Role::Result, Subject::Measure}, place(edge.H)});
}

Figure draw(const Out &at) {
  Figure figure;
  drawTriangle(figure, at);
  for (const SidedPoint &corner : at.corners)
    drawSide(figure, at.in.E, corner, latexOf(calculated(corner.f)));
  for (const Edge &edge : at.edges)
    if (edge.clip.isCut) {
      figure.add(pointOf(edge.H, Role::Result, Subject::Measure));
      figure.reaches.push_back({at.in.E.id, place(edge.H)});
    }
  if (at.isClipped)
    drawKept(figure, at);
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (at.hasPlane)
    for (const SidedPoint &corner : at.corners)
      addIntoPlane(at.in.E.object, corner, is("f_" + corner.role, "0"), all);
  return all;
}

Word wordOf(EdgeCase which) {
  switch (which) {
  case EdgeCase::Kept:
    return {"kept", words("both ends are kept")};
  case EdgeCase::Leaves:
    return {"leaves", words("only the start is kept")};
  case EdgeCase::Enters:
    return {"enters", words("only the end is kept")};
  case EdgeCase::Outside:
    break;
  }
  return {"outside", words("neither end is kept")};
}

ValueTable<Out> cornerRows() {
  ValueTable<Out> table;
  for (std::size_t i = 0; i < roles.size(); ++i)
    table.push_back({named::number("f_" + std::string(roles.at(i))), always,
                     [i](const Out &at) { return at.corners.at(i).f; }});
  return table;
}

ValueTable<Out> edgeRows(std::size_t index) {
  const std::string number = std::to_string(index + 1);
  const auto cut = [index](const Out &at) { return at.isCut(index); };
  return {{named::word("edge" + number, {"kept", "leaves", "enters", "outside"}), &Out::isClipped,
           [index](const Out &at) {
             const Edge &edge = at.edges.at(index);
             return ToldValue(words("edge {number}", {{"number", edge.number}}), wordOf(edge.clip.which));
           }},
          {named::number("t" + number), cut, [index](const Out &at) { return at.edges.at(index).t; }},
          {named::vector("cut" + number), cut, [index](const Out &at) { return at.edges.at(index).H; }}};
}

ValueTable<Out> values() {
  return joined<ValueRow<Out>>(
      {cornerRows(),
       {{named::number("nn"), always, [](const Out &at) { return dot(at.n, at.n); }}},
       edgeRows(0),
       edgeRows(1),
       edgeRows(2),
       {{named::number("corners"), &Out::isClipped, [](const Out &at) {
           return ToldValue(words("corners of what is left"), Surd(static_cast<int>(at.kept.size())));
         }}}});
}

} // namespace

Construction clipping() {
  return taught<Out, PlaneObject, PointObject, PointObject, PointObject>(
      {.id = "clipping",
       .title = [] { return words("polygon cut off at the plane"); },
       .roles = {"E", "A", "B", "C"},
       .letters = {"f", "t1", "t2", "t3", "H1", "H2", "H3"},
       .cases = {"cut", "whole", "nothing", "touch", "no-triangle", "zero-normal"},
       .values = values(),
       .lines = lines(),
       .marks = {"edge1", "edge2", "edge3", "side-A", "side-B", "side-C", "H1", "H2", "H3", "kept"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
