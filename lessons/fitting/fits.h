// What can be made of the objects that somebody has selected.
#pragma once

#include "lessons/scene/scene.h"

namespace halfspace {

/// An object that is still to be selected.
struct WantedObject {
  std::string role;      ///< of the construction, in which it is to stand
  std::string_view kind; ///< the word of the kind that can stand there, or of solids
};

/// An entry that can be added behind all others of the scene.
struct Fit {
  Entry entry; ///< under a name that is free
  /// The one object that the entry's construction lacks: its role is not in the entry yet. Nothing where the
  /// entry is whole.
  std::optional<WantedObject> wanted{};
};

/// All entries that look at the selected objects and at nothing else: the uses of constructions, then the
/// objects that the selected ones are the coordinates of, as a triangle by its corners or a line by two of
/// its points; then the uses that want one more object, of a kind of which the scene has another one.
///
/// A single object has besides, before those that want another: a point that lies on it; the planes of its
/// faces, if it is a triangle, a polygon or a tetrahedron of the scene; of a segment what can be constructed
/// of its ends.
///
/// The ids are those of scene objects, `Q` or `distance.F`, or of a construction that makes one object;
/// other ones, and repetitions, count for nothing.
/// Each object goes into the first role that takes its kind, in the order of selection, and a list role takes
/// all that the other roles leave over.
[[nodiscard]] std::vector<Fit> fitsFor(const Scene &scene, const std::vector<std::string> &selected);

} // namespace halfspace
