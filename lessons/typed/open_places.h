// The places of a call that nothing stands in yet.
#pragma once

#include "lessons/typed/scene_names.h"
#include "lessons/typed/signature.h"

namespace halfspace {

struct OpenPlaces {
  std::vector<ArgumentPlace> needed;     ///< the next one first
  std::vector<ArgumentPlace> possible{}; ///< lists in which something stands already
  std::set<std::string> used{};          ///< the ids of what stands in the others
};

/// What arguments leave open; nothing where they do not fit. Those whose order counts may be any formulas.
[[nodiscard]] std::optional<OpenPlaces> openPlaces(const Signature &signature,
                                                   const std::vector<std::string_view> &arguments,
                                                   const SceneNames &names);

} // namespace halfspace
