// Where a ray goes into a convex solid and where it comes out, by one product with each edge (note PL): an
// edge is shared by two faces, which run along it in opposite directions.
//
// Long because a solid has edges, faces and up to two places that the ray meets, each with lines, words and
// marks of its own, and because a line that only touches a solid, or runs along it, is told apart from one
// that goes through.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_solid.h"
#include "geometry/project_vector.h"
#include "geometry/solid_shape.h"
#include "lessons/construction/parts/place_rows.h"
#include "lessons/construction/parts/ray_marks.h"
#include "lessons/construction/parts/shifted_ray.h"
#include "lessons/construction/parts/solid_edges.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"

#include <algorithm>
#include <optional>

namespace halfspace {
namespace {

// Of a prism over eight corners.
constexpr std::size_t mostEdges = 24;
constexpr std::size_t mostFaces = 10;

struct In : Naming {
  Given<SolidObject> K;
  Given<RayObject> L;
};

/// Where the line goes in, or comes out.
struct Contact {
  SolidCrossing<Rational> crossing;
  FacePart part; ///< of the face
  bool isAhead;  ///< t ≥ 0: the ray gets there
  Term n, t, H;
};

std::vector<Contact> contactsOf(const In &in, const std::vector<SolidEdge> &edges,
                                const RaySolid<Rational> &meet) {
  std::vector<Contact> contacts;
  const auto &[vertices, faces] = in.K.object.mesh;
  for (const auto &crossing : {meet.entered, meet.left}) {
    if (!crossing || meet.which == RaySolidCase::Miss)
      return {};
    const std::string index = std::to_string(contacts.size() + 1);
    const auto &face = faces[crossing->face];
    const auto plane = planeThrough(vertices[face[0]], vertices[face[1]], vertices[face[2]]);
    contacts.push_back({*crossing, partOf(crossing->face, edges), crossing->t >= 0,
                        drawnName(in, vectorLetter("n", index), plane.normal),
                        ownName(in, letter("t", index), crossing->t),
                        madeName(in, "H" + index, crossing->point)});
  }
  return contacts;
}

std::vector<Term> cornersOf(const In &in) {
  std::vector<Term> corners;
  for (std::size_t corner = 0; corner < in.K.object.mesh.vertices.size(); ++corner)
    corners.push_back(cornerTerm(in.K, corner));
  return corners;
}

struct Out : Computed<In>, RayTerms {
  explicit Out(const In &objects) : Computed(objects), RayTerms(termsOf(objects.L)) {}

  const SolidMesh<Rational> &mesh = in.K.object.mesh;
  Ray<Rational> ray{in.L.object.origin, in.L.object.direction};
  bool hasDirection = !isZero(ray.direction);
  SolidShape shape = shapeOf(mesh);
  bool isConvex = shape == SolidShape::Convex;
  bool hasLine = isConvex && hasDirection;
  /// Only of a convex solid.
  RaySolid<Rational> meet = isConvex ? intersectRaySolid(ray, solidOf(mesh)) : RaySolid<Rational>{};

  std::vector<Term> corners = cornersOf(in); ///< in the letters of the solid
  /// The moment of the ray's line.
  Term m = ownName(vectorLetter("m"), lineOf(ray).moment).standingFor(cross(Q, r));
  std::vector<SolidEdge> edges = edgesOf(in, in.K, lineOf(ray));
  // How many edges the faces have one by one, and how many there are.
  Term k = ownName(letter("k"), Rational(sideCount(mesh)));
  Term N = ownName(letter("N"), Rational(static_cast<int>(edges.size())));
  std::vector<Contact> contacts =
      contactsOf(in, edges, meet); ///< where the line goes in, and where it comes out
  bool isMet = !contacts.empty();

