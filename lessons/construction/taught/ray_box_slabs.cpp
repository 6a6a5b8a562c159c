// Where a ray meets a box along the axes: a box is what three slabs have in common, and the ray is in it
// while it is in all three.
#include "geometry/case_names.h"
#include "lessons/construction/parts/ray_marks.h"
#include "lessons/construction/parts/slabs.h"
#include "lessons/construction/parts/sorted_line.h"
#include "lessons/construction/parts/value_words.h"
#include "lessons/construction/taught.h"

#include <algorithm>

namespace halfspace {
namespace {

struct In : Naming {
  Given<BoxObject> K;
  Given<RayObject> L;
};

struct Out : Computed<In>, RayTerms {
  explicit Out(const In &objects) : Computed(objects), RayTerms(termsOf(objects.L)) {}

  Ray<Rational> ray{in.L.object.origin, in.L.object.direction};
  RayBox<Rational> meet = intersectRayBox(ray, in.K.object.lowest, in.K.object.highest());
  bool hasLine = meet.which != RaySolidCase::ZeroDirection;
  bool hasSpan = hasLine && !meet.isBeside(); ///< whether there are a last way in and a first way out
  bool isMet = hasSpan && meet.in <= meet.out;

  std::array<Slab, 3> slabs = slabsOf(in, in.K, in.L, meet);
  Term tIn = ownName(letter("t", "in"), meet.in);
  Term tOut = ownName(letter("t", "out"), meet.out);
  Term H1 = madeName("H1", pointAt(ray, meet.in));
  Term H2 = madeName("H2", pointAt(ray, meet.out));

