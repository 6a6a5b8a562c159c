// A construction's own letters as terms.
#pragma once

#include "lessons/construction/naming.h"

namespace halfspace {

/// A letter of the construction's own with what it comes to: nothing where that is no number, as with an
/// angle.
[[nodiscard]] Term ownName(const Naming &naming, Symbol letter, std::optional<TermValue> value);
/// The same of a letter that is drawn, as the mark that is called like it: `distance.w`, `distance.n1`.
[[nodiscard]] Term drawnName(const Naming &naming, Symbol letter, std::optional<TermValue> value);

/// What a construction's Out begins with. Out has the letters of the lines as members, each declared with
/// what it is, so that it is calculated where it is named: `Term t = ownName(letter("t"), meet.t);`. In has
/// the objects, and lives as long.
template <class In> struct Computed : Naming {
  explicit Computed(const In &objects) : Naming(objects), in(objects) {}
  Computed(const Computed &) = delete;
  Computed &operator=(const Computed &) = delete;

  const In &in;

  [[nodiscard]] Term ownName(const Symbol &letter, const std::optional<TermValue> &value) const {
    return halfspace::ownName(*this, letter, value);
  }
  [[nodiscard]] Term drawnName(const Symbol &letter, const std::optional<TermValue> &value) const {
    return halfspace::drawnName(*this, letter, value);
  }
  /// A point that the construction makes, and a coordinate of another object that it makes.
  [[nodiscard]] Term madeName(const std::string &object, const std::optional<TermValue> &value) const {
    return halfspace::madeName(*this, object, value);
  }
  [[nodiscard]] Term madeName(const std::string &object, const std::string &coordinate,
                              const std::optional<TermValue> &value) const {
    return halfspace::madeName(*this, object, coordinate, value);
  }
};

} // namespace halfspace
