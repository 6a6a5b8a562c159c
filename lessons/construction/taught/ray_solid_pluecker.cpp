// Where a ray goes into a convex solid and where it comes out, by one product with each edge (note PL): an
// edge is shared by two faces, which run along it in opposite directions.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_solid.h"
#include "geometry/project_vector.h"
#include "geometry/solid_shape.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/name_rows.h"
#include "lessons/construction/parts/shifted_ray.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/construction/parts/zero_vectors.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/letters.h"
#include "lessons/object/solid.h"
#include "lessons/term/latex.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>
#include <iterator>
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

/// An edge as a line: direction, moment, and the product of the ray's line with it.
struct EdgeTerms {
  std::uint32_t from, to;
  std::uint32_t face;     ///< that runs along it in its direction
  std::uint32_t opposite; ///< that runs along it in the other direction
  Term e, m, p;
  Rational product;
};

/// Where the line goes in, or comes out.
struct Contact {
  SolidCrossing<Rational> crossing;
  FacePart part; ///< of the face
  Term n, t, H;
};

struct Out : Naming, RayTerms {
  SolidMesh<Rational> mesh;
  SolidShape shape;
  bool isFlat;
  RaySolid<Rational> meet;   ///< only of a convex solid
  std::vector<Term> corners; ///< in the letters of the solid
  std::vector<std::string> faceNames;
  Term m; ///< the moment of the ray's line
  std::vector<EdgeTerms> edges;
  Term k, N;                     ///< how many edges the faces have one by one, and how many there are
  std::vector<Contact> contacts; ///< where the line goes in, and where it comes out; or none

  [[nodiscard]] bool isConvex() const { return shape == SolidShape::Convex; }
  [[nodiscard]] const Contact &in() const { return contacts.front(); }
  [[nodiscard]] const Contact &out() const { return contacts.back(); }
};

std::vector<EdgeTerms> edgesOf(const In &in, const SolidMesh<Rational> &mesh, const Line<Rational> &line) {
  std::vector<EdgeTerms> edges;
  const std::vector<FaceEdge> sides = edgesByEnds(mesh.faces);
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) { // each edge has two sides, one behind the other
    const auto &[from, to, face] = sides[i];
    const std::string index = std::to_string(edges.size());
    const std::string mark = in.mark("p" + index);
    const Line<Rational> edge = lineThrough(mesh.vertices[from], mesh.vertices[to]);
    const Rational product = permutedInnerProduct(line, edge);
    const Term e = name(in.own(vectorLetter("e", index)), edge.direction)
                       .marked(mark)
                       .standingFor(wayTerm(in.K, from, to));
    const Term m =
        name(in.own(vectorLetter("m", index)), edge.moment).standingFor(cross(cornerTerm(in.K, from), e));
    const Term p = name(in.own(letter("p", index)), product).marked(mark);
    edges.push_back({from, to, face, sides[i + 1].face, e, m, p, product});
  }
  return edges;
}

/// By how many of its edges the line meets: a crossed face that is convex has two of them at a corner alone.
FacePart partOf(const std::vector<EdgeTerms> &edges, std::size_t face) {
  const auto zeros = std::count_if(edges.begin(), edges.end(), [&](const EdgeTerms &edge) {
    return (edge.face == face || edge.opposite == face) && edge.product == 0;
  });
  return zeros == 0 ? FacePart::Interior : zeros == 1 ? FacePart::Edge : FacePart::Vertex;
}

std::vector<Contact> contactsOf(const In &in, const SolidMesh<Rational> &mesh,
                                const std::vector<EdgeTerms> &edges, const RaySolid<Rational> &meet) {
  std::vector<Contact> contacts;
  for (const auto &crossing : {meet.entered, meet.left}) {
    if (!crossing || meet.which == RaySolidCase::Miss)
      return {};
    const std::string index = std::to_string(contacts.size() + 1);
    const auto &face = mesh.faces[crossing->face];
    const ExactVec3 normal =
        planeThrough(mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]]).normal;
    contacts.push_back({*crossing, partOf(edges, crossing->face),
                        name(in.own(vectorLetter("n", index)), normal).marked(in.mark("n" + index)),
                        name(in.own(letter("t", index)), crossing->t),
                        madeName(in, "H" + index, crossing->point)});
  }
  return contacts;
}

