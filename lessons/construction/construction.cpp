#include "lessons/construction/construction.h"

#include "lessons/term/plain_text.h"

#include <algorithm>

namespace halfspace {

Naming withLetters(Naming naming, const std::vector<ConstructionRole> &roles, GivenObjects objects) {
  WordValues &letters = naming.letters;
  const auto stands = [&](const std::string &name) {
    return std::any_of(letters.begin(), letters.end(), [&](const auto &each) { return each.first == name; });
  };
  // The roles go first: the v of a vector u is not the vector v beside it.
  std::vector<std::string> names;
  for (const ConstructionRole &role : roles)
    for (std::size_t place = 0; place < countIn(role, roles.size(), objects.size()); ++place) {
      names.push_back(role.isList ? role.name + std::to_string(place) : role.name);
      letters.emplace_back(names.back(), plainText(objects[names.size() - 1]->symbol));
    }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto &specs = coordinatesOf(objects[i]->object);
    for (std::size_t k = 0; k < specs.size(); ++k) {
      const std::string own(specs[k].name);
      const std::string text = plainText(objects[i]->letters[k]);
      if (!own.empty() && !stands(own))
        letters.emplace_back(own, text);
      letters.emplace_back(names[i] + "." + own, text);
    }
  }
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
