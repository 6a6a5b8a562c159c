// On which sides of a plane points lie: the signs of f tell (note PG 3.4).
#include "geometry/case_names.h"
#include "geometry/point_plane.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"
#include "lessons/object/kinds/plane.h"

#include <glm/geometric.hpp>

#include <array>

namespace halfspace {
namespace {

struct In : Naming {
  Given<PlaneObject> E;
  Given<PointObject> A;
  Given<PointObject> B;
  Given<PointObject> C;
  Given<PointObject> D;
};

/// A point and what the plane says of it.
struct Sided {
  std::string role;
  Term point;
  Term f;
  PointPlane<Rational> measured;
};

Sided sidedOf(const In &in, const std::string &role, const Given<PointObject> &given) {
  const auto &[through, normal] = in.E.object;
  const auto measured = measurePointPlane(given.object.at, planeThrough(through, normal));
  const Term point = termOf(given);
  return {role, point, applied(in.own(letter("f")), point, measured.f).marked(in.mark("side-" + role)),
          measured};
}

struct Out : Computed<In>, PlaneTerms {
  explicit Out(const In &objects) : Computed(objects), PlaneTerms(termsOf(objects.E)) {}

  bool hasPlane = !isZero(in.E.object.normal);
  std::array<Sided, 4> points{sidedOf(in, "A", in.A), sidedOf(in, "B", in.B), sidedOf(in, "C", in.C),
                              sidedOf(in, "D", in.D)};
};

std::vector<const Sided *> pointsOn(const Out &at, PointPlaneCase side) {
  std::vector<const Sided *> found;
  for (const Sided &point : at.points)
    if (point.measured.which == side)
      found.push_back(&point);
  return found;
}

/// A, C
std::string namesOf(const std::vector<const Sided *> &points) {
  std::string names;
  for (const Sided *each : points)
    names += (names.empty() ? "" : ", ") + plainText(each->point);
  return names;
}

/// Which points lie where, a sentence for each place that has some.
std::string sidesWords(const Out &at) {
  std::vector<std::string> sentences;
  const auto add = [&](PointPlaneCase side, const auto &sentence) {
    if (const auto points = pointsOn(at, side); !points.empty())
      sentences.push_back(sentence(namesOf(points)));
  };
  add(PointPlaneCase::Positive, [&](const std::string &names) {
    return words("On the side that {n} points to: {points}.", at.letters, {{"points", names}});
  });
  const bool isFirst = sentences.empty();
  add(PointPlaneCase::Negative, [&](const std::string &names) {
    return isFirst
               ? words("On the side that {n} points away from: {points}.", at.letters, {{"points", names}})
               : words("On the other side: {points}.", {{"points", names}});
  });
  add(PointPlaneCase::On, [](const std::string &names) {
    return words("In the plane, on neither side: {points}.", {{"points", names}});
  });
  std::string all;
  for (const std::string &sentence : sentences)
    all += (all.empty() ? "" : " ") + sentence;
  return all;
}

CaseWords tell(const Out &at) {
  if (!at.hasPlane)
    return zeroNormalWords(at);
  const bool isSplit =
      !pointsOn(at, PointPlaneCase::Positive).empty() && !pointsOn(at, PointPlaneCase::Negative).empty();
  return {isSplit ? "split" : "one-side", sidesWords(at)};
}

WorkingLine valueLine(const Out &at, std::size_t index) {
  const auto &[role, point, f, measured] = at.points.at(index);
  return asked(
      withNumbers(f == dot(at.n, point - at.P0)), {},
      {{dot(at.n, point), words("{answer} is {n}·{point}: {P0} is to be subtracted from {point} first.",
                                at.letters, {{"point", plainText(point)}})}});
}

WorkingLine sidesLine(const Out &at) {
  std::vector<Chain> signs;
  for (const Sided &each : at.points)
    signs.push_back(compared(each.f, 0));
  return line(std::move(signs), sidesWords(at));
}

std::string flippedWords(const Out &at, const Sided &point) {
  const std::string named = plainText(point.point);
  return point.measured.which == PointPlaneCase::On
             ? words("With −{n} for {n} the number is −f({point}): that is 0 again.", at.letters,
                     {{"point", named}})
             : words("With −{n} for {n} the number is −f({point}): it only changes its sign.", at.letters,
                     {{"point", named}});
}

WorkingLine flippedLine(const Out &at) {
  const Sided &first = at.points.front();
  return asked(withNumbers(dot(-at.n, first.point - at.P0)), flippedWords(at, first),
               {{first.f, words("{answer} is f({point}): with −{n} every product changes its sign.",
                                at.letters, {{"point", plainText(first.point)}})}});
}

/// A ring that lies in the plane around a point of it: three thirds of a circle.
void drawRing(Figure &figure, const MarkBase &base, const Place &center, const ExactVec3 &normal) {
  const Place axis = unitOf(normal);
  const Place across =
      glm::normalize(glm::cross(axis, std::abs(axis.z) < 0.9 ? Place(0, 0, 1) : Place(1, 0, 0)));
  const Place along = glm::cross(axis, across);
  const double half = std::sqrt(0.75);
  const std::array thirds{across, -0.5 * across + half * along, -0.5 * across - half * along};
  for (std::size_t i = 0; i < thirds.size(); ++i) {
    MarkBase third = base;
    if (i > 0) {
      third.id += "/" + std::to_string(i);
      third.numbers.clear();
    }
    figure.add(ArcMark{std::move(third), center, thirds.at(i), thirds.at((i + 1) % thirds.size())});
  }
}

/// What is drawn of a point's side. Its sign is a number as the values are: a learner may be asked for it.
MarkBase sideOf(const Sided &each, Role role, Subject subject, std::string sign) {
  MarkBase base{each.f->mark, role, subject};
  base.numbers = std::move(sign);
  return base;
}

/// Signs and shapes tell the sides apart as colours do: a whole pin and +, a dashed one and −, a ring and 0.
void drawSide(Figure &figure, const In &in, const Sided &each) {
  const Place point = place(each.point);
  const Place foot = place(each.measured.foot);
  switch (each.measured.which) {
  case PointPlaneCase::Positive:
    figure.add(inLook(in.E.look, SegmentMark{sideOf(each, Role::Derived, Subject::Plane, "+"), foot, point}));
    break;
  case PointPlaneCase::Negative:
    figure.add(SegmentMark{sideOf(each, Role::Helper, Subject::EdgeV, "-"), foot, point});
    break;
  case PointPlaneCase::On:
    drawRing(figure, sideOf(each, Role::Derived, Subject::Neutral, "0"), point, in.E.object.normal);
    break;
  case PointPlaneCase::ZeroNormal:
    return;
  }
  figure.reaches.push_back({in.E.id, foot});
}

Figure draw(const Out &at) {
  Figure figure;
  for (const Sided &each : at.points)
    drawSide(figure, at.in, each);
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.hasPlane)
    return all;
  const auto &[through, normal] = at.in.E.object;
  for (const Sided &each : at.points) {
    if (each.measured.which == PointPlaneCase::On)
      continue;
    const Conditions when = is("side_" + each.role, "on");
    const WordValues letters{{"point", plainText(each.point)}};
    const ExactVec3 point = vectorOf(each.point);
    all.push_back({when, words("{point} would lie in the plane.", letters), each.role,
                   PointObject{each.measured.foot}});
    all.push_back({when, words("The plane would go through {point}.", letters), "E",
                   PlaneObject{through + point - each.measured.foot, normal}});
  }
  return all;
}

constexpr std::array roles{"A", "B", "C", "D"};

/// Of the four points: f_A, f_B …
std::vector<std::string> forEachPoint(const std::string &before) {
  std::vector<std::string> names;
  names.reserve(roles.size());
  for (const char *role : roles)
    names.push_back(before + role);
  return names;
}

LineTable<Out> lines() {
  LineTable<Out> table;
  for (std::size_t i = 0; i < roles.size(); ++i)
    table.push_back(
        {"f-" + std::string(roles.at(i)), always, [i](const Out &at) { return valueLine(at, i); }});
  table.push_back({"sides", &Out::hasPlane, sidesLine});
  table.push_back({"flipped", &Out::hasPlane, flippedLine});
  return table;
}

ValueRow<Out> valueRow(std::size_t index) {
  return {named::number("f_" + std::string(roles.at(index))), always,
          [index](const Out &at) { return at.points.at(index).f; }};
}

ValueRow<Out> sideRow(std::size_t index) {
  return {named::word("side_" + std::string(roles.at(index)), {"positive", "negative", "on"}), &Out::hasPlane,
          [index](const Out &at) {
            const Sided &each = at.points.at(index);
            return ToldValue(words("side of {point}", {{"point", plainText(each.point)}}),
                             wordOf(each.measured.which));
          }};
}

ValueRow<Out> countRow(PointPlaneCase side, Sentence label) {
  return {named::number(std::string(nameOf(side))), &Out::hasPlane, [=](const Out &at) {
            return ToldValue(words(label.english), Surd(static_cast<int>(pointsOn(at, side).size())));
          }};
}

} // namespace

Construction half_spaces() {
  return taught<Out, PlaneObject, PointObject, PointObject, PointObject, PointObject>(
      {.id = "half-spaces",
       .roles = {"E", "A", "B", "C", "D"},
       .letters = {"f"},
       .cases = {"split", "one-side", "zero-normal"},
       .values = {valueRow(0), valueRow(1), valueRow(2), valueRow(3), sideRow(0), sideRow(1), sideRow(2),
                  sideRow(3), countRow(PointPlaneCase::Positive, says("points on the positive side")),
                  countRow(PointPlaneCase::Negative, says("points on the negative side")),
                  countRow(PointPlaneCase::On, says("points in the plane"))},
       .lines = lines(),
       .marks = forEachPoint("side-"),
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
