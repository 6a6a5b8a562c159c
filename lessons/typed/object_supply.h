// Objects for the places of a call.
#pragma once

#include "lessons/scene/seen_objects.h"
#include "lessons/typed/signature.h"

#include <set>

namespace halfspace {

/// What stands between the brackets of a call.
struct FilledPlaces {
  std::vector<std::string> arguments;
  std::size_t madeUp = 0; ///< so many of them for want of objects
};

/// The objects of a scene, to be put into calls.
class ObjectSupply {
public:
  /// Numbers are written with the decimal mark.
  ObjectSupply(const Scene &scene, char decimalMark);

  /// The ids of those that can stand in a place and begin with a text: the newest first, and entries before
  /// what constructions make.
  [[nodiscard]] std::vector<SeenObject> fitting(const ArgumentPlace &place, std::string_view beginning,
                                                const std::set<std::string> &without) const;
  /// All places with the newest objects that fit, those of one kind in the order of the scene; nothing where
  /// an object is missing that has to be there.
  [[nodiscard]] std::optional<FilledPlaces> filled(const std::vector<ArgumentPlace> &places,
                                                   std::set<std::string> without) const;
  /// All of them, in the order of `fitting`.
  [[nodiscard]] const std::vector<SeenObject> &all() const { return m_objects; }

private:
  char m_mark;
  std::vector<SeenObject> m_objects;
};

} // namespace halfspace
