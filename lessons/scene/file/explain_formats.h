// What a scene comes to as text for the command line and for scripts.
#pragma once

#include "lessons/scene/evaluation.h"

namespace halfspace {

/// {"lesson":…,"case":…,"values":{…},"working":[…],"description":…,"scene":[…],"outcomes":[…]}: the scene as
/// in a file, and for each construction
/// {"entry":…,"construction":…,"of":{…},"case":…,"values":{…},"objects":{…},"working":[…],"description":…}.
/// The fields at the top are those of the last construction. Each figure in `values` is {"value":…,
/// "exact":…} as in the eval format; objects are as in a file.
[[nodiscard]] std::string explanationJson(const std::string &lesson, const Scene &scene,
                                          const Evaluation &evaluation);

// A title that is empty is left out.

/// Of every construction the worked lines, the values and the description as plain text, under its name where
/// there are several.
[[nodiscard]] std::string explanationText(const std::string &title, const Evaluation &evaluation);

/// The lines and the description as LaTeX, the lines in an align* environment of amsmath, the words as text.
[[nodiscard]] std::string explanationLatex(const std::string &title, const Evaluation &evaluation);

/// The same as a `<section>` of a page: HTML that is XML as well, the lines as MathML.
[[nodiscard]] std::string explanationMathMl(const std::string &title, const Evaluation &evaluation);

} // namespace halfspace