/// The edges of all faces, one by one.
int sidesOf(const SolidMesh<Rational> &mesh) {
  std::size_t count = 0;
  for (const auto &face : mesh.faces)
    count += face.size();
  return static_cast<int>(count);
}

Out compute(const In &in) {
  const SolidMesh<Rational> &mesh = in.K.object.mesh;
  const Ray<Rational> ray{in.L.object.origin, in.L.object.direction};
  const SolidShape shape = shapeOf(mesh);
  const auto meet =
      shape == SolidShape::Convex ? intersectRaySolid(ray, solidOf(mesh)) : RaySolid<Rational>{};
  const RayTerms L = termsOf(in.L);
  std::vector<Term> corners;
  corners.reserve(mesh.vertices.size());
  for (std::size_t corner = 0; corner < mesh.vertices.size(); ++corner)
    corners.push_back(cornerTerm(in.K, corner));
  std::vector<EdgeTerms> edges = edgesOf(in, mesh, lineOf(ray));
  std::vector<std::string> faceNames;
  faceNames.reserve(mesh.faces.size());
  for (std::size_t face = 0; face < mesh.faces.size(); ++face)
    faceNames.push_back(faceName(in.K, face));
  std::vector<Contact> contacts = contactsOf(in, mesh, edges, meet);
  const Term N = name(in.own(letter("N")), Rational(static_cast<int>(edges.size())));
  return {in,
          L,
          mesh,
          shape,
          isFlat(mesh),
          meet,
          std::move(corners),
          std::move(faceNames),
          name(in.own(vectorLetter("m")), lineOf(ray).moment).standingFor(cross(L.Q, L.r)),
          std::move(edges),
          name(in.own(letter("k")), Rational(sidesOf(mesh))),
          N,
          std::move(contacts)};
}

bool isAhead(const Contact &contact) { return contact.crossing.t >= 0; }

/// The face where the line goes in or comes out, or the edge or corner of it.
std::string placeWords(const Contact &contact, const Out &at) {
  const std::size_t face = contact.crossing.face;
  const WordValues values{{"face", at.faceNames[face]}};
  if (contact.part == FacePart::Interior)
    return at.faceNames[face];
  if (contact.part == FacePart::Vertex)
    return words("a corner of {face}", values);
  const auto shared = std::find_if(at.edges.begin(), at.edges.end(), [face](const EdgeTerms &edge) {
    return (edge.face == face || edge.opposite == face) && edge.product == 0;
  });
  const std::size_t other = shared->face == face ? shared->opposite : shared->face;
  return words("the edge of {face} and {other}", values, {{"other", at.faceNames[other]}});
}

WordValues contactWords(const Out &at) {
  return {{"Q", plainText(at.Q)},       {"in", placeWords(at.in(), at)}, {"out", placeWords(at.out(), at)},
          {"t1", equation(at.in().t)},  {"t2", equation(at.out().t)},    {"H1", plainText(at.in().H)},
          {"H2", plainText(at.out().H)}};
}

std::string throughWords(const Out &at) {
  const WordValues values = contactWords(at);
  if (!isAhead(at.out()))
    return words("The line goes through the solid, but {t1} and {t2} are negative: it is behind the ray's "
                 "start.",
                 values);
  if (isAhead(at.in()))
    return words("The ray goes in through {in} at {t1}, and comes out through {out} at {t2}.", values);
  return at.meet.origin == SolidLocation::On
             ? words("The ray starts on the solid and leads away from it: it has only its start in common "
                     "with it.")
             : words("The ray starts inside: {t1} is behind its start. It comes out through {out} at {t2}.",
                     values);
}

