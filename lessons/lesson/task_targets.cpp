#include "lessons/lesson/task_targets.h"

#include "lessons/lesson/condition.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>

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

  [[nodiscard]] const Evaluation &atStart() const { return m_start; }

private:
  Scene m_scene;
  Handle m_handle;
  Object m_object;
  Evaluation m_start;
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

/// Where the condition holds, if what is lacking changes in proportion to the way of the handle.
std::optional<Flat> placesOf(const Condition &condition, const Tried &tried, const ExactVec3 &start) {
  // Three ways along the axes tell the proportion, a fourth, oblique one whether there is any.
  const std::array ways{ExactVec3(0), ExactVec3(1, 0, 0), ExactVec3(0, 1, 0), ExactVec3(0, 0, 1),
                        ExactVec3(-2, 3, 5)};
  std::vector<Rational> lacking;
  std::optional<Rational> radicand;
  for (const ExactVec3 &way : ways) {
    const auto lack = lackOf(condition, tried.at(start + way));
    if (!lack || (lack->amount != 0 && radicand && *radicand != lack->radicand))
      return {};
    if (lack->amount != 0)
      radicand = lack->radicand;
    lacking.push_back(lack->amount);
  }
  const ExactVec3 change(lacking[1] - lacking[0], lacking[2] - lacking[0], lacking[3] - lacking[0]);
  if (isZero(change) || lacking[0] + dot(change, ways[4]) != lacking[4])
    return {};
  return Flat::plane(start - change * Rational(lacking[0] / dot(change, change)), change);
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
    const auto value = findValue(tried.at(places.at(i)), condition.value);
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

std::optional<SnapTarget> targetOf(const Task &task, const std::shared_ptr<const Tried> &tried,
                                   const ExactVec3 &start) {
  SnapTarget target;
  Conditions met;
  for (const Condition &condition : task.conditions) {
    if (!asksForANumber(condition))
      continue;
    if (const auto places = placesOf(condition, *tried, start)) {
      const auto common = Flat::intersection(target.places, *places);
      if (!common)
        return {};
      target.places = *common;
    } else if (!target.surface) {
      target.surface = surfaceOf(condition, *tried, start);
      if (!target.surface)
        continue;
    } else {
      continue;
    }
    met.push_back(condition);
  }
  if (met.empty())
    return {};
  target.name = wordsOf(met, tried->atStart());
  target.counts = [tried, met](const ExactVec3 &place) {
    const Evaluation there = tried->at(place);
    return std::all_of(met.begin(), met.end(),
                       [&](const Condition &condition) { return holds(condition, there); });
  };
  return target;
}

} // namespace

std::vector<SnapTarget> taskTargets(const std::vector<Task> &tasks, const Scene &scene,
                                    const Handle &handle) {
  std::vector<SnapTarget> targets;
  if (!findObject(scene, handle.object))
    return targets;
  const auto tried = std::make_shared<const Tried>(scene, handle);
  for (const Task &task : tasks)
    if (auto target = targetOf(task, tried, handle.at))
      targets.push_back(std::move(*target));
  return targets;
}

} // namespace halfspace
