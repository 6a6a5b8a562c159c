#include "lessons/lesson/task_targets.h"

#include "lessons/lesson/condition.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>
#include <utility>

namespace halfspace {
namespace {

/// A number that a condition asks for: what the value comes to beyond it, as a fraction. Zero where the
/// condition holds.
struct Lack {
  Rational amount;
  Rational radicand; ///< what is lacking is `amount` times the root of this
};

/// The scene as it is with a handle at other places.
class Tried {
public:
  Tried(const Scene &scene, const Handle &handle)
      : m_scene(scene), m_handle(handle), m_object(*findObject(scene, handle.object)),
        m_start(evaluate(scene)) {}

  [[nodiscard]] Evaluation at(const ExactVec3 &place) const {
    Scene moved = m_scene;
    setObject(moved, m_handle.object, movedTo(m_object, m_handle, place));
    return evaluate(moved, m_start);
  }
  /// The same at one of the few places that tell how numbers change: all conditions ask at these.
  [[nodiscard]] Evaluation atProbe(const ExactVec3 &place) const {
    const auto known = std::find_if(m_probes.begin(), m_probes.end(),
                                    [&](const auto &probe) { return probe.first == place; });
    return known == m_probes.end() ? m_probes.emplace_back(place, at(place)).second : known->second;
  }

  [[nodiscard]] const Evaluation &atStart() const { return m_start; }

private:
  Scene m_scene;
  Handle m_handle;
  Object m_object;
  Evaluation m_start;
  mutable std::vector<std::pair<ExactVec3, Evaluation>> m_probes;
};

bool asksForANumber(const Condition &condition) {
  return condition.relation == Condition::Relation::Equal && parseRational(condition.against);
}

/// Nothing where the value is no number, or has a fraction beside its root.
std::optional<Lack> lackOf(const Condition &condition, const Evaluation &evaluation) {
  const auto value = findValue(evaluation, condition.value);
  const auto *number = value ? std::get_if<Surd>(&*value) : nullptr;
  if (!number)
    return {};
  const Surd lack = *number + Rational(-*parseRational(condition.against));
  if (lack.isRational())
    return Lack{lack.rationalPart(), 1};
  return lack.rationalPart() == 0 ? std::optional(Lack{lack.rootFactor(), lack.radicand()}) : std::nullopt;
}

/// A number that changes in proportion to the way of the handle.
struct Proportional {
  Rational atStart;
  ExactVec3 change; ///< by each unit along the axes

  [[nodiscard]] Rational after(const ExactVec3 &way) const { return atStart + dot(change, way); }
  /// Where it comes to a value; nothing where it never changes.
  [[nodiscard]] std::optional<Flat> placesOf(const Rational &value, const ExactVec3 &start) const {
    if (isZero(change))
      return {};
    return Flat::plane(start - change * Rational((atStart - value) / dot(change, change)), change);
  }
};

/// No way and one along each axis tell the proportion, the oblique ones whether there is any.
const std::array ways{ExactVec3(0),       ExactVec3(1, 0, 0),  ExactVec3(0, 1, 0),
                      ExactVec3(0, 0, 1), ExactVec3(-2, 3, 5), ExactVec3(4, 3, -7)};
using AfterWays = std::array<Rational, ways.size()>;
constexpr std::size_t firstOblique = 4;

Proportional throughFirst(const AfterWays &values) {
  return {values[0], ExactVec3(values[1] - values[0], values[2] - values[0], values[3] - values[0])};
}

std::optional<Proportional> proportionalThrough(const AfterWays &values) {
  const Proportional number = throughFirst(values);
  for (std::size_t i = firstOblique; i < ways.size(); ++i)
    if (number.after(ways.at(i)) != values.at(i))
      return {};
  return number;
}

/// The number with a sign that a volume or another number without one belongs to.
std::optional<Proportional> proportionalUpToSign(const AfterWays &values) {
  if (std::any_of(values.begin(), values.end(), [](const Rational &value) { return value < 0; }))
    return {};
  // At the start it may be taken as positive. After the way along each axis it has either sign.
  constexpr unsigned choices = 1U << 3U;
  for (unsigned choice = 0; choice < choices; ++choice) {
    AfterWays withSigns = values;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((choice >> axis & 1U) != 0)
        withSigns.at(axis + 1) *= -1;
    const Proportional number = throughFirst(withSigns);
    bool fits = true;
    for (std::size_t i = firstOblique; i < ways.size(); ++i)
      fits = fits && abs(number.after(ways.at(i))) == values.at(i);
    if (fits)
      return number;
  }
  return {};
}

/// What is lacking after each way.
struct Lacking {
  AfterWays amounts;
  bool isRational = true; ///< none is a multiple of a root
};

/// Nothing where it is no number after some way, or a multiple of different roots.
std::optional<Lacking> lackingAfterWays(const Condition &condition, const Tried &tried,
                                        const ExactVec3 &start) {
  Lacking lacking;
  std::optional<Rational> radicand;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const auto lack = lackOf(condition, tried.atProbe(start + ways.at(i)));
    if (!lack || (lack->amount != 0 && radicand && *radicand != lack->radicand))
      return {};
    if (lack->amount != 0)
      radicand = lack->radicand;
    lacking.amounts.at(i) = lack->amount;
  }
  lacking.isRational = !radicand || *radicand == 1;
  return lacking;
}

/// Where the condition holds, if what is lacking changes in proportion to the way of the handle: a plane; or
/// two, where only the number with a sign does so.
std::vector<Flat> placesOf(const Condition &condition, const Tried &tried, const ExactVec3 &start) {
  const auto lacking = lackingAfterWays(condition, tried, start);
  if (!lacking)
    return {};
  if (const auto lack = proportionalThrough(lacking->amounts)) {
    const auto plane = lack->placesOf(0, start);
    return plane ? std::vector{*plane} : std::vector<Flat>();
  }
  if (!lacking->isRational)
    return {};
  const Rational against = *parseRational(condition.against);
  std::vector<Rational> askedFor{against};
  if (against != 0)
    askedFor.emplace_back(-against);
  AfterWays values = lacking->amounts;
  for (Rational &value : values)
    value += against;
  const auto number = proportionalUpToSign(values);
  if (!number)
    return {};
  std::vector<Flat> places;
  for (const Rational &value : askedFor)
    if (const auto plane = number->placesOf(value, start))
      places.push_back(*plane);
  return places;
}

/// What the probes around a start come to beside a number that a condition asks for: as they are, or squared
/// where their squares are fractions, as those of a length.
std::optional<Quadric> surfaceOf(const Condition &condition, const Tried &tried, const ExactVec3 &start) {
  const Rational against = *parseRational(condition.against);
  std::array<Rational, Quadric::probeCount> lacking;
  std::array<Rational, Quadric::probeCount> lackingSquared;
  bool areFractions = true;
  const auto places = Quadric::probes(start);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto value = findValue(tried.atProbe(places.at(i)), condition.value);
    const auto *number = value ? std::get_if<Surd>(&*value) : nullptr;
    if (!number || !number->squared().isRational())
      return {};
    areFractions = areFractions && number->isRational();
    lacking.at(i) = number->rationalPart() - against;
    lackingSquared.at(i) = number->squared().rationalPart() - against * against;
  }
  const auto surface = areFractions ? Quadric::through(start, lacking) : std::nullopt;
  return surface ? surface : Quadric::through(start, lackingSquared);
}

