#include "lessons/scene/object_of_mark.h"

#include <algorithm>

namespace halfspace {
namespace {

/// The name of the object within its entry whose mark this is: F for `distance.F` and `distance.F/angle`.
std::string_view madeNameIn(std::string_view mark) {
  const std::string_view own = qualified(mark).own;
  return own.substr(0, own.find_first_of("./"));
}

} // namespace

std::string objectOfMark(const Evaluation &evaluation, std::string_view mark) {
  const EvaluatedEntry *entry = evaluation.find(entryOfMark(mark));
  if (!entry)
    return {};
  const std::string_view made = madeNameIn(mark);
  const bool isMade =
      entry->isConstruction() && std::any_of(entry->offers.begin(), entry->offers.end(),
                                             [&](const OfferedObject &each) { return each.name == made; });
  return isMade ? entry->name + "." + std::string(made) : entry->name;
}

} // namespace halfspace
