// Where a ray meets a plane, as a picture (note RP 23 to 28): what D, v_d and v_0 measure along the normal,
// and the similar triangles from which t follows. The note's R_0 is Q here, its R_d is r, its r_i is H; its
// normal is one unit long, and here of any length.
#include "geometry/case_names.h"
#include "geometry/intersect_ray_plane.h"
#include "geometry/project_vector.h"
#include "lessons/construction/construction.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/object/drawing.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/letters.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

#include <utility>

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> G;
  Given<RayObject> L;
};

struct Out : Naming, PlaneTerms, RayTerms {
  RayPlane<Rational> meet;
  ExactVec3 across; ///< the part of r that lies in the plane's direction
  Term D, vd, v0, t, H;
  Term O, A, B; ///< the origin, and the feet of Q and of the plane on the line through it along n
  Term C, E, F; ///< the foot of Q in the plane, that of F on QC, and the tip of r
  Term facing;  ///< the unit normal towards where the ray comes from, where it crosses the plane

  [[nodiscard]] bool hasPlane() const { return meet.which != RayPlaneCase::ZeroNormal; }
};

/// Of the letter of a point of the figure.
Term pointName(const In &in, const char *point, const ExactVec3 &at) {
  return name(in.own(letter(point)), at).marked(in.mark(point));
}

std::vector<Surd> facingOf(const PlaneObject &plane, const RayObject &ray, const RayPlane<Rational> &meet) {
  if (!meet.crosses())
    return {};
  const auto facing = facingNormal(plane.normal, ray.direction);
  return {facing.begin(), facing.end()};
}

Out compute(const In &in) {
  const auto &[point, normal] = in.G.object;
  const auto &[origin, direction] = in.L.object;
  const auto meet = intersectRayPlane(Ray<Rational>{origin, direction}, planeThrough(point, normal));
  const ExactVec3 toPlane = projectVector(point, normal).projection;
  const ExactVec3 toStart = projectVector(origin, normal).projection;
  const auto parts = projectVector(direction, normal);
  return {in,
          termsOf(in.G),
          termsOf(in.L),
          meet,
          parts.rejection,
          name(in.own(letter("D")), dot(point, normal)).marked(in.mark("OB")),
          name(in.own(letter("v", "d")), meet.denominator).marked(in.mark("QE")),
          name(in.own(letter("v", "0")), meet.numerator).marked(in.mark("QC")),
          name(in.own(letter("t")), meet.t),
          madeName(in, "H", meet.point),
          pointName(in, "O", ExactVec3(0)),
          pointName(in, "A", toStart),
          pointName(in, "B", toPlane),
          pointName(in, "C", origin + toPlane - toStart),
          pointName(in, "E", origin + parts.projection),
          pointName(in, "F", origin + direction),
          name(in.own(vectorLetter("n", "f")), facingOf(in.G.object, in.L.object, meet))
              .marked(in.mark("facing"))};
}

CaseWords tell(const In &, const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  const std::string t = equation(at.t);
  const std::string v0 = equation(at.v0);
  switch (at.meet.which) {
  case RayPlaneCase::Hit:
    if (at.meet.t == 0)
      return {caseName, words("{v0}: {Q} lies in the plane, and the ray hits it at its own start.",
                              {{"v0", v0}, {"Q", plainText(at.Q)}})};
    return {caseName, words("{t} is positive: the ray hits the plane after so many steps {r}.",
                            {{"t", t}, {"r", plainText(at.r)}})};
  case RayPlaneCase::Behind:
    return {caseName, words("{t} is negative: the plane is behind the ray's start.", {{"t", t}})};
  case RayPlaneCase::Parallel:
    return {caseName,
            words("{r} has no part along {n}: the ray runs parallel to the plane and never meets it.",
                  at.letters)};
  case RayPlaneCase::InPlane:
    return {caseName, words("{r} has no part along {n}, and {Q} is in the plane: the whole ray lies in it, "
                            "and no single point is the hit.",
                            at.letters)};
  case RayPlaneCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RayPlaneCase::ZeroNormal:
    break;
  }
  return zeroNormalWords(at);
}

