#include "lessons/lesson/shown.h"

#include <algorithm>
#include <map>
#include <set>

namespace halfspace {
namespace {

using Names = std::vector<std::string>;

/// Whether one of the names means what an entry has under this id: a line, a mark.
bool name(const Names &names, const EvaluatedEntry &entry, const std::string &id, bool onlyOneHasIt) {
  return std::any_of(names.begin(), names.end(), [&](const std::string &name) {
    return name == entry.name + ".*" || name == entry.name + "." + id || (name == id && onlyOneHasIt);
  });
}

bool isLineOfOne(const std::string &id, const Evaluation &evaluation) {
  return std::count_if(evaluation.entries.begin(), evaluation.entries.end(),
                       [&](const EvaluatedEntry &each) { return each.outcome->explanation->has(id); }) == 1;
}

/// Where the last few constructions begin, of which a step that names no lines shows all.
std::size_t firstShown(const Evaluation &evaluation) {
  std::size_t constructions = 0;
  std::size_t first = evaluation.entries.size();
  while (first > 0 && constructions < mostWorkings)
    constructions += evaluation.entries[--first].isConstruction() ? 1U : 0U;
  return first;
}

/// Adds the lines that these ids name, or all, as far as they are not there already.
void addLines(const StepLines &lines, const Evaluation &evaluation, Working &working) {
  const std::size_t first = lines.ids.empty() ? firstShown(evaluation) : 0;
  for (std::size_t i = first; i < evaluation.entries.size(); ++i) {
    const EvaluatedEntry &entry = evaluation.entries[i];
    if (!entry.isConstruction())
      continue;
    for (const std::string &id : entry.outcome->explanation->ids())
      if ((lines.ids.empty() || name(lines.ids, entry, id, isLineOfOne(id, evaluation))) &&
          !findLine(working, entry.name + "." + id))
        working.add(lineOf(entry, id));
  }
}

/// All line ids of a step; empty where it shows every line.
Names lineNamesOf(const LessonStep &step) {
  Names names;
  for (const StepBlock &block : step.blocks)
    if (const auto *lines = std::get_if<StepLines>(&block))
      names.insert(names.end(), lines->ids.begin(), lines->ids.end());
  return names;
}

/// Whether the step speaks of the entry, though the present case may not have its lines.
bool speaksOf(const EvaluatedEntry &entry, const Names &lines, const Working &working) {
  return lines.empty() ||
         std::any_of(working.lines.begin(), working.lines.end(),
                     [&](const WorkingLine &line) { return entryOf(line.id) == entry.name; }) ||
         std::any_of(lines.begin(), lines.end(),
                     [&](const std::string &name) { return name.starts_with(entry.name + "."); });
}

/// The marks that lines name. Who names a coordinate names its object: a line's direction is shown on the
/// line.
std::set<std::string> marksNamedIn(const Working &working) {
  std::set<std::string> named;
  for (const WorkingLine &line : working.lines)
    for (const std::string &mark : marksIn(line)) {
      named.insert(mark);
      if (const auto dot = mark.rfind('.'); dot != std::string::npos)
        named.insert(mark.substr(0, dot));
    }
  return named;
}

/// The id that a mark has within its entry: F of `distance.F`.
std::string_view ownId(std::string_view mark) { return mark.substr(mark.find('.') + 1); }

/// The marks that a step draws by name: `distance.F`, or F where only one entry has it.
std::set<std::string> marksDrawn(const Names &drawn, const Figure &figure) {
  std::set<std::string> marks;
  for (const Mark &mark : figure.marks)
    marks.insert(leadingId(baseOf(mark)));
  std::map<std::string_view, std::vector<std::string>> byOwnId;
  for (const std::string &mark : marks)
    byOwnId[ownId(mark)].push_back(mark);
  std::set<std::string> found;
  for (const std::string &name : drawn)
    if (marks.contains(name))
      found.insert(name);
    else if (const auto bearers = byOwnId.find(name); bearers != byOwnId.end() && bearers->second.size() == 1)
      found.insert(bearers->second.front());
  return found;
}

/// Leaves of a figure the given marks, those that are named, and what accompanies them.
void keepNamed(const std::set<std::string> &named, Figure &figure) {
  std::erase_if(figure.marks, [&](const Mark &mark) {
    return baseOf(mark).role != Role::Given && !named.contains(leadingId(baseOf(mark)));
  });
}

/// Where a ray's thin line ends would tell what it meets.
void letRaysRunOn(Figure &figure) {
  for (Mark &mark : figure.marks)
    if (auto *ray = std::get_if<RayMark>(&mark))
      ray->meets.reset();
}

void addCase(const CaseWords &told, Shown &shown) {
  shown.description += (shown.description.empty() ? "" : " ") + told.description;
  shown.degenerate = shown.degenerate || told.degenerate;
}

} // namespace

Shown shownIn(const LessonStep &step, const Evaluation &evaluation, Figure figure, Question question) {
  Shown shown;
  for (const StepBlock &block : step.blocks)
    if (const auto *lines = std::get_if<StepLines>(&block)) {
      const std::size_t before = shown.working.lines.size();
      addLines(*lines, evaluation, shown.working);
      shown.linesIn.push_back(shown.working.lines.size() - before);
    }
  const Names lines = lineNamesOf(step);
  for (std::size_t i = lines.empty() ? firstShown(evaluation) : 0; i < evaluation.entries.size(); ++i) {
    const EvaluatedEntry &entry = evaluation.entries[i];
    if (entry.isConstruction() && speaksOf(entry, lines, shown.working))
      addCase(*entry.outcome->told, shown);
  }
  if (const EvaluatedEntry *last = evaluation.lastConstruction(); last && shown.description.empty())
    addCase(*last->outcome->told, shown);
  if (question == Question::Open) {
    keepNamed({}, figure);
    letRaysRunOn(figure);
  } else if (!lines.empty()) {
    std::set<std::string> named = marksNamedIn(shown.working);
    named.merge(marksDrawn(step.drawn, figure));
    keepNamed(named, figure);
  }
  shown.figure = std::move(figure);
  return shown;
}

} // namespace halfspace
