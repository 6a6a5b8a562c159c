#include "lessons/discovery/discover.h"

#include "lessons/discovery/facts.h"
#include "lessons/discovery/moved_scene.h"
#include "lessons/object/letters.h"
#include "lessons/scene/offered_objects.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

/// At so many places something has to hold to be always true; so many are tried at most until all objects
/// were there so often.
constexpr std::size_t enoughPlaces = 12;
constexpr std::size_t mostPlaces = 48;
/// Any other would do: it makes the same answer come every time.
constexpr std::uint64_t seed = 53;

/// The objects that were asked for, as they stand at one place; nothing for what is not there.
using Sample = std::vector<std::optional<SpatialObject>>;

std::optional<SpatialObject> spatialIn(const Evaluation &evaluation, const std::string &id) {
  const OfferedObject *object = findOffered(evaluation, id);
  return object && object->whyNot.empty() ? spatialOf(object->given->object) : std::nullopt;
}

Sample sampleOf(const Evaluation &evaluation, const std::vector<std::string> &ids) {
  Sample sample;
  for (const std::string &id : ids)
    sample.push_back(spatialIn(evaluation, id));
  return sample;
}

/// A fact about certain ones of the objects: a is the one at the first index.
struct Claim {
  const Fact *fact;
  std::vector<std::size_t> objects;

  /// Nothing where one of the objects is not there.
  [[nodiscard]] std::optional<bool> holdsIn(const Sample &sample) const {
    std::vector<SpatialObject> own;
    for (const std::size_t object : objects) {
      if (!sample[object])
        return {};
      own.push_back(*sample[object]);
    }
    return fact->holds(own);
  }
};

/// Adds the claims of a fact about objects of which the first ones are chosen.
void addClaims(const Fact &fact, const Sample &sample, std::vector<std::size_t> &chosen,
               std::vector<Claim> &claims) {
  if (chosen.size() == fact.places.size()) {
    const bool isInOrder = std::all_of(fact.inOrder.begin(), fact.inOrder.end(), [&](const auto &pair) {
      return chosen[pair.first] < chosen[pair.second];
    });
    if (Claim claim{&fact, chosen}; isInOrder && claim.holdsIn(sample).value())
      claims.push_back(std::move(claim));
    return;
  }
  for (std::size_t object = 0; object < sample.size(); ++object) {
    const bool isTaken = std::find(chosen.begin(), chosen.end(), object) != chosen.end();
    if (isTaken || !sample[object] || (fact.places[chosen.size()] & only(sample[object]->form)) == 0)
      continue;
    chosen.push_back(object);
    addClaims(fact, sample, chosen, claims);
    chosen.pop_back();
  }
}

/// All that holds at a place.
std::vector<Claim> claimsIn(const Sample &sample) {
  std::vector<Claim> claims;
  std::vector<std::size_t> chosen;
  for (const Fact &fact : facts())
    addClaims(fact, sample, chosen, claims);
  return claims;
}

/// Where the objects come to when what they follow is moved: until all of them were there often enough.
std::vector<Sample> samplesOf(const Scene &scene, const std::vector<std::string> &ids) {
  const Scene behind = sceneBehind(scene, ids);
  SceneMover mover(seed);
  std::vector<Sample> samples;
  Evaluation evaluation;
  std::size_t complete = 0;
  while (samples.size() < mostPlaces && complete < enoughPlaces) {
    const bool isNearby = samples.size() % 2 == 0;
    evaluation = evaluate(isNearby ? mover.movedNearby(behind) : mover.movedFar(behind), evaluation);
    samples.push_back(sampleOf(evaluation, ids));
    if (std::all_of(samples.back().begin(), samples.back().end(),
                    [](const auto &object) { return object.has_value(); }))
      ++complete;
  }
  return samples;
}

bool isAlwaysTrue(const Claim &claim, const std::vector<Sample> &samples) {
  std::size_t held = 0;
  for (const Sample &sample : samples) {
    const auto holds = claim.holdsIn(sample);
    if (holds == false)
      return false;
    if (holds)
      ++held;
  }
  return held >= enoughPlaces;
}

std::string sentenceOf(const Claim &claim, const std::vector<Symbol> &symbols) {
  constexpr std::array names{"a", "b", "c", "d"};
  WordValues values;
  for (std::size_t i = 0; i < claim.objects.size(); ++i)
    values.emplace_back(names.at(i), plainText(symbols[claim.objects[i]]));
  for (std::size_t i = 0; i + 1 < claim.objects.size(); i += 2)
    values.emplace_back(std::string(names.at(i)) + names.at(i + 1),
                        edgeName(symbols[claim.objects[i]], symbols[claim.objects[i + 1]]));
  return words(claim.fact->sentence.english, values);
}

} // namespace

std::vector<Discovery> discoveriesOf(const Evaluation &evaluation, const std::vector<std::string> &selected) {
  std::vector<std::string> ids;
  std::vector<Symbol> symbols;
  for (const std::string &id : selected)
    if (ids.size() < mostLookedAt && std::find(ids.begin(), ids.end(), id) == ids.end() &&
        spatialIn(evaluation, id)) {
      ids.push_back(id);
      symbols.push_back(findOffered(evaluation, id)->given->symbol);
    }
  const std::vector<Claim> claims = claimsIn(sampleOf(evaluation, ids));
  if (claims.empty())
    return {};
  const std::vector<Sample> samples = samplesOf(evaluation.scene, ids);
  std::vector<Discovery> found;
  for (const Claim &claim : claims) {
    Discovery discovery{sentenceOf(claim, symbols), {}, isAlwaysTrue(claim, samples)};
    for (const std::size_t object : claim.objects)
      discovery.ids.push_back(ids[object]);
    found.push_back(std::move(discovery));
  }
  std::stable_partition(found.begin(), found.end(), [](const Discovery &each) { return each.isAlways; });
  return found;
}

std::string wordsFor(const Discovery &discovery) {
  return discovery.isAlways ? words("{sentence} This holds wherever the free objects are.",
                                    {{"sentence", discovery.sentence}})
                            : words("{sentence} This holds here, but need not hold elsewhere.",
                                    {{"sentence", discovery.sentence}});
}

} // namespace halfspace
