// How the objects of a scene and their coordinates are written.
#pragma once

#include "lessons/construction/naming.h"
#include "lessons/object/given.h"
#include "lessons/scene/scene.h"

#include <string_view>
#include <unordered_map>

namespace halfspace {

/// Gives every object and every coordinate of a scene its letter. One that several have says whose it is: n
/// of the plane G is n with the index G where the plane H has an n too, and the foot F that the entry
/// `distance` makes is F with the index `distance` where another entry makes one. The scene need not outlive
/// it.
class SceneLetters {
public:
  explicit SceneLetters(const Scene &scene);

  /// An entry's own object.
  [[nodiscard]] Given<Object> given(const std::string &entry, Object object) const;
  /// The object that an entry is whose coordinates follow others.
  [[nodiscard]] Given<Object> derived(const std::string &entry, Object object) const;
  /// The freedoms of a bound object, which always say whose they are: λ alone could be of any line.
  [[nodiscard]] Given<Object> freedoms(const std::string &entry, Object object) const;
  /// The point that an entry's bound object is, at its place.
  [[nodiscard]] Given<Object> bound(const std::string &entry, const ExactVec3 &place) const;
  /// An object that an entry makes by this name.
  [[nodiscard]] Given<Object> made(const std::string &entry, const std::string &name, Object object) const;
  /// The names of a use of a construction.
  [[nodiscard]] Naming namingOf(const Entry &entry) const;

private:
  void count(std::string_view name) { ++m_count[std::string(spelledLetter(writtenName(name)))]; }
  void countCoordinates(const Object &object);
  [[nodiscard]] bool isShared(std::string_view name) const;
  [[nodiscard]] Symbol symbolOfMade(const std::string &entry, const std::string &name) const;
  [[nodiscard]] std::vector<Symbol> lettersOf(const Object &object, const Symbol &symbol,
                                              const std::string &owner) const;

  std::unordered_map<std::string, int> m_count; ///< how many have a letter
};

} // namespace halfspace
