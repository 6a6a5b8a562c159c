// What objects of a scene come to.
#pragma once

#include "lessons/construction/outcome.h"
#include "lessons/object/given.h"
#include "lessons/scene/scene.h"

namespace halfspace {

using SharedGiven = std::shared_ptr<const Given<Object>>;

/// Of a free object: itself.
[[nodiscard]] std::shared_ptr<const Outcome> outcomeOfFree(const SharedGiven &given);
/// Of an object that follows others, with what its coordinates come to. It is drawn as far as some places.
[[nodiscard]] std::shared_ptr<const Outcome>
outcomeOfDerived(const SharedGiven &given, const DerivedObject &derived, const std::vector<Place> &places);
/// Of an object that lies on another, with its place besides its freedoms; its host is drawn up to there.
[[nodiscard]] std::shared_ptr<const Outcome> outcomeOfBound(const SharedGiven &given,
                                                            const std::string &host);
/// Of what cannot be told now, for a reason: a sentence.
[[nodiscard]] std::shared_ptr<const Outcome> withoutAnObject(const std::string &reason);

} // namespace halfspace