/// Of a fraction: −1, 0, 1.
int signOf(const Term &term) { return sign(*numberOf(term)).value(); }

/// Which way the plane lies, seen from the origin.
const char *wayOf(const Out &at) {
  const int sign = signOf(at.D);
  return sign > 0 ? "with-n" : sign < 0 ? "against-n" : "none";
}

/// What becomes of n in the facing normal.
const char *turnOf(const Out &at) {
  if (!at.meet.crosses())
    return "none";
  return at.meet.denominator > 0 ? "turned" : "kept";
}

std::vector<NamedValue> valuesOf(const In &in, const Out &at) {
  std::vector<NamedValue> values{
      listed("D", at.D),
      listed("numerator", at.v0),
      listed("denominator", at.vd),
      {"length_n", norm(at.n), Surd::root(dot(in.G.object.normal, in.G.object.normal))},
      {"origin_way", words("from the origin to the plane"), wayOf(at)},
      {"normal", words("the facing normal"), turnOf(at)}};
  if (!at.meet.crosses())
    return values;
  values.push_back(listed("t", at.t));
  values.push_back(listed("point", at.H));
  values.push_back(listed("facing_normal", at.facing));
  return values;
}

std::vector<MadeObject> make(const In &, const Out &at) {
  if (!at.meet.crosses())
    return {};
  return {{"H", PointObject{at.meet.point}}};
}

/// What belongs to n as a whole: how far a product with it reaches, as a vector.
Term alongNormal(const Out &at, const Term &product) { return product / dot(at.n, at.n) * at.n; }

WorkingLine originLine(const Out &at) {
  const int sign = signOf(at.D);
  const std::string way =
      sign > 0 ? words("Positive: the plane lies on that side of the origin to which {n} points.", at.letters)
      : sign < 0      ? words("Negative: from the origin to the plane you go against {n}.", at.letters)
      : at.hasPlane() ? words("Zero: the plane passes through the origin.")
                      : words("Zero, because {n} is the zero vector: there is no plane.", at.letters);
  return asked(withProducts(at.D == dot(at.P0, at.n)), way);
}

void addOriginLines(const Out &at, Explanation &lines) {
  lines.add("D", [&at] { return originLine(at); });
  if (!at.hasPlane())
    return;
  lines.add("B", [&at] {
    return asked(
        withNumbers(at.B == alongNormal(at, at.D)),
        words("The point of the plane that is nearest to the origin. When |{n}| = 1, the denominator is "
              "1, and it is D·{n}.",
              at.letters));
  });
}

std::string stepWords(const Out &at) {
  const int sign = at.meet.denominator.sign();
  return sign > 0        ? words("Positive: each step {r} goes as {n} points.", at.letters)
         : sign < 0      ? words("Negative: each step {r} goes against {n}.", at.letters)
         : at.hasPlane() ? words("Zero: no step gains anything along {n}.", at.letters)
                         : words("Zero, because {n} is the zero vector: there is no plane.", at.letters);
}

void addStepLines(const Out &at, Explanation &lines) {
  lines.add("vd", [&at] { return asked(withProducts(at.vd == dot(at.n, at.r)), stepWords(at)); });
  if (!at.hasPlane())
    return;
  lines.add("F", [&at] {
    return asked(withNumbers(at.F == at.Q + at.r), words("One step from {Q}.", at.letters));
  });
  lines.add("E", [&at] {
    return asked(withNumbers(at.E == at.Q + alongNormal(at, at.vd)),
                 words("What the step gains along {n}: the foot of its tip.", at.letters));
  });
}

