// An outcome as text for the command line and for scripts.
#pragma once

#include "lessons/construction/outcome.h"

namespace halfspace {

/// {"lesson":…,"case":…,"values":{…},"working":[…],"description":…}; each figure in `values` is
/// {"value":…, "exact":…} as in the eval format.
[[nodiscard]] std::string explanationJson(const std::string &lesson, const Outcome &outcome);

/// The worked lines, the values and the description as plain text.
[[nodiscard]] std::string explanationText(const std::string &title, const Outcome &outcome);

/// The same as LaTeX for an align* environment, description as text.
[[nodiscard]] std::string explanationLatex(const std::string &title, const Outcome &outcome);

} // namespace halfspace