/// `dist = 5, t = 1`, by the names that learners read.
std::string wordsOf(const Conditions &conditions, const Evaluation &evaluation) {
  std::string told;
  for (const Condition &condition : conditions) {
    const auto value = findNamedValue(evaluation, condition.value);
    const std::string name = value ? readName(*value) : std::string();
    if (name.empty())
      return words("as the task asks");
    told += (told.empty() ? "" : ", ") + name + " = " + condition.against;
  }
  return told;
}

/// What two lists of alternatives have in common.
std::vector<Flat> intersections(const std::vector<Flat> &some, const std::vector<Flat> &others) {
  std::vector<Flat> common;
  for (const Flat &one : some)
    for (const Flat &other : others)
      if (const auto both = Flat::intersection(one, other))
        common.push_back(*both);
  return common;
}

/// The places where a task's numbers are as it asks, each alternative a target of its own.
std::vector<SnapTarget> targetsOf(const Task &task, const std::shared_ptr<const Tried> &tried,
                                  const ExactVec3 &start) {
  std::vector<Flat> places{Flat()};
  std::optional<Quadric> surface;
  Conditions met;
  for (const Condition &condition : task.conditions) {
    if (!asksForANumber(condition))
      continue;
    const std::vector<Flat> flats = placesOf(condition, *tried, start);
    bool isMet = !flats.empty();
    if (isMet) {
      places = intersections(places, flats);
    } else if (!surface) { // a target has one
      surface = surfaceOf(condition, *tried, start);
      isMet = surface.has_value();
    }
    if (isMet)
      met.push_back(condition);
  }
  std::vector<SnapTarget> targets;
  if (met.empty())
    return targets;
  for (const Flat &each : places) {
    SnapTarget &target = targets.emplace_back();
    target.places = each;
    target.surface = surface;
    target.name = wordsOf(met, tried->atStart());
    target.counts = [tried, met](const ExactVec3 &place) {
      const Evaluation there = tried->at(place);
      return std::all_of(met.begin(), met.end(),
                         [&](const Condition &condition) { return holds(condition, there); });
    };
  }
  return targets;
}

} // namespace

std::vector<SnapTarget> taskTargets(const std::vector<Task> &tasks, const Scene &scene,
                                    const Handle &handle) {
  std::vector<SnapTarget> targets;
  if (!findObject(scene, handle.object))
    return targets;
  const auto tried = std::make_shared<const Tried>(scene, handle);
  for (const Task &task : tasks)
    for (SnapTarget &target : targetsOf(task, tried, handle.at))
      targets.push_back(std::move(target));
  return targets;
}

} // namespace halfspace
