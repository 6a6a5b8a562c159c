// Values among the words of a lesson: `{f}` stands for what f comes to.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// Whether the learner sees what constructions come to, or is still to find it.
enum class LiveValues { Shown, Hidden };

/// The markdown with each `{name}` of a value replaced by the value, as `$…$` LaTeX for numbers; by a
/// question mark where values are hidden. `{Q}` and `{E.n}` name the scene's coordinates.
[[nodiscard]] std::string withLiveValues(const std::string &markdown, const Scene &scene,
                                         const Evaluation &evaluation, LiveValues values = LiveValues::Shown);

/// A `{name}` in Markdown, outside formulas and code, with its place in the text.
struct LiveName {
  std::string name;
  std::size_t place; ///< of the brace
};
[[nodiscard]] std::vector<LiveName> liveNamesIn(std::string_view markdown);

} // namespace halfspace
