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

std::string markdownOf(std::string_view name, const Scene &scene, const Evaluation &evaluation) {
  if (const auto value = findValue(evaluation, name))
    return markdownOf(*value);
  if (const auto id = findCoordinate(scene, name)) {
    const Object &object = *findObject(scene, id->object);
    const ExactVec3 &at = object[id->index];
    const bool isSingle = numbersIn(coordinatesOf(object)[id->index].role) == 1;
    return markdownOf(isSingle ? Value(Surd(at.x)) : std::vector<Surd>{at.x, at.y, at.z});
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

/// Whether a name in a step means the line of an entry.
bool means(const std::string &name, const EvaluatedEntry &entry, const std::string &id,
           const Evaluation &evaluation) {
  if (name == entry.name + ".*" || name == entry.name + "." + id)
    return true;
  return name == id &&
         std::count_if(evaluation.entries.begin(), evaluation.entries.end(),
                       [&](const EvaluatedEntry &each) { return each.outcome->explanation->has(id); }) == 1;
}

/// Adds those lines of an entry that a step shows; false where it shows none.
bool addLines(const EvaluatedEntry &entry, const LessonStep &step, const Evaluation &evaluation,
              Working &working) {
  const std::size_t before = working.lines.size();
  for (const std::string &id : entry.outcome->explanation->ids())
    if (step.lines.empty() || std::any_of(step.lines.begin(), step.lines.end(), [&](const std::string &name) {
          return means(name, entry, id, evaluation);
        }))
      working.add(lineOf(entry, id));
  return working.lines.size() > before;
}

/// Whether the step names the entry, though the present case may not have the lines.
bool names(const LessonStep &step, const EvaluatedEntry &entry) {
  return std::any_of(step.lines.begin(), step.lines.end(),
                     [&](const std::string &name) { return name.starts_with(entry.name + "."); });
}

/// Where the last few constructions begin, of which a step that names no lines shows all.
std::size_t firstShown(const Evaluation &evaluation) {
  std::size_t constructions = 0;
  std::size_t first = evaluation.entries.size();
  while (first > 0 && constructions < mostWorkings)
    constructions += evaluation.entries[--first].isConstruction() ? 1U : 0U;
  return first;
}

/// Leaves of a figure the given marks, those that lines name, and what accompanies them. Who names a
/// coordinate names its object: a line's direction is shown on the line.
void keepNamed(const Working &working, Figure &figure) {
  std::set<std::string> named;
  for (const WorkingLine &line : working.lines)
    for (const std::string &mark : marksIn(line)) {
      named.insert(mark);
      if (const auto dot = mark.rfind('.'); dot != std::string::npos)
        named.insert(mark.substr(0, dot));
    }
  std::erase_if(figure.marks, [&](const Mark &mark) {
    return baseOf(mark).role != Role::Given && !named.contains(leadingId(baseOf(mark)));
  });
}

void addCase(const CaseWords &told, Shown &shown) {
  shown.description += (shown.description.empty() ? "" : " ") + told.description;
  shown.degenerate = shown.degenerate || told.degenerate;
}

} // namespace

std::string withLiveValues(const std::string &markdown, const Scene &scene, const Evaluation &evaluation) {
  std::string filled;
  for (std::string_view rest = markdown; !rest.empty();) {
    const std::size_t verbatim = verbatimLength(rest);
    const auto close = rest.front() == '{' ? rest.substr(0, longestName).find('}') : std::string_view::npos;
    std::size_t taken = std::max<std::size_t>(verbatim, 1);
    if (close != std::string_view::npos && isValueName(rest.substr(1, close - 1))) {
      const std::string value = markdownOf(rest.substr(1, close - 1), scene, evaluation);
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

Shown shownIn(const LessonStep &step, const Evaluation &evaluation, Figure figure) {
  Shown shown;
  const std::size_t first = step.lines.empty() ? firstShown(evaluation) : 0;
  for (std::size_t i = first; i < evaluation.entries.size(); ++i) {
    const EvaluatedEntry &entry = evaluation.entries[i];
    if (!entry.isConstruction())
      continue;
    const bool hasLines = addLines(entry, step, evaluation, shown.working);
    if (hasLines || step.lines.empty() || names(step, entry))
      addCase(*entry.outcome->told, shown);
  }
  if (const EvaluatedEntry *last = evaluation.lastConstruction(); last && shown.description.empty())
    addCase(*last->outcome->told, shown);
  if (!step.lines.empty())
    keepNamed(shown.working, figure);
  shown.figure = std::move(figure);
  return shown;
}

} // namespace halfspace
