#include "lessons/construction/construction.h"

#include "lessons/term/plain_text.h"

#include <algorithm>

namespace halfspace {

Naming withLetters(Naming naming, const std::vector<ConstructionRole> &roles, GivenObjects objects) {
  WordValues &letters = naming.letters;
  const auto stands = [&](const std::string &name) {
    return std::any_of(letters.begin(), letters.end(), [&](const auto &each) { return each.first == name; });
  };
  const auto add = [&](const Given<Object> &object, const std::string &role) {
    const auto &specs = coordinatesOf(object.object);
    letters.emplace_back(role, plainText(object.symbol));
    for (std::size_t k = 0; k < specs.size(); ++k) {
      const std::string own(specs[k].name);
      const std::string text = plainText(object.letters[k]);
      if (!own.empty() && !stands(own))
        letters.emplace_back(own, text);
      letters.emplace_back(role + "." + own, text);
    }
  };
  std::size_t next = 0;
  for (const ConstructionRole &role : roles)
    for (std::size_t place = 0; place < countIn(role, roles.size(), objects.size()); ++place)
      add(*objects[next++], role.isList ? role.name + std::to_string(place) : role.name);
  for (const auto &[name, made] : naming.made) {
    letters.emplace_back(name, plainText(made.symbol));
    for (const auto &[coordinate, letter] : made.coordinates)
      letters.emplace_back(name + "." + coordinate, plainText(letter));
  }
  return naming;
}

const Construction *findConstruction(std::string_view id) {
  for (const Construction &construction : constructions())
    if (construction.id == id)
      return &construction;
  return nullptr;
}

} // namespace halfspace