std::string touchWords(const Out &at) {
  return isAhead(at.in())
             ? words("The ray touches the solid in one point alone, {H1}, with {t1}.", contactWords(at))
             : words("The line touches the solid in one point alone, {H1}. But {t1} is negative: that is "
                     "behind the ray's start.",
                     contactWords(at));
}

std::string alongWords(const Out &at) {
  return isAhead(at.out())
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
  return words("A face bends inwards, crosses itself or has a straight corner: the solid is not convex, and "
               "the signs alone do not decide.");
}

CaseWords tell(const In &in, const Out &at) {
  if (isZero(in.L.object.direction))
    return zeroDirectionWords(at);
  if (at.isFlat)
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

NamedValue contactValue(const char *what, const Contact &contact) {
  return {
      what,
      {},
      std::vector<NamedValue>{listed("point", contact.H),
                              {"face", {}, static_cast<int>(contact.crossing.face)},
                              {"location", words("place in the face"), std::string(nameOf(contact.part))}}};
}

std::vector<NamedValue> valuesOf(const In &, const Out &at) {
  std::vector<Term> products;
  for (const EdgeTerms &edge : at.edges)
    products.push_back(edge.p);
  std::vector<NamedValue> values{listed("products", list(std::move(products))), listed("sides", at.k),
                                 listed("edges", at.N)};
  if (!at.isConvex())
    return values;
  values.push_back({"origin", words("place of the start"), std::string(nameOf(at.meet.origin))});
  if (at.meet.which == RaySolidCase::ZeroDirection)
    return values;
  values.push_back({"contacts", words("common points"), std::string(nameOf(at.meet.contacts))});
  if (at.contacts.empty())
    return values;
  values.push_back(listed("t", list({at.in().t, at.out().t})));
  values.push_back(contactValue("entered", at.in()));
  values.push_back(contactValue("left", at.out()));
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (at.contacts.empty())
    return {};
  return {{"H1", PointObject{at.in().crossing.point}}, {"H2", PointObject{at.out().crossing.point}}};
}

/// Of a point on a line and the line's direction.
WorkingLine momentLine(const Term &moment, const Term &point, const Term &direction, std::string sentence) {
  return asked(withProducts(moment == cross(point, direction)), std::move(sentence),
               {{cross(direction, point),
                 words("{answer} is the cross product the other way round: begin with the point.")}});
}

std::string signWords(const Out &at, const EdgeTerms &edge) {
  const WordValues values{{"r", plainText(at.r)}};
  if (edge.product > 0)
    return words("Positive: seen with {r} pointing at you, the edge goes counterclockwise around the ray.",
                 values);
  if (edge.product < 0)
    return words("Negative: seen with {r} pointing at you, the edge goes clockwise around the ray.", values);
  const std::string reason = withoutDirectionWords(at.r, edge.e);
  return reason.empty() ? words("Zero: the ray and the edge lie in one plane.") : reason;
}

WorkingLine productLine(const Out &at, const EdgeTerms &edge) {
  const Term &e = edge.e;
  const Term &m = edge.m;
  return asked(
      withNumbers((edge.p == permuted(at.r, at.m, e, m)) == dot(at.r, m) + dot(e, at.m)), signWords(at, edge),
      {{dot(at.r, e) + dot(at.m, m),
        words("{answer} multiplies direction by direction and moment by moment: cross over, each "
              "direction with the other line's moment.")},
       {dot(at.r, at.m) + dot(e, m),
        words("{answer} multiplies each direction by its own line's moment: take the other's.")},
       {dot(at.r, m) - dot(e, at.m), words("{answer} subtracts the second product: the two are added.")}});
}

/// What the two faces of an edge make of its one product.
WorkingLine sharedLine(const Out &at, const EdgeTerms &edge) {
  const WordValues faces{{"first", at.faceNames[edge.face]}, {"second", at.faceNames[edge.opposite]}};
  return line(
      {withResult(edge.p), withResult(-edge.p)},
      edge.product == 0
          ? words("One product for {first} and {second}: 0, whichever way they run along the edge.", faces)
          : words("One product for two faces. Along {first} the edge runs as its arrow does, along "
                  "{second} the other way: there the sign changes.",
                  faces));
}

void addEdgeLines(const In &in, const Out &at, std::size_t index, Explanation &lines) {
  const std::string id = std::to_string(index);
  const EdgeTerms &edge = at.edges[index];
  const Term &from = at.corners[edge.from];
  lines.add("e" + id, [&edge, &in] {
    const Term way = wayTerm(in.K, edge.from, edge.to);
    return asked(withNumbers(edge.e == way), words("The edge, from one corner to the other."),
                 {{-way, words("{answer} points backwards.")}});
  });
  lines.add("m" + id,
            [&edge, &from] { return momentLine(edge.m, from, edge.e, words("The moment of its line.")); });
  lines.add("edge" + id, [&at, &edge] { return productLine(at, edge); });
  lines.add("shared" + id, [&at, &edge] { return sharedLine(at, edge); });
}

const EdgeTerms &edgeBetween(const Out &at, std::uint32_t from, std::uint32_t to) {
  return *std::find_if(at.edges.begin(), at.edges.end(), [&](const EdgeTerms &each) {
    return std::minmax({each.from, each.to}) == std::minmax({from, to});
  });
}

/// The products with a face's edges, as the face runs along them, in the order around it.
std::vector<Term> productsOf(const Out &at, std::size_t face) {
  const auto &corners = at.mesh.faces[face];
  std::vector<Term> products;
  products.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const EdgeTerms &edge = edgeBetween(at, corners[i], corners[(i + 1) % corners.size()]);
    products.push_back(edge.from == corners[i] ? edge.p : -edge.p);
  }
  return products;
}

