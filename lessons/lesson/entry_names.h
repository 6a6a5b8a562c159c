// What the entries of a scene can come to, in any of their cases: the names that lessons may ask for.
#pragma once

#include "lessons/construction/construction_names.h"
#include "lessons/scene/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

/// An entry of a scene with the names that it can come to.
struct EntryNames {
  std::string name;
  std::vector<ValueName> values{}; ///< those of its construction, with its case, or of an object that follows
  std::vector<std::string> lines{}; ///< within the entry
  std::vector<std::string> marks{}; ///< their ids in the scene
};
[[nodiscard]] EntryNames namesOf(const Entry &entry);

/// The value at a path, `perp.uu`, `foot.z`; nothing where there is none.
[[nodiscard]] std::optional<ValueName> findValueName(const std::vector<ValueName> &values,
                                                     std::string_view path);

/// The paths of all values, those within groups too, behind a beginning.
void addPaths(const std::vector<ValueName> &values, const std::string &before,
              std::vector<std::string> &paths);

/// A number or a word of a scene by the name that lessons ask for it with: `f` where only one entry has an f,
/// else `distance.f`.
struct OfferedValue {
  std::string name;
  ValueName value;
};

/// All that can be compared, from top to bottom; of a vector each of its numbers.
[[nodiscard]] std::vector<OfferedValue> comparableValues(const Scene &scene);

} // namespace halfspace