  [[nodiscard]] const Contact &entry() const { return contacts.front(); }
  [[nodiscard]] const Contact &exit() const { return contacts.back(); }
  [[nodiscard]] std::string nameOfFace(std::size_t face) const { return faceName(in.K, face); }
};

/// Where the line goes through an edge of its face, the other face of that; else nothing.
std::string otherFaceName(const Contact &contact, const Out &at) {
  if (contact.part != FacePart::Edge)
    return {};
  const std::size_t face = contact.crossing.face;
  const auto shared = std::find_if(at.edges.begin(), at.edges.end(), [face](const SolidEdge &edge) {
    return edge.isOf(face) && edge.product == 0;
  });
  return at.nameOfFace(shared->face == face ? shared->opposite : shared->face);
}

WordValues contactWords(const Out &at) {
  return {{"Q", plainText(at.Q)},
          {"in", at.nameOfFace(at.entry().crossing.face)},
          {"out", at.nameOfFace(at.exit().crossing.face)},
          {"inOther", otherFaceName(at.entry(), at)},
          {"outOther", otherFaceName(at.exit(), at)},
          {"t1", equation(at.entry().t)},
          {"t2", equation(at.exit().t)},
          {"H1", plainText(at.entry().H)},
          {"H2", plainText(at.exit().H)}};
}

/// A ray that goes in through this part of a face: the sentences for where it comes out.
PlaceSentences throughSentences(FacePart in) {
  switch (in) {
  case FacePart::Edge:
    return {
        says("The ray goes in through the edge of {in} and {inOther} at {t1}, and comes out through {out} "
             "at {t2}."),
        says("The ray goes in through the edge of {in} and {inOther} at {t1}, and comes out through the "
             "edge of {out} and {outOther} at {t2}."),
        says("The ray goes in through the edge of {in} and {inOther} at {t1}, and comes out through a "
             "corner of {out} at {t2}.")};
  case FacePart::Vertex:
    return {
        says("The ray goes in through a corner of {in} at {t1}, and comes out through {out} at {t2}."),
        says("The ray goes in through a corner of {in} at {t1}, and comes out through the edge of {out} "
             "and {outOther} at {t2}."),
        says("The ray goes in through a corner of {in} at {t1}, and comes out through a corner of {out} at "
             "{t2}.")};
  default:
    return {says("The ray goes in through {in} at {t1}, and comes out through {out} at {t2}."),
            says("The ray goes in through {in} at {t1}, and comes out through the edge of {out} and "
                 "{outOther} at {t2}."),
            says("The ray goes in through {in} at {t1}, and comes out through a corner of {out} at {t2}.")};
  }
}

constexpr PlaceSentences fromInside{
    says("The ray starts inside: {t1} is behind its start. It comes out through {out} at {t2}."),
    says("The ray starts inside: {t1} is behind its start. It comes out through the edge of {out} and "
         "{outOther} at {t2}."),
    says("The ray starts inside: {t1} is behind its start. It comes out through a corner of {out} at {t2}.")};

std::string throughWords(const Out &at) {
  const WordValues values = contactWords(at);
  if (!at.exit().isAhead)
    return words("The line goes through the solid, but {t1} and {t2} are negative: it is behind the ray's "
                 "start.",
                 values);
  if (at.entry().isAhead)
    return words(sentenceFor(at.exit().part, throughSentences(at.entry().part)), values);
  return at.meet.origin == SolidLocation::On
             ? words("The ray starts on the solid and leads away from it: it has only its start in common "
                     "with it.")
             : words(sentenceFor(at.exit().part, fromInside), values);
}

std::string touchWords(const Out &at) {
  return at.entry().isAhead
             ? words("The ray touches the solid in one point alone, {H1}, with {t1}.", contactWords(at))
             : words("The line touches the solid in one point alone, {H1}. But {t1} is negative: that is "
                     "behind the ray's start.",
                     contactWords(at));
}

std::string alongWords(const Out &at) {
  return at.exit().isAhead
             ? words("The line runs along the surface, from {t1} to {t2}: in a face or an edge, without "
                     "going inside.",
                     contactWords(at))
             : words("The line runs along the surface, but {t1} and {t2} are negative: the solid is behind "
                     "the ray's start.",
                     contactWords(at));
}

CaseWords tellMeeting(const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.contacts) {
  case SolidContacts::Two:
    return {caseName, throughWords(at)};
  case SolidContacts::One:
    return {caseName, touchWords(at)};
  case SolidContacts::Along:
    return {caseName, alongWords(at)};
  case SolidContacts::None:
    break;
  }
  return {caseName, words("The line goes through none of the faces: it misses the solid.")};
}

bool isLetter(const Term &term) { return term->kind == TermKind::Name; }

/// Two corners that have letters and are the same point; none where there are no such two.
std::optional<WordValues> coincidingCorners(const Out &at) {
  const auto &places = at.mesh.vertices;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = i + 1; k < places.size(); ++k)
      if (places[i] == places[k] && isLetter(at.corners[i]) && isLetter(at.corners[k]))
        return WordValues{{"first", plainText(at.corners[i])}, {"second", plainText(at.corners[k])}};
  return {};
}