void addStartLines(const Out &at, Explanation &lines) {
  if (at.hasPlane())
    lines.add("A", [&at] {
      return asked(withNumbers(at.A == alongNormal(at, dot(at.n, at.Q))),
                   words("The foot of {Q} on the line through the origin.", at.letters));
    });
  lines.add("v0", [&at] {
    return asked(
        withNumbers(at.v0 == at.D - dot(at.n, at.Q)),
        at.hasPlane() ? words("From where {Q} is, along {n}, to where the plane is.", at.letters)
                      : words("Zero, because {n} is the zero vector: there is no plane.", at.letters),
        {{-at.v0, words("{answer} is {n}·{Q} − D, from the plane to {Q}: turn it round.", at.letters)}});
  });
  if (at.hasPlane())
    lines.add("C", [&at] {
      return asked(withNumbers(at.C == at.Q + alongNormal(at, at.v0)),
                   words("The foot of {Q} in the plane.", at.letters));
    });
}

/// Q, A, B and C: flat where Q is on the line from the origin along n, or in the plane.
bool areCornersOfRectangle(const Out &at) {
  return vectorOf(at.Q) != vectorOf(at.A) && vectorOf(at.Q) != vectorOf(at.C);
}

/// The opposite sides of the rectangle, as vectors.
WorkingLine rectangleLine(const Out &at) {
  return line(withNumbers(at.C - at.Q == at.B - at.A),
              areCornersOfRectangle(at)
                  ? words("Opposite sides of a rectangle: the same arrow.")
                  : words("The same arrow, though the four points are no corners of a rectangle here."));
}

/// Of triangles only where there are two: they are flat for a ray along n, and the large one is a point where
/// the ray starts in the plane.
std::string similarWords(const Out &at) {
  if (isZero(at.across))
    return words("Along {n}: t times what a step gains. There are no triangles here, because the ray runs "
                 "along {n}.",
                 at.letters);
  return at.meet.t == 0
             ? words(
                   "Along {n}: t is 0, because {Q} is in the plane already, and there is only one triangle.",
                   at.letters)
             : words("Along {n}: t times the side of the small triangle is that of the large one.",
                     at.letters);
}

void addMeetingLines(const Out &at, Explanation &lines) {
  lines.add("t", [&at] {
    return asked(withNumbers(at.t == at.v0 / at.vd),
                 words("So many steps {r} lead from {Q} to the plane.", at.letters));
  });
  lines.add("similar-n",
            [&at] { return line(withNumbers(at.C - at.Q == at.t * (at.E - at.Q)), similarWords(at)); });
  lines.add("similar-r", [&at] {
    return line(withNumbers(at.H - at.Q == at.t * (at.F - at.Q)),
                words("Along the ray: just as many times."));
  });
  lines.add("hit", [&at] {
    return asked(withNumbers(at.H == at.Q + at.t * at.r),
                 at.meet.which == RayPlaneCase::Hit
                     ? words("The point where the ray meets the plane.")
                     : words("Only the line backwards meets the plane there."));
  });
}

/// A length of the figure by what was worked out along n.
WorkingLine lengthLine(const Out &at, const Term &side, const Term &product, std::string sentence) {
  return asked(withNumbers(norm(side) == norm(product) / norm(at.n)), std::move(sentence));
}

void addLengthLines(const Out &at, Explanation &lines) {
  lines.add("OB",
            [&at] { return lengthLine(at, at.B, at.D, words("How far the plane is from the origin.")); });
  lines.add("QE", [&at] {
    return lengthLine(at, at.E - at.Q, at.vd, words("How far one step leads along {n}.", at.letters));
  });
  lines.add("QC", [&at] {
    return lengthLine(at, at.C - at.Q, at.v0, words("How far {Q} is from the plane.", at.letters));
  });
}

WorkingLine facingLine(const Out &at) {
  const Term unit = at.n / norm(at.n);
  const bool turns = at.meet.denominator > 0;
  return asked(withResult(at.facing == (turns ? -unit : unit)),
               turns
                   ? words("v_d is positive: the ray goes the way that {n} points, so take −{n}.", at.letters)
                   : words("v_d is negative: the ray comes from where {n} points, so take {n}.", at.letters));
}

