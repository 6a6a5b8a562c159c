#include "lessons/scene/scene_letters.h"

#include "lessons/construction/construction.h"
#include "lessons/object/kinds/point.h"

namespace halfspace {

SceneLetters::SceneLetters(const Scene &scene) {
  for (const Entry &entry : scene.entries) {
    if (const auto *object = std::get_if<Object>(&entry.content)) {
      count(entry.name);
      if (!isBound(entry)) // freedoms always say whose they are
        countCoordinates(*object);
    } else if (const auto *derived = std::get_if<DerivedObject>(&entry.content)) {
      count(entry.name);
      countCoordinates(Object(*derived->kind));
    } else if (const Construction *construction =
                   findConstruction(std::get<ConstructionUse>(entry.content).id)) {
      for (const ConstructionRole &made : construction->makes) {
        count(made.name);
        countCoordinates(*makeObject(made.kind));
      }
      for (const std::string &own : construction->ownLetters)
        count(own);
    }
  }
}

void SceneLetters::countCoordinates(const Object &object) {
  for (const CoordinateSpec &spec : coordinatesOf(object))
    if (!spec.goesByObject())
      count(spec.name);
}

bool SceneLetters::isShared(std::string_view name) const {
  const auto found = m_count.find(std::string(spelledLetter(name)));
  return found != m_count.end() && found->second > 1;
}

Symbol SceneLetters::symbolOfMade(const std::string &entry, const std::string &name) const {
  Symbol symbol = symbolOf(name);
  if (isShared(name))
    symbol.owner = entry;
  return symbol;
}

std::vector<Symbol> SceneLetters::lettersOf(const Object &object, const Symbol &symbol,
                                            const std::string &owner) const {
  std::vector<Symbol> letters;
  for (const CoordinateSpec &spec : coordinatesOf(object)) {
    Symbol letter = spec.goesByObject() ? symbol : symbolOf(spec.name);
    letter.isVector = spec.role == CoordinateRole::Direction;
    if (!spec.goesByObject() && isShared(spec.name))
      letter.owner = owner;
    letters.push_back(std::move(letter));
  }
  return letters;
}

Given<Object> SceneLetters::given(const std::string &entry, Object object) const {
  Symbol symbol = symbolOf(entry);
  std::vector<Symbol> letters = lettersOf(object, symbol, entry);
  return {entry, std::move(symbol), std::move(letters), std::move(object)};
}

Given<Object> SceneLetters::derived(const std::string &entry, Object object) const {
  Given<Object> follower = given(entry, std::move(object));
  follower.isFree = false;
  return follower;
}

Given<Object> SceneLetters::freedoms(const std::string &entry, Object object) const {
  Given<Object> own = given(entry, std::move(object));
  for (Symbol &letter : own.letters)
    letter.owner = entry;
  return own;
}

Given<Object> SceneLetters::bound(const std::string &entry, const ExactVec3 &place) const {
  return derived(entry, PointObject{place});
}

Given<Object> SceneLetters::made(const std::string &entry, const std::string &name, Object object) const {
  Symbol symbol = symbolOfMade(entry, name);
  std::vector<Symbol> letters = lettersOf(object, symbol, isShared(name) ? entry : name);
  return {entry + "." + name, std::move(symbol), std::move(letters), std::move(object), false};
}

Naming SceneLetters::namingOf(const Entry &entry) const {
  Naming naming{entry.name};
  if (const Construction *construction = findConstruction(std::get<ConstructionUse>(entry.content).id)) {
    for (const ConstructionRole &role : construction->makes) {
      const Given<Object> object = made(entry.name, role.name, *makeObject(role.kind));
      MadeLetters letters{object.symbol};
      for (std::size_t i = 0; i < object.letters.size(); ++i)
        letters.coordinates.emplace(coordinatesOf(object.object)[i].name, object.letters[i]);
      naming.made.emplace(role.name, std::move(letters));
    }
    for (const std::string &own : construction->ownLetters)
      if (isShared(own))
        naming.shared.insert(own);
  }
  return naming;
}

} // namespace halfspace