std::string flatWords(const Out &at) {
  const auto same = coincidingCorners(at);
  return (same ? words("{first} and {second} are the same point.", *same) + " " : std::string()) +
         words("All corners lie in one plane: the solid is flat and has no inside.");
}

/// Of a solid with flat faces that is not convex.
std::string notConvexWords(const Out &at) {
  if (const auto same = coincidingCorners(at))
    return words("{first} and {second} are the same point: a face has a corner too many, and the signs alone "
                 "do not decide.",
                 *same);
  return words("A face bends inwards, crosses itself or has a straight corner: the solid does not count as "
               "convex, and the signs are not asked.");
}

CaseWords tell(const Out &at) {
  if (!at.hasDirection)
    return zeroDirectionWords(at);
  if (isFlat(at.mesh))
    return {"flat", flatWords(at), true};
  switch (at.shape) {
  case SolidShape::Convex:
    return tellMeeting(at);
  case SolidShape::NotPlanar:
    return {"not-planar",
            words("The corners of a face do not lie in one plane: its edges enclose no flat face."), true};
  case SolidShape::NotConvex:
  case SolidShape::NotClosed:
    break;
  }
  return {"not-convex", notConvexWords(at), true};
}

std::string signWords(const Out &at, const SolidEdge &edge) {
  const WordValues values{{"r", plainText(at.r)}};
  if (edge.product > 0)
    return words("Positive: seen with {r} pointing at you, the edge goes counterclockwise around the ray.",
                 values);
  if (edge.product < 0)
    return words("Negative: seen with {r} pointing at you, the edge goes clockwise around the ray.", values);
  const std::string reason = withoutDirectionWords(at.r, edge.e);
  return reason.empty() ? words("Zero: the ray and the edge lie in one plane.") : reason;
}

bool hasEdge(const Out &at, std::size_t index) { return index < at.edges.size(); }

WorkingLine edgeLine(const Out &at, std::size_t index) {
  const SolidEdge &edge = at.edges[index];
  const Term way = wayTerm(at.in.K, edge.from, edge.to);
  return asked(withNumbers(edge.e == way), words("The edge, from one corner to the other."),
               {{-way, words("{answer} points backwards.")}});
}

WorkingLine edgeMomentLine(const Out &at, std::size_t index) {
  const SolidEdge &edge = at.edges[index];
  return momentLine(edge.m, at.corners[edge.from], edge.e, words("The moment of its line."));
}

WorkingLine edgeProductLine(const Out &at, std::size_t index) {
  return productLine(at, at.m, at.edges[index], signWords(at, at.edges[index]));
}