Explanation explain(const In &, const Out &at) {
  Explanation lines;
  addOriginLines(at, lines);
  addStepLines(at, lines);
  addStartLines(at, lines);
  if (at.hasPlane())
    lines.add("rectangle", [&at] { return rectangleLine(at); });
  if (at.meet.crosses())
    addMeetingLines(at, lines);
  if (at.hasPlane())
    addLengthLines(at, lines);
  if (at.meet.crosses())
    lines.add("facing", [&at] { return facingLine(at); });
  return lines;
}

/// Draws the figure of the note, in which a way along the normal makes right angles with the plane.
class Drawing {
public:
  Drawing(Figure &figure, const Out &at) : m_figure(figure), m_at(at), m_across(place(at.across)) {}

  /// A point with the way to it from another, and the right angle that the way makes at the point with a
  /// direction.
  void addFoot(const Term &foot, const Term &from, Subject subject, const Place &square) {
    const Place end = place(foot);
    const Place way = place(from) - end;
    m_figure.add(pointOf(foot, Role::Derived, subject));
    if (way == Place(0))
      return;
    m_figure.add(SegmentMark{{foot->mark + "/way", Role::Helper, subject}, place(from), end});
    if (square != Place(0))
      m_figure.add(RightAngleMark{{foot->mark + "/angle", Role::Helper, subject}, end, way, square});
  }

  /// What a product with n measures, if it is not 0.
  void addPart(const std::string &mark, Role role, Subject subject, const Term &from, const Term &to) {
    if (vectorOf(from) != vectorOf(to))
      m_figure.add(SegmentMark{{m_at.mark(mark), role, subject}, place(from), place(to)});
  }

  /// The triangle of Q and two points; none where it is flat.
  void addTriangle(const std::string &mark, Subject subject, const Term &foot, const Term &tip) {
    const ExactVec3 along = vectorOf(foot) - vectorOf(m_at.Q);
    if (!isZero(cross(along, ExactVec3(vectorOf(tip) - vectorOf(m_at.Q)))))
      m_figure.add(
          PolygonMark{{m_at.mark(mark), Role::Derived, subject}, {place(m_at.Q), place(foot), place(tip)}});
  }

  /// Along the plane, where the flat picture has it.
  [[nodiscard]] const Place &across() const { return m_across; }

private:
  Figure &m_figure;
  const Out &m_at;
  Place m_across;
};

void drawDistances(Figure &figure, const Out &at) {
  Drawing drawing(figure, at);
  const Place n = place(at.n);
  figure.add(pointOf(at.O, Role::Derived, Subject::Neutral));
  figure.add(pointOf(at.B, Role::Derived, Subject::Plane));
  drawing.addPart("OB", Role::Helper, Subject::Plane, at.O, at.B);
  if (vectorOf(at.O) != vectorOf(at.B) && drawing.across() != Place(0))
    figure.add(RightAngleMark{{at.B->mark + "/angle", Role::Helper, Subject::Plane},
                              place(at.B),
                              place(at.O) - place(at.B),
                              drawing.across()});
  drawing.addFoot(at.A, at.Q, Subject::Neutral, n);
  figure.add(pointOf(at.F, Role::Derived, Subject::Ray));
  drawing.addFoot(at.E, at.F, Subject::EdgeU, n);
  figure.add(pointOf(at.C, Role::Derived, Subject::EdgeV));
  drawing.addPart("AB", Role::Derived, Subject::EdgeV, at.A, at.B);
  drawing.addPart("QC", Role::Helper, Subject::EdgeV, at.Q, at.C);
  drawing.addPart("QE", Role::Derived, Subject::EdgeU, at.Q, at.E);
  if (at.meet.numerator != 0 && drawing.across() != Place(0))
    figure.add(RightAngleMark{{at.C->mark + "/angle", Role::Helper, Subject::EdgeV},
                              place(at.C),
                              place(at.Q) - place(at.C),
                              drawing.across()});
  if (!at.meet.crosses())
    return;
  drawing.addTriangle("large", Subject::EdgeV, at.C, at.H);
  drawing.addTriangle("small", Subject::EdgeU, at.E, at.F);
}

