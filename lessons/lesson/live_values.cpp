#include "lessons/lesson/condition.h"
#include "lessons/term/latex.h"
#include "lessons/term/written.h"

#include <algorithm>
#include <set>

namespace halfspace {
namespace {

/// Stands for a value that the present case does not have.
constexpr std::string_view noValue = "—";

/// Braces further apart than this hold no name.
constexpr std::size_t longestName = 80;

/// A value as Markdown: numbers as LaTeX, with ≈ when they are rounded, words as they are.
std::string markdownOf(const Value &value) {
  if (const auto *word = std::get_if<std::string>(&value))
    return *word;
  const auto term = termOf(value);
  if (!term)
    return std::string(noValue);
  Notation amongWords;
  amongWords.smallFractions = true;
  return std::string("$") + (showsRounded(*term) ? "\\approx " : "") +
         latexOf(*term, LatexMarks::Without, amongWords) + "$";
}

std::string markdownOf(std::string_view name, const Scene &scene, const Outcome &outcome) {
  if (const auto value = findValue(outcome, name))
    return markdownOf(*value);
  if (const auto id = findCoordinate(scene, name)) {
    const ExactVec3 &at = coordinate(*findObject(scene, id->object), id->index);
    return markdownOf(std::vector<Surd>{at.x, at.y, at.z});
  }
  return std::string(noValue);
}

/// The length of a formula or of code that starts here, where braces mean something else; 0 elsewhere.
std::size_t verbatimLength(std::string_view text) {
  if (text.front() == '\\' && text.size() > 1)
    return 2;
  if (text.front() != '$' && text.front() != '`')
    return 0;
  const std::string_view fence = text.substr(0, std::min(text.find_first_not_of(text.front()), text.size()));
  const auto end = text.find(fence, fence.size());
  return end == std::string_view::npos ? fence.size() : end + fence.size();
}

} // namespace

std::string withLiveValues(const std::string &markdown, const Scene &scene, const Outcome &outcome) {
  std::string filled;
  for (std::string_view rest = markdown; !rest.empty();) {
    const std::size_t verbatim = verbatimLength(rest);
    const auto close = rest.front() == '{' ? rest.substr(0, longestName).find('}') : std::string_view::npos;
    std::size_t taken = std::max<std::size_t>(verbatim, 1);
    if (close != std::string_view::npos && isValueName(rest.substr(1, close - 1))) {
      const std::string value = markdownOf(rest.substr(1, close - 1), scene, outcome);
      // “t = ≈ 3.14” says it twice, and once wrongly.
      if (filled.ends_with("= ") && value.starts_with("$\\approx"))
        filled.erase(filled.size() - 2);
      filled += value;
      taken = close + 1;
    } else {
      filled += rest.substr(0, taken);
    }
    rest.remove_prefix(taken);
  }
  return filled;
}

Shown shownIn(const LessonStep &step, const Outcome &outcome) {
  if (step.lines.empty())
    return {outcome.working, outcome.figure};
  Shown shown;
  std::set<std::string> named;
  for (const WorkingLine &line : outcome.working.lines)
    if (std::find(step.lines.begin(), step.lines.end(), line.id) != step.lines.end()) {
      shown.working.add(line);
      named.merge(marksIn(line));
    }
  for (const Mark &mark : outcome.figure.marks)
    if (baseOf(mark).role == Role::Given || named.contains(leadingId(baseOf(mark))))
      shown.figure.add(mark);
  return shown;
}

} // namespace halfspace