/// What the two faces of an edge make of its one product.
WorkingLine sharedLine(const Out &at, std::size_t index) {
  const SolidEdge &edge = at.edges[index];
  const WordValues faces{{"first", at.nameOfFace(edge.face)}, {"second", at.nameOfFace(edge.opposite)}};
  return resultsLine(
      {edge.p, -edge.p},
      edge.product == 0
          ? words("One product for {first} and {second}: 0, whichever way they run along the edge.", faces)
          : words("One product for two faces. Along {first} the edge runs as its arrow does, along "
                  "{second} the other way: there the sign changes.",
                  faces));
}

std::string faceWords(const Out &at, std::size_t face, const std::vector<Term> &products) {
  const auto hasSign = [&](int wanted) {
    return std::any_of(products.begin(), products.end(),
                       [&](const Term &product) { return sign(*numberOf(product)) == wanted; });
  };
  const WordValues values{{"face", at.nameOfFace(face)}};
  if (!at.isConvex)
    return words("These are the products of {face}. They decide for a convex solid only.", values);
  if (!at.hasDirection)
    return allZeroWithoutRay(at);
  if (hasSign(1) && hasSign(-1))
    return words("Both signs are there: the line misses {face}.", values);
  if (!hasSign(1) && !hasSign(-1))
    return words("All are 0: the line runs in the plane of {face}.", values);
  if (at.meet.contacts == SolidContacts::One)
    return words(
        "No two differ in sign. But the line only touches the solid, in one point, which lies on the "
        "border of {face}: it goes neither in nor out.",
        values);
  if (at.meet.contacts == SolidContacts::Along)
    return words(
        "No two differ in sign. But the line runs along the surface of the solid, and meets {face} at "
        "its border: it goes neither in nor out.",
        values);
  return hasSign(1) ? words("None is negative: the line comes out through {face}.", values)
                    : words("None is positive: the line goes in through {face}.", values);
}

/// The products of a face, as it runs along its edges.
WorkingLine faceLine(const Out &at, std::size_t face) {
  std::vector<Term> products;
  for (const FaceSide &side : sidesOf(at.mesh, face, at.edges))
    products.push_back(side.p);
  return resultsLine(products, faceWords(at, face, products));
}

std::string parameterWords(const Out &at, std::size_t index) {
  if (!at.contacts[index].isAhead)
    return words("Negative: that is behind the start {Q}.", at.letters);
  if (at.meet.contacts != SolidContacts::Two)
    return words("Not negative: the ray itself gets there.");
  return index == 0 ? words("Not negative: the ray itself gets there, and goes in.")
                    : words("Not negative: the ray itself gets there, and comes out.");
}

WorkingLine normalLine(const Out &at, std::size_t index) {
  const Contact &contact = at.contacts[index];
  const auto sides = sidesOf(at.mesh, contact.crossing.face, at.edges);
  const Term &first = sides[0].e;
  const Term &second = sides[1].e;
  return asked(withProducts(contact.n == cross(first, second)),
               words("A normal of {face}, from two of its edges: it points outwards.",
                     {{"face", at.nameOfFace(contact.crossing.face)}}),
               {{cross(second, first),
                 words("{answer} points inwards: it is the cross product the other way round.")}});
}

WorkingLine parameterLine(const Out &at, std::size_t index) {
  const Contact &contact = at.contacts[index];
  const Term &corner = at.corners[at.mesh.faces[contact.crossing.face][0]];
  return asked(
      withNumbers(contact.t == dot(corner - at.Q, contact.n) / dot(at.r, contact.n)),
      parameterWords(at, index),
      {{-contact.t, words("{answer} has the wrong sign: the numerator goes from the start to the face, "
                          "{corner} minus {Q}.",
                          {{"corner", plainText(corner)}, {"Q", plainText(at.Q)}})}});
}

WorkingLine hitLine(const Out &at, std::size_t index) {
  const Contact &contact = at.contacts[index];
  return asked(withNumbers(contact.H == at.Q + contact.t * at.r));
}