/// The facing normal is drawn so long in every picture.
constexpr double drawnNormalLength = 2;

Figure draw(const In &in, const Out &at) {
  Figure figure;
  if (!at.hasPlane())
    return figure;
  drawDistances(figure, at);
  figure.reaches = {{in.G.id, place(at.B)}, {in.G.id, place(at.C)}};
  if (at.meet.which == RayPlaneCase::InPlane)
    figure.reachWithin(in.G.id, in.L.id, place(at.Q), unitOf(in.L.object.direction));
  if (!at.meet.crosses())
    return figure;
  const bool hit = at.meet.which == RayPlaneCase::Hit;
  const Place meeting = place(at.H);
  figure.reaches.push_back({in.G.id, meeting});
  if (hit)
    figure.reaches.push_back({in.L.id, meeting});
  else
    figure.add(SegmentMark{{at.H->mark + "/backward", Role::Ghost, Subject::Ray}, place(at.Q), meeting});
  figure.add(pointOf(at.H, hit ? Role::Result : Role::Ghost, Subject::Ray));
  figure.add(ArrowMark{drawn(at.facing, Role::Derived, Subject::Measure), meeting, place(at.facing), false,
                       drawnNormalLength});
  return figure;
}

std::vector<SpecialCase> nearby(const In &in, const Out &at) {
  std::vector<SpecialCase> all;
  const auto &[point, normal] = in.G.object;
  const auto &[origin, direction] = in.L.object;
  if (isZero(normal) || isZero(direction))
    return all;
  const bool crosses = at.meet.crosses();
  const bool startsInPlane = at.meet.numerator == 0;
  if (!startsInPlane)
    all.push_back(
        {crosses ? "t = 0" : "case = in-plane",
         crosses ? words("{Q} would lie in the plane, and both triangles would start there.", at.letters)
                 : words("The ray would lie in the plane."),
         "L", RayObject{vectorOf(at.C), direction}});
  if (crosses && !isZero(at.across))
    all.push_back({startsInPlane ? "case = in-plane" : "case = parallel",
                   startsInPlane ? words("The ray would lie in the plane.")
                                 : words("The ray would run parallel to the plane."),
                   "L", RayObject{origin, at.across}});
  if (const ExactVec3 toPlane = vectorOf(at.B); !isZero(toPlane))
    all.push_back({"D = 0", words("The plane would pass through the origin."), "G",
                   PlaneObject{point - toPlane, normal}});
  return all;
}

} // namespace

Construction ray_plane_picture() {
  return makeConstruction<In, Out, PlaneObject, RayObject>(
      "ray-plane-picture", {"G", "L"}, {{"H", "point"}},
      {"D", "vd", "v0", "t", "O", "A", "B", "C", "E", "F", "nf"},
      {.cases = {"hit", "behind", "parallel", "in-plane", "zero-direction", "zero-normal"},
       .values = {named::number("D"), named::number("numerator"), named::number("denominator"),
                  named::number("length_n"), named::word("origin_way", {"with-n", "against-n", "none"}),
                  named::word("normal", {"kept", "turned", "none"}), named::number("t"),
                  named::vector("point"), named::vector("facing_normal")},
       .lines = {"D", "B", "vd", "F", "E", "v0", "A", "C", "rectangle", "t", "similar-n", "similar-r", "hit",
                 "OB", "QE", "QC", "facing"},
       .marks = {"O", "A", "B", "C", "E", "F", "H", "OB", "AB", "QC", "QE", "large", "small", "facing"}},
      {compute, tell, valuesOf, make, explain, draw, nearby});
}

} // namespace halfspace