std::string faceWords(const Out &at, std::size_t face, const std::vector<Term> &products) {
  const auto hasSign = [&](int wanted) {
    return std::any_of(products.begin(), products.end(),
                       [&](const Term &product) { return sign(*numberOf(product)) == wanted; });
  };
  const WordValues values{{"face", at.faceNames[face]}, {"r", plainText(at.r)}};
  if (!at.isConvex())
    return words("These are the products of {face}. They decide for a convex solid only.", values);
  if (at.meet.which == RaySolidCase::ZeroDirection)
    return words("All are 0, because {r} is the zero vector: there is no line.", values);
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
  const std::vector<Term> products = productsOf(at, face);
  std::vector<Chain> chains;
  chains.reserve(products.size());
  for (const Term &product : products)
    chains.push_back(withResult(product));
  return line(std::move(chains), faceWords(at, face, products));
}

WorkingLine productsLine(const Out &at) {
  std::vector<Chain> products;
  products.reserve(at.edges.size());
  for (const EdgeTerms &edge : at.edges)
    products.push_back(withResult(edge.p));
  return line(std::move(products), words("One product for each edge."));
}

/// The counts come from the faces, not from coordinates: no number of these lines could be traced to one.
void addCountLines(const Out &at, Explanation &lines) {
  lines.add("sides", [&at] {
    std::vector<Term> counts;
    counts.reserve(at.mesh.faces.size());
    for (const auto &face : at.mesh.faces)
      counts.emplace_back(static_cast<int>(face.size()));
    return line((at.k == sum(std::move(counts))) == Term(sidesOf(at.mesh)),
                words("The edges of each face, face by face."));
  });
  lines.add("count", [&at] {
    return line((at.N == at.k / 2) == Term(static_cast<int>(at.edges.size())),
                words("Each edge belongs to two faces, so it was counted twice."));
  });
}