  /// The ways in or out of all slabs that have them.
  [[nodiscard]] std::vector<Term> ways(Term Slab::*way) const {
    std::vector<Term> all;
    for (const Slab &slab : slabs)
      if (slab.isCrossed())
        all.push_back(slab.*way);
    return all;
  }
};

std::string hitWords(const Out &at) {
  const WordValues values{{"in", equation(at.tIn)},
                          {"out", equation(at.tOut)},
                          {"H1", plainText(at.H1)},
                          {"H2", plainText(at.H2)},
                          {"Q", plainText(at.Q)}};
  if (at.meet.in == at.meet.out)
    return words("{in} and {out}: the ray meets the box in only one point, {H1}.", values);
  if (at.meet.in >= 0)
    return words("The ray is in the box from {H1} on, with {in}, up to {H2}, with {out}.", values);
  return at.meet.out > 0
             ? words("{in} is negative: the ray starts in the box. It leaves the box at {H2}, with {out}.",
                     values)
             : words(
                   "{out}: the ray starts on the box and leads away from it. It has only its start in common "
                   "with the box.",
                   values);
}

CaseWords tell(const Out &at) {
  const std::string caseName(nameOf(at.meet.which));
  switch (at.meet.which) {
  case RaySolidCase::Hit:
    return {caseName, hitWords(at)};
  case RaySolidCase::Behind:
    return {caseName,
            words("{out} is negative: the box is behind the ray's start, so the ray does not meet it.",
                  {{"out", equation(at.tOut)}})};
  case RaySolidCase::ZeroDirection:
    return zeroDirectionWords(at);
  case RaySolidCase::Miss:
    break;
  }
  if (at.hasSpan)
    return {caseName,
            words("{in} is larger than {out}: the line leaves one slab before it comes into another, "
                  "so the ray misses the box.",
                  {{"in", equation(at.tIn)}, {"out", equation(at.tOut)}})};
  const auto beside = std::find_if(at.slabs.begin(), at.slabs.end(),
                                   [](const Slab &slab) { return slab.crossing.which == SlabCase::Beside; });
  return {caseName,
          words("{step} = 0: the ray runs beside the {axis} slab and never comes into it, so it misses "
                "the box.",
                {{"step", plainText(beside->step)}, {"axis", beside->axisName()}})};
}

WorkingLine orderLine(const Out &at) {
  std::vector<Term> all = at.ways(&Slab::in);
  for (Term &out : at.ways(&Slab::out))
    all.push_back(std::move(out));
  return sortedLine(std::move(all), at.isMet ? words("In their order. All ways in stand before all ways out.")
                                             : words("In their order. A way out stands before a way in."));
}

enum class Extreme : std::uint8_t { Largest, Smallest };

/// max(a, b) or min(a, b)
Term extremeOf(Extreme which, std::vector<Term> numbers) {
  const auto less = [](const Term &a, const Term &b) { return rationalOf(a) < rationalOf(b); };
  const Rational value =
      rationalOf(which == Extreme::Largest ? *std::max_element(numbers.begin(), numbers.end(), less)
                                           : *std::min_element(numbers.begin(), numbers.end(), less));
  return applied(word(which == Extreme::Largest ? "max" : "min"), list(std::move(numbers)), value);
}

WorkingLine extremeLine(const Term &t, Extreme which, const std::vector<Term> &numbers, std::string sentence,
                        WrongTerm mistake) {
  if (numbers.size() == 1)
    return asked(withNumbers(t == numbers.front()),
                 words("There is no other: the line is always in the other two slabs."));
  const Term names = extremeOf(which, numbers);
  std::vector<Term> values;
  values.reserve(numbers.size());
  for (const Term &number : numbers)
    values.push_back(calculated(number));
  return asked((t == names).then(extremeOf(which, std::move(values))).then(calculated(names)),
               std::move(sentence), {std::move(mistake)});
}

WorkingLine lastInLine(const Out &at) {
  const std::vector<Term> ways = at.ways(&Slab::in);
  return extremeLine(at.tIn, Extreme::Largest, ways,
                     words("The largest: only then has the line come into every slab."),
                     {extremeOf(Extreme::Smallest, ways),
                      words("{answer} is the smallest: then the line has not come into every slab yet.")});
}

WorkingLine firstOutLine(const Out &at) {
  const std::vector<Term> ways = at.ways(&Slab::out);
  return extremeLine(at.tOut, Extreme::Smallest, ways,
                     words("The smallest: there the line leaves a slab for the first time."),
                     {extremeOf(Extreme::Largest, ways),
                      words("{answer} is the largest: then the line has left another slab already.")});
}

WorkingLine compareLine(const Out &at) {
  return line(compared(at.tIn, at.tOut), !at.isMet ? words("The line misses the box.")
                                         : at.meet.in < at.meet.out
                                             ? words("From the one to the other the line is in the box.")
                                             : words("The line meets the box in only one point."));
}

WorkingLine aheadLine(const Out &at) {
  return line({compared(at.tIn, 0), compared(at.tOut, 0)},
              at.meet.out < 0  ? words("Both are negative: the box is behind the start.")
              : at.meet.in < 0 ? words("Only t_in is negative: the ray starts in the box.")
                               : words("Neither is negative: the ray meets the box."));
}

using Crossing = Rational SlabCrossing<Rational>::*;

/// The slabs that a way of the box comes from, and the only one; null where several have the same.
const Slab *onlySlab(const Out &at, Crossing way, const Rational &t) {
  const Slab *only = nullptr;
  for (const Slab &slab : at.slabs)
    if (slab.isCrossed() && slab.crossing.*way == t) {
      if (only)
        return nullptr;
      only = &slab;
    }
  return only;
}

struct Face {
  const Slab *slab; ///< null where there are several
  bool isHigh;
};

Face faceIn(const Out &at) {
  const Slab *slab = onlySlab(at, &SlabCrossing<Rational>::in, at.meet.in);
  return {slab, slab && !slab->isFlat() && !slab->isForwards()};
}

Face faceOut(const Out &at) {
  const Slab *slab = onlySlab(at, &SlabCrossing<Rational>::out, at.meet.out);
  return {slab, slab && !slab->isFlat() && slab->isForwards()};
}

WorkingLine pointLine(const Out &at, const Term &H, const Term &t, const Face &face) {
  return asked(
      withNumbers(H == at.Q + t * at.r),
      face.slab
          ? words("The {axis} slab gave {t}: the point is in the face {plane}.",
                  {{"axis", face.slab->axisName()},
                   {"t", plainText(t)},
                   {"plane", face.slab->nameOf(face.isHigh ? face.slab->high : face.slab->low)}})
          : words("Several slabs gave {t}: the point is on an edge or at a corner.", {{"t", plainText(t)}}));
}

LineTable<Out> lines() {
  LineTable<Out> all;
  for (std::size_t axis = 0; axis < axisNames.size(); ++axis) {
    const auto isCrossed = [axis](const Out &at) { return at.hasLine && at.slabs.at(axis).isCrossed(); };
    const std::string index = axisNames.at(axis);
    all.push_back({"in-" + index, isCrossed, [axis](const Out &at) { return wayInLine(at.slabs.at(axis)); }});
    all.push_back(
        {"out-" + index, isCrossed, [axis](const Out &at) { return wayOutLine(at.slabs.at(axis)); }});
    all.push_back(
        {"between-" + index, &Out::hasLine, [axis](const Out &at) { return startLine(at.slabs.at(axis)); }});
  }
  return joined<LineRow<Out>>(
      {all,
       {{"order", &Out::hasSpan, orderLine},
        {"t-in", &Out::hasSpan, lastInLine},
        {"t-out", &Out::hasSpan, firstOutLine},
        {"compare", &Out::hasSpan, compareLine},
        {"ahead", &Out::isMet, aheadLine},
        {"hit1", &Out::isMet, [](const Out &at) { return pointLine(at, at.H1, at.tIn, faceIn(at)); }},
        {"hit2", &Out::isMet, [](const Out &at) { return pointLine(at, at.H2, at.tOut, faceOut(at)); }}}});
}

Figure draw(const Out &at) {
  Figure figure;
  for (const Slab &slab : at.slabs)
    drawSlab(figure, at, slab, at.in.K, at.in.L);
  if (at.isMet)
    for (const auto &[point, t] : {std::pair(at.H1, at.meet.in), {at.H2, at.meet.out}})
      addMeeting(figure, at.in.L, point, t >= 0);
  return figure;
}

/// The ray moved sideways until its line touches the edge of the face where it goes in and of that where it
/// comes out.
void addTouching(const Out &at, std::vector<SpecialCase> &all) {
  const Slab *into = faceIn(at).slab;
  const Slab *outOf = faceOut(at).slab;
  if (!into || !outOf || into == outOf)
    return;
  auto [origin, direction] = at.in.L.object;
  const Rational stepIn = rationalOf(into->step);
  const Rational stepOut = rationalOf(outOf->step);
  const Rational inSquared = stepIn * stepIn;
  const Rational outSquared = stepOut * stepOut;
  const Rational touch = (at.meet.in * inSquared + at.meet.out * outSquared) / (inSquared + outSquared);
  origin[static_cast<int>(into->axis)] += (at.meet.in - touch) * stepIn;
  origin[static_cast<int>(outOf->axis)] += (at.meet.out - touch) * stepOut;
  const auto moved =
      intersectRayBox<Rational>({origin, direction}, at.in.K.object.lowest, at.in.K.object.highest());
  if (moved.in == moved.out) // else another slab is in the way
    all.push_back({is("contacts", "one"), words("The ray's line would touch an edge of the box."), "L",
                   RayObject{origin, direction}});
}

std::vector<SpecialCase> nearby(const Out &at) {
  std::vector<SpecialCase> all;
  if (!at.hasLine)
    return all;
  const auto &[origin, direction] = at.in.L.object;
  if (at.hasSpan && at.meet.in != at.meet.out)
    addTouching(at, all);
  if (at.isMet && at.meet.origin != SolidLocation::On)
    for (const Rational &t : {at.meet.in, at.meet.out})
      all.push_back({is("origin", "on"), words("{Q} would lie on the box.", at.letters), "L",
                     RayObject{pointAt(at.ray, t), direction}});
  for (const Slab &slab : at.slabs) {
    ExactVec3 along = direction;
    along[static_cast<int>(slab.axis)] = 0;
    if (slab.isCrossed() && !isZero(along))
      all.push_back(
          {is(slab.axisName() + ".way", slab.hasStart() ? "within" : "beside"),
           words("The ray would run parallel to the planes of the {axis} slab.", {{"axis", slab.axisName()}}),
           "L", RayObject{origin, along}});
  }
  return all;
}

ValueRow<Out> slabRow(std::size_t axis) {
  const auto its = [axis](const Out &at) -> const Slab & { return at.slabs.at(axis); };
  const auto isCrossed = [its](const Out &at) { return its(at).isCrossed(); };
  return valueGroup<Out>(axisNames.at(axis), &Out::hasLine,
                         {{named::word("way", {"crossed", "within", "beside"}), always,
                           [its](const Out &at) {
                             return ToldValue(words("the {axis} slab", {{"axis", its(at).axisName()}}),
                                              wordOf(its(at).crossing.which));
                           }},
                          {named::word("first", {"low", "high"}), isCrossed,
                           [its](const Out &at) {
                             const Slab &slab = its(at);
                             return ToldValue(
                                 words("first plane of the {axis} slab", {{"axis", slab.axisName()}}),
                                 Word{slab.isForwards() ? "low" : "high", slab.nameOf(slab.near())});
                           }},
                          {named::number("in"), isCrossed, [its](const Out &at) { return its(at).in; }},
                          {named::number("out"), isCrossed, [its](const Out &at) { return its(at).out; }}});
}

Word contactsWord(const Out &at) {
  if (!at.isMet)
    return noneOfThem();
  return at.meet.in == at.meet.out ? Word{"one", words("one")} : Word{"piece", words("a whole piece")};
}

Word faceWord(const Face &face) {
  if (!face.slab)
    return severalOfThem();
  return {face.slab->axisName() + (face.isHigh ? "-high" : "-low"),
          face.slab->nameOf(face.isHigh ? face.slab->high : face.slab->low)};
}

ValueTable<Out> values() {
  const std::vector<std::string> faces{"x-low", "x-high", "y-low", "y-high", "z-low", "z-high", "several"};
  return {{named::word("origin", {"outside", "on", "inside"}), always,
           [](const Out &at) { return ToldValue(words("place of the start"), wordOf(at.meet.origin)); }},
          slabRow(0),
          slabRow(1),
          slabRow(2),
          {named::word("contacts", {"none", "one", "piece"}), &Out::hasLine,
           [](const Out &at) {
             return ToldValue(words("common points of the line and the box"), contactsWord(at));
           }},
          {named::number("t_in"), &Out::hasSpan, &Out::tIn},
          {named::number("t_out"), &Out::hasSpan, &Out::tOut},
          {named::vector("entry"), &Out::isMet, &Out::H1},
          {named::vector("exit"), &Out::isMet, &Out::H2},
          {named::word("face_in", faces), &Out::isMet,
           [](const Out &at) { return ToldValue(words("face of the way in"), faceWord(faceIn(at))); }},
          {named::word("face_out", faces), &Out::isMet,
           [](const Out &at) { return ToldValue(words("face of the way out"), faceWord(faceOut(at))); }}};
}

} // namespace

Construction ray_box_slabs() {
  return taught<Out, BoxObject, RayObject>(
      {.id = "ray-box-slabs",
       .word = "intersect",
       .title = [] { return words("where the ray meets the box"); },
       .roles = {"K", "L"},
       .makes = {{"H1", &Out::isMet, &Out::H1}, {"H2", &Out::isMet, &Out::H2}},
       .letters = {"inx", "outx", "Ax", "Bx", "iny", "outy", "Ay", "By", "inz", "outz", "Az", "Bz", "tin",
                   "tout"},
       .cases = {"hit", "behind", "miss", "zero-direction"},
       .values = values(),
       .lines = lines(),
       .marks = {"slab-x", "in-x", "out-x", "slab-y", "in-y", "out-y", "slab-z", "in-z", "out-z", "H1", "H2"},
       .tell = tell,
       .draw = draw,
       .nearby = nearby});
}

} // namespace halfspace
