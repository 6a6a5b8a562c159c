// What the sentences of each construction claim, as conditions on the objects that they speak of, written
// otherwise than the program decides them. One file a construction, by the words of lessons/CMakeLists.txt.
#pragma once

#include "tests/lessons/construction/claims/said.h"
#include "tests/lessons/construction/expected/expected.h"

#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>

namespace halfspace::test {

/// Whether what a sentence says holds of the objects. `Said` has the texts at its places.
using Claim = std::function<bool(Objects, const Said &)>;

/// By the English sentence as it stands in the program, with its places: `{f} is positive`.
using Claims = std::map<std::string, Claim, std::less<>>;

/// Claims about a scene that is read from the objects once for all of them:
///
///     claimsAbout<Distance>({{"f({Q}) = 0: {Q} lies in the plane.", [](const Distance &at) { return at.f ==
///     0; }}})
///
/// A condition may also look at the texts of its sentence: `[](const Distance &at, const Said &said)`.
template <class Scene> class ClaimAbout {
public:
  template <class Condition>
  requires std::is_invocable_r_v<bool, Condition, const Scene &>
  // NOLINTNEXTLINE(google-explicit-constructor): a row of the table is a pair of sentence and condition
  ClaimAbout(Condition condition)
      : m_holds([condition](const Scene &scene, const Said &) { return condition(scene); }) {}

  template <class Condition>
  requires std::is_invocable_r_v<bool, Condition, const Scene &, const Said &>
  // NOLINTNEXTLINE(google-explicit-constructor): as above
  ClaimAbout(Condition condition) : m_holds(condition) {}

  [[nodiscard]] Claim claim() const {
    return [holds = m_holds](Objects objects, const Said &said) { return holds(Scene(objects), said); };
  }

private:
  std::function<bool(const Scene &, const Said &)> m_holds;
};

template <class Scene>
[[nodiscard]] Claims claimsAbout(std::initializer_list<std::pair<const char *, ClaimAbout<Scene>>> rows) {
  Claims claims;
  for (const auto &[sentence, about] : rows)
    claims.emplace(sentence, about.claim());
  return claims;
}

/// Of a construction that says sentences of several tables.
[[nodiscard]] inline Claims together(std::initializer_list<Claims> tables) {
  Claims all;
  for (const Claims &table : tables)
    all.insert(table.begin(), table.end());
  return all;
}

/// For sentences that cannot be false in any scene of their construction: definitions, rules, what to do
/// next, and identities that hold for all numbers. Each use says by its place in the table that somebody has
/// thought about it.
inline constexpr auto always = [](const auto &) { return true; };

[[nodiscard]] const Claims &claimsOf(const Construction &construction);

} // namespace halfspace::test