std::string parameterWords(const Out &at, std::size_t index) {
  if (!isAhead(at.contacts[index]))
    return words("Negative: that is behind the start {Q}.", at.letters);
  if (at.meet.contacts != SolidContacts::Two)
    return words("Not negative: the ray itself gets there.");
  return index == 0 ? words("Not negative: the ray itself gets there, and goes in.")
                    : words("Not negative: the ray itself gets there, and comes out.");
}

/// The way from a corner to the next one around a face: along an edge, or against it.
Term sideTerm(const Out &at, std::uint32_t from, std::uint32_t to) {
  const EdgeTerms &edge = edgeBetween(at, from, to);
  return edge.from == from ? edge.e : -edge.e;
}

WorkingLine normalLine(const Out &at, const Contact &contact) {
  const auto &face = at.mesh.faces[contact.crossing.face];
  const Term first = sideTerm(at, face[0], face[1]);
  const Term second = sideTerm(at, face[1], face[2]);
  return asked(withProducts(contact.n == cross(first, second)),
               words("A normal of {face}, from two of its edges: it points outwards.",
                     {{"face", at.faceNames[contact.crossing.face]}}),
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

void addContactLines(const Out &at, std::size_t index, Explanation &lines) {
  const std::string id = std::to_string(index + 1);
  const Contact &contact = at.contacts[index];
  lines.add(index == 0 ? "in" : "out", [&at, &contact] { return faceLine(at, contact.crossing.face); });
  lines.add("normal" + id, [&at, &contact] { return normalLine(at, contact); });
  lines.add("t" + id, [&at, index] { return parameterLine(at, index); });
  lines.add("hit" + id, [&at, &contact] { return asked(withNumbers(contact.H == at.Q + contact.t * at.r)); });
}

Explanation explain(const In &in, const Out &at) {
  Explanation lines;
  lines.add("moment", [&at] { return momentLine(at.m, at.Q, at.r, words("The moment of the ray's line.")); });
  for (std::size_t i = 0; i < at.edges.size(); ++i)
    addEdgeLines(in, at, i, lines);
  lines.add("products", [&at] { return productsLine(at); });
  for (std::size_t face = 0; face < at.mesh.faces.size(); ++face)
    lines.add("face" + std::to_string(face), [&at, face] { return faceLine(at, face); });
  addCountLines(at, lines);
  for (std::size_t i = 0; i < at.contacts.size(); ++i)
    addContactLines(at, i, lines);
  return lines;
}

/// The part of an edge that its arrow covers: the head stands clear of the corner, near the middle.
constexpr double arrowPart = 0.6;

/// In the colour of its sign, with an arrow that says which way it runs.
void drawEdge(Figure &figure, const Out &at, const EdgeTerms &edge) {
  if (isZero(vectorOf(edge.e)))
    return;
  const Place from = place(at.corners[edge.from]);
  const Subject subject = edge.product > 0   ? Subject::EdgeU
                          : edge.product < 0 ? Subject::EdgeV
                                             : Subject::Measure;
  MarkBase base = drawn(edge.p, Role::Derived, subject);
  // The sign is what decides, and many edges leave no room for more.
  base.numbers = edge.product > 0 ? "\\,{+}" : edge.product < 0 ? "\\,{-}" : "= 0";
  const std::string arrow = base.id + "/way";
  figure.add(SegmentMark{std::move(base), from, place(at.corners[edge.to])});
  figure.add(ArrowMark{{arrow, Role::Derived, subject}, from, place(edge.e) * arrowPart});
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
  figure.add(pointOf(contact.H, isAhead(contact) ? Role::Result : Role::Ghost, Subject::Ray));
}

Figure draw(const In &in, const Out &at) {
  Figure figure;
  for (const EdgeTerms &edge : at.edges)
    drawEdge(figure, at, edge);
  for (std::size_t i = 0; i < at.contacts.size(); ++i)
    drawContact(figure, at, i);
  if (at.contacts.empty())
    return figure;
  if (isAhead(at.out()))
    figure.reaches.push_back({in.L.id, place(at.out().H)});
  if (!isAhead(at.in()))
    figure.add(SegmentMark{
        {at.in().H->mark + "/backward", Role::Ghost, Subject::Ray}, place(at.Q), place(at.in().H)});
  return figure;
}

std::string sentenceOfZeros(const std::vector<std::size_t> &edges) {
  std::string when;
  for (const std::size_t edge : edges)
    when += (when.empty() ? "" : " and ") + ("products." + std::to_string(edge)) + " = 0";
  return when;
}

/// The ray moved sideways until its line meets a corner or an edge; none of those that it meets already.
void addShifted(const In &in, const Out &at, std::vector<SpecialCase> &all) {
  const RayObject &ray = in.L.object;
  const auto add = [&](const ExactVec3 &shift, const std::vector<std::size_t> &zeros, std::string sentence) {
    if (!isZero(shift))
      all.push_back(
          {sentenceOfZeros(zeros), std::move(sentence), "L", RayObject{ray.origin + shift, ray.direction}});
  };
  for (std::size_t i = 0; i < at.mesh.vertices.size(); ++i) {
    std::vector<std::size_t> edges;
    for (std::size_t k = 0; k < at.edges.size(); ++k)
      if (at.edges[k].from == i || at.edges[k].to == i)
        edges.push_back(k);
    add(projectVector(ExactVec3(at.mesh.vertices[i] - ray.origin), ray.direction).rejection, edges,
        words("The ray's line would go through the corner {corner}.",
              {{"corner", plainText(withResult(at.corners[i]).last())}}));
  }
  for (std::size_t k = 0; k < at.edges.size(); ++k) {
    const EdgeTerms &edge = at.edges[k];
    if (const auto shift = shiftOntoSegment(ray, at.mesh.vertices[edge.from], at.mesh.vertices[edge.to]))
      add(*shift, {k},
          words("The ray's line would go through the edge of {product}.", {{"product", plainText(edge.p)}}));
  }
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  std::vector<SpecialCase> all;
  if (isZero(in.L.object.direction) || !at.isConvex())
    return all;
  addShifted(in, at, all);
  if (at.meet.origin != SolidLocation::On)
    for (const Contact &contact : at.contacts)
      all.push_back({"origin = on", words("{Q} would lie on the solid.", at.letters), "L",
                     RayObject{contact.crossing.point, in.L.object.direction}});
  return all;
}

/// The lines of the edges stand together edge by edge.
std::vector<std::string> lineNames() {
  std::vector<std::string> names{"moment"};
  for (std::size_t i = 0; i < mostEdges; ++i)
    for (const char *word : {"e", "m", "edge", "shared"})
      names.push_back(word + std::to_string(i));
  return joined({names,
                 {"products"},
                 numbered("face", mostFaces),
                 {"sides", "count", "in", "normal1", "t1", "hit1", "out", "normal2", "t2", "hit2"}});
}

ValueName contactName(const char *what) {
  return named::group(what, {named::vector("point"), named::index("face"),
                             named::word("location", {"interior", "edge", "vertex"})});
}

} // namespace

Construction ray_solid_pluecker() {
  return makeConstruction<In, Out, SolidObject, RayObject>(
      "ray-solid-pluecker", {"K", "L"}, {{"H1", "point"}, {"H2", "point"}},
      joined({{"m", "k", "N", "t1", "t2", "n1", "n2"},
              numbered("e", mostEdges),
              numbered("m", mostEdges),
              numbered("p", mostEdges)}),
      {.cases = {"hit", "behind", "miss", "zero-direction", "flat", "not-planar", "not-convex"},
       .values = {named::list("products", mostEdges), named::number("sides"), named::number("edges"),
                  named::word("origin", {"outside", "on", "inside"}),
                  named::word("contacts", {"two", "one", "along", "none"}), named::list("t", 2),
                  contactName("entered"), contactName("left")},
       .lines = lineNames(),
       .marks = joined({numbered("p", mostEdges), {"in", "n1", "H1", "out", "n2", "H2"}})},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
