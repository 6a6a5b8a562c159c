// On which sides of a plane points lie: the signs of f tell (note PG 3.4).
#include "geometry/case_names.h"
#include "lessons/construction/parts/sided_points.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"

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

struct Out : Computed<In>, PlaneTerms {
  explicit Out(const In &objects) : Computed(objects), PlaneTerms(termsOf(objects.E)) {}

  bool hasPlane = !isZero(in.E.object.normal);
  std::array<SidedPoint, 4> points{sidedPoint(in, "A", in.E, in.A), sidedPoint(in, "B", in.E, in.B),
                                   sidedPoint(in, "C", in.E, in.C), sidedPoint(in, "D", in.E, in.D)};
};

std::vector<Term> pointsOn(const Out &at, PointPlaneCase side) {
  std::vector<Term> found;
  for (const SidedPoint &each : at.points)
    if (each.measured.which == side)
      found.push_back(each.point);
  return found;
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

WorkingLine sidesLine(const Out &at) {
  std::vector<Chain> signs;
  for (const SidedPoint &each : at.points)
    signs.push_back(compared(each.f, 0));
  return line(std::move(signs), sidesWords(at));
}

std::string flippedWords(const Out &at, const SidedPoint &point) {
  const std::string named = plainText(point.point);
  return point.measured.which == PointPlaneCase::On
             ? words("With −{n} for {n} the number is −f({point}): that is 0 again.", at.letters,
                     {{"point", named}})
             : words("With −{n} for {n} the number is −f({point}): it only changes its sign.", at.letters,
                     {{"point", named}});
}

WorkingLine flippedLine(const Out &at) {
  const SidedPoint &first = at.points.front();
  return asked(withNumbers(dot(-at.n, first.point - at.P0)), flippedWords(at, first),
               {{first.f, words("{answer} is f({point}): with −{n} every product changes its sign.",
                                at.letters, {{"point", plainText(first.point)}})}});
}

/// Signs and shapes tell the sides apart as colours do.
std::string signOf(PointPlaneCase side) {
  return side == PointPlaneCase::Positive ? "+" : side == PointPlaneCase::Negative ? "-" : "0";
}

Figure draw(const Out &at) {
  Figure figure;
  for (const SidedPoint &each : at.points)
    drawSide(figure, at.in.E, each, signOf(each.measured.which));
  return figure;
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.hasPlane)
    return all;
  for (const SidedPoint &each : at.points)
    addIntoPlane(at.in.E.object, each, is("side_" + each.role, "on"), all);
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
    table.push_back({"f-" + std::string(roles.at(i)), always,
                     [i](const Out &at) { return valueLine(at, at, at.points.at(i)); }});
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
            const SidedPoint &each = at.points.at(index);
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
       .title = [] { return words("sides of the plane"); },
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