// The counts come from the faces, not from coordinates: no number of these lines could be traced to one.

WorkingLine sidesLine(const Out &at) {
  std::vector<Term> counts;
  for (const auto &face : at.mesh.faces)
    counts.emplace_back(static_cast<int>(face.size()));
  return line((at.k == sum(std::move(counts))) == Term(sideCount(at.mesh)),
              words("The edges of each face, face by face."));
}

WorkingLine countLine(const Out &at) {
  return line((at.N == at.k / 2) == Term(static_cast<int>(at.edges.size())),
              words("Each edge belongs to two faces, so it was counted twice."));
}

/// The lines of where the ray goes in, or comes out.
LineTable<Out> contactLines(const char *face, std::size_t index) {
  const std::string number = std::to_string(index + 1);
  const auto of = [index](WorkingLine (*make)(const Out &, std::size_t)) {
    return [make, index](const Out &at) { return make(at, index); };
  };
  return {
      {face, &Out::isMet, [index](const Out &at) { return faceLine(at, at.contacts[index].crossing.face); }},
      {"normal" + number, &Out::isMet, of(normalLine)},
      {"t" + number, &Out::isMet, of(parameterLine)},
      {"hit" + number, &Out::isMet, of(hitLine)}};
}

LineTable<Out> lines() {
  return joined<LineRow<Out>>(
      {{{"moment", always,
         [](const Out &at) { return momentLine(at.m, at.Q, at.r, words("The moment of the ray's line.")); }}},
       linesOfEach<Out>(
           mostEdges, hasEdge,
           {{"e", edgeLine}, {"m", edgeMomentLine}, {"edge", edgeProductLine}, {"shared", sharedLine}}),
       {{"products", always,
         [](const Out &at) {
           return resultsLine(productsOf(at.edges), words("One product for each edge."));
         }}},
       linesOfEach<Out>(mostFaces,
                        [](const Out &at, std::size_t face) { return face < at.mesh.faces.size(); },
                        {{"face", faceLine}}),
       {{"sides", always, sidesLine}, {"count", always, countLine}},
       contactLines("in", 0),
       contactLines("out", 1)});
}

/// In units of the picture: only its direction matters.
constexpr double drawnNormalLength = 2;

/// The face, its normal, and the point in it.
void drawContact(Figure &figure, const Out &at, std::size_t index) {
  const Contact &contact = at.contacts[index];
  std::vector<Place> corners;
  for (const std::uint32_t corner : at.mesh.faces[contact.crossing.face])
    corners.push_back(place(at.corners[corner]));
  const Subject subject = index == 0 ? Subject::EdgeV : Subject::EdgeU;
  figure.add(PolygonMark{{at.mark(index == 0 ? "in" : "out"), Role::Derived, subject}, std::move(corners)});
  const Place point = place(contact.H);
  figure.add(arrowOfLength(drawn(contact.n, Role::Derived, Subject::Plane), point, vectorOf(contact.n),
                           drawnNormalLength));
  figure.add(pointOf(contact.H, contact.isAhead ? Role::Result : Role::Ghost, Subject::Ray));
}

Figure draw(const Out &at) {
  Figure figure;
  // The sign is what decides, and many edges leave no room for more.
  for (const SolidEdge &edge : at.edges)
    addEdge(figure, edge, at.corners[edge.from], at.corners[edge.to],
            edge.product > 0   ? "\\,{+}"
            : edge.product < 0 ? "\\,{-}"
                               : "= 0");
  for (std::size_t i = 0; i < at.contacts.size(); ++i)
    drawContact(figure, at, i);
  if (!at.isMet)
    return figure;
  if (at.exit().isAhead)
    addWayTo(figure, at.in.L, at.exit().H, true);
  if (!at.entry().isAhead)
    addWayTo(figure, at.in.L, at.entry().H, false);
  return figure;
}

