#include "lessons/typed/call_words.h"

#include "lessons/construction/construction.h"
#include "lessons/object/kind.h"
#include "lessons/object/solid.h"

#include <algorithm>
#include <map>
#include <set>

namespace halfspace {
namespace {

/// Whether there are objects that could stand in either role.
bool canShareObjects(const ConstructionRole &a, const ConstructionRole &b) {
  return canStandFor(a.kind, b.kind) || canStandFor(b.kind, a.kind);
}

/// Whether objects of one construction's roles could stand in those of another. Where one of them has a list
/// nobody looks closer.
bool couldTake(const Construction &other, const Construction &construction) {
  const auto hasList = [](const Construction &each) {
    return std::any_of(each.roles.begin(), each.roles.end(), [](const auto &role) { return role.isList; });
  };
  if (hasList(other) || hasList(construction))
    return true;
  std::vector<ConstructionRole> left = other.roles;
  for (const ConstructionRole &role : construction.roles) {
    const auto shared =
        std::find_if(left.begin(), left.end(), [&](const auto &each) { return canShareObjects(role, each); });
    if (shared == left.end())
      return false;
    left.erase(shared);
  }
  return left.empty();
}

bool isCalledByWord(const Construction &construction) {
  if (construction.word.empty() || construction.id.find(construction.word) != std::string_view::npos)
    return false;
  for (const Construction &other : constructions()) {
    if (&other == &construction)
      return true;
    if (other.word == construction.word && couldTake(other, construction))
      return false;
  }
  return false;
}

} // namespace

std::string_view callOf(const Construction &construction) {
  static const auto calls = [] {
    std::map<std::string_view, std::string_view> byId;
    for (const Construction &each : constructions())
      byId.emplace(each.id, isCalledByWord(each) ? each.word : each.id);
    return byId;
  }();
  return calls.at(construction.id);
}

const std::vector<std::string> &callWords() {
  static const std::vector<std::string> all = [] {
    std::set<std::string> found;
    for (const Kind &kind : kinds())
      if (!kind.shape)
        found.emplace(kind.word);
    for (const Construction &construction : constructions()) {
      found.emplace(construction.id);
      if (!construction.word.empty())
        found.emplace(construction.word);
    }
    return std::vector<std::string>(found.begin(), found.end());
  }();
  return all;
}

} // namespace halfspace