/// The ray moved sideways until its line meets a corner or an edge; none of those that it meets already.
void addShifted(const Out &at, std::vector<SpecialCase> &all) {
  const RayObject &ray = at.in.L.object;
  const auto &vertices = at.mesh.vertices;
  const auto isZeroAt = [](std::size_t edge) { return is("products." + std::to_string(edge), "0"); };
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    Conditions when;
    for (std::size_t k = 0; k < at.edges.size(); ++k)
      if (at.edges[k].from == i || at.edges[k].to == i)
        when = both(std::move(when), isZeroAt(k));
    addRayThrough(ray, vertices[i], when,
                  words("The ray's line would go through the corner {corner}.",
                        {{"corner", plainText(withResult(at.corners[i]).last())}}),
                  all);
  }
  for (std::size_t k = 0; k < at.edges.size(); ++k)
    addRayThrough(ray, {vertices[at.edges[k].from], vertices[at.edges[k].to]}, isZeroAt(k),
                  words("The ray's line would go through the edge of {product}.",
                        {{"product", plainText(at.edges[k].p)}}),
                  all);
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.hasDirection || !at.isConvex)
    return all;
  addShifted(at, all);
  if (at.meet.origin != SolidLocation::On)
    for (const Contact &contact : at.contacts)
      all.push_back({is("origin", "on"), words("{Q} would lie on the solid.", at.letters), "L",
                     RayObject{contact.crossing.point, at.in.L.object.direction}});
  return all;
}

ValueRow<Out> contactRow(const char *what, std::size_t index) {
  const auto its = [index](const Out &at) -> const Contact & { return at.contacts[index]; };
  return valueGroup<Out>(
      what, &Out::isMet,
      {{named::vector("point"), always, [its](const Out &at) { return its(at).H; }},
       {named::index("face"), always,
        [its](const Out &at) { return Value(static_cast<int>(its(at).crossing.face)); }},
       {named::word("location", {"interior", "edge", "vertex"}), always,
        [its](const Out &at) { return ToldValue(words("place in the face"), wordOf(its(at).part)); }}});
}

MadeRow<Out> madePoint(const char *name, std::size_t index) {
  return {name, PointObject::kind, &Out::isMet,
          [index](const Out &at) { return PointObject{at.contacts[index].crossing.point}; }};
}

} // namespace

Construction ray_solid_pluecker() {
  return taught<Out, SolidObject, RayObject>(
      {.id = "ray-solid-pluecker",
       .word = "intersect",
       .title = [] { return words("where the ray meets the solid"); },
       .roles = {"K", "L"},
       .makes = {madePoint("H1", 0), madePoint("H2", 1)},
       .letters = joined({{"m", "k", "N", "t1", "t2", "n1", "n2"},
                          numbered("e", mostEdges),
                          numbered("m", mostEdges),
                          numbered("p", mostEdges)}),
       .cases = {"hit", "behind", "miss", "zero-direction", "flat", "not-planar", "not-convex"},
       .values = {{named::list("products", mostEdges), always,
                   [](const Out &at) { return list(productsOf(at.edges)); }},
                  {named::number("sides"), always, &Out::k},
                  {named::number("edges"), always, &Out::N},
                  {named::word("origin", {"outside", "on", "inside"}), &Out::isConvex,
                   [](const Out &at) {
                     return ToldValue(words("place of the start"), wordOf(at.meet.origin));
                   }},
                  {named::word("contacts", {"two", "one", "along", "none"}), &Out::hasLine,
                   [](const Out &at) { return ToldValue(words("common points"), wordOf(at.meet.contacts)); }},
                  {named::list("t", 2), &Out::isMet,
                   [](const Out &at) {
                     return list({at.entry().t, at.exit().t});
                   }},
                  contactRow("entered", 0),
                  contactRow("left", 1)},
       .lines = lines(),
       .marks = joined({numbered("p", mostEdges), {"in", "n1", "H1", "out", "n2", "H2"}}),
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
