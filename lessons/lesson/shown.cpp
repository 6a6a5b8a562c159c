#include "lessons/lesson/shown.h"

#include <set>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace halfspace {
namespace {

using Names = std::vector<std::string>;

/// The lines that some names mean: all of an entry, `distance.*`, one of them, `distance.f`, or f where one
/// entry alone has it.
class NamedLines {
public:
  NamedLines(const Names &names, const Evaluation &evaluation) : m_names(names.begin(), names.end()) {
    for (const std::string &name : names)
      if (std::string entry = entryOf(name); !entry.empty())
        m_entries.insert(std::move(entry));
      else
        m_bearers.emplace(name, Bearers());
    if (!m_bearers.empty())
      findBearers(evaluation);
  }

  [[nodiscard]] Names idsIn(const EvaluatedEntry &entry) const {
    Names ids;
    if (!m_entries.contains(entry.name))
      return ids;
    const bool areAllNamed = m_names.contains(entry.name + ".*");
    for (const std::string &id : entry.outcome->explanation->ids())
      if (areAllNamed || m_names.contains(entry.name + "." + id) || isOnlyBearer(entry, id))
        ids.push_back(id);
    return ids;
  }

private:
  /// The entries that have a line with some id.
  struct Bearers {
    const EvaluatedEntry *first = nullptr;
    std::size_t count = 0;
  };

  void findBearers(const Evaluation &evaluation) {
    for (const EvaluatedEntry &entry : evaluation.entries)
      for (const std::string &id : entry.outcome->explanation->ids())
        if (const auto found = m_bearers.find(id); found != m_bearers.end() && found->second.count++ == 0)
          found->second.first = &entry;
    for (const auto &[id, bearers] : m_bearers)
      if (bearers.count == 1)
        m_entries.insert(bearers.first->name);
  }

  [[nodiscard]] bool isOnlyBearer(const EvaluatedEntry &entry, const std::string &id) const {
    const auto found = m_bearers.find(id);
    return found != m_bearers.end() && found->second.count == 1 && found->second.first == &entry;
  }

  std::unordered_set<std::string> m_names;
  std::unordered_set<std::string> m_entries;          ///< those of which a line is meant
  std::unordered_map<std::string, Bearers> m_bearers; ///< by the ids that stand without an entry
};

/// Where the last few constructions begin, of which a step that names no lines shows all.
std::size_t firstShown(const Evaluation &evaluation) {
  std::size_t constructions = 0;
  std::size_t first = evaluation.entries.size();
  while (first > 0 && constructions < mostWorkings)
    constructions += evaluation.entries[--first].isConstruction() ? 1U : 0U;
  return first;
}

/// Adds the lines that these ids name, or all, as far as they are not there already.
void addLines(const StepLines &lines, const Evaluation &evaluation, Working &working,
              std::unordered_set<std::string> &added) {
  const NamedLines named(lines.ids, evaluation);
  for (std::size_t i = lines.ids.empty() ? firstShown(evaluation) : 0; i < evaluation.entries.size(); ++i) {
    const EvaluatedEntry &entry = evaluation.entries[i];
    if (!entry.isConstruction())
      continue;
    for (const std::string &id : lines.ids.empty() ? entry.outcome->explanation->ids() : named.idsIn(entry))
      if (added.insert(entry.name + "." + id).second)
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

/// The entries that a step speaks of by these names of lines, though the present case may not have their
/// lines, and those whose lines it shows.
std::unordered_set<std::string> entriesSpokenOf(const Names &lines, const Working &working) {
  std::unordered_set<std::string> entries;
  for (const std::string &name : lines)
    entries.insert(entryOf(name));
  for (const WorkingLine &line : working.lines)
    entries.insert(entryOf(line.id));
  return entries;
}

using Marks = std::set<std::string, std::less<>>;

/// The marks that lines name. Who names a coordinate names its object: a line's direction is shown on the
/// line.
Marks marksNamedIn(const Working &working) {
  Marks named;
  for (const WorkingLine &line : working.lines)
    for (const std::string &mark : marksIn(line)) {
      named.insert(mark);
      if (const auto dot = mark.rfind('.'); dot != std::string::npos)
        named.insert(mark.substr(0, dot));
    }
  return named;
}

/// The marks that a step draws by name: `distance.F`, or F where only one entry has it.
Marks marksDrawn(const Names &drawn, const Figure &figure) {
  std::unordered_map<std::string_view, std::set<std::string_view>> bearers;
  for (const std::string &name : drawn)
    bearers.emplace(name, std::set<std::string_view>());
  Marks found;
  for (std::size_t place = 0; place < figure.marks.size() && !drawn.empty(); ++place) {
    const std::string_view mark = leadingId(baseOf(figure.marks[place]));
    if (bearers.contains(mark))
      found.emplace(mark);
    else if (const auto known = bearers.find(qualified(mark).own); known != bearers.end())
      known->second.insert(mark);
  }
  for (const auto &[name, marks] : bearers)
    if (!found.contains(name) && marks.size() == 1)
      found.emplace(*marks.begin());
  return found;
}

/// Leaves of a figure the given marks, those that are named, and what accompanies them.
void keepNamed(const Marks &named, Figure &figure) {
  figure.marks.eraseIf([&](const Mark &mark) {
    return baseOf(mark).role != Role::Given && !named.contains(leadingId(baseOf(mark)));
  });
}

/// Leaves of a figure the given marks, the results, and all of these entries.
void keepResults(const std::unordered_set<std::string> &entries, Figure &figure) {
  figure.marks.eraseIf([&](const Mark &mark) {
    const MarkBase &base = baseOf(mark);
    return base.role != Role::Given && base.role != Role::Result &&
           !entries.contains(std::string(entryOfMark(base.id)));
  });
}

/// Takes away what a step hides: the marks of entries, with what accompanies them.
void hide(const Names &entries, Figure &figure) {
  if (entries.empty())
    return;
  const std::set<std::string, std::less<>> hidden(entries.begin(), entries.end());
  figure.marks.eraseIf([&](const Mark &mark) { return hidden.contains(entryOfMark(baseOf(mark).id)); });
}

/// Where a ray's thin line ends would tell what it meets.
void letRaysRunOn(Figure &figure) {
  for (std::size_t place = 0; place < figure.marks.size(); ++place)
    if (const auto *ray = std::get_if<RayMark>(&figure.marks[place]); ray && ray->meets)
      figure.marks.change(place, [](Mark &mark) { std::get<RayMark>(mark).meets.reset(); });
}

void addCase(const CaseWords &told, Shown &shown) {
  shown.description += (shown.description.empty() || told.description.empty() ? "" : " ") + told.description;
  shown.degenerate = shown.degenerate || told.degenerate;
}

} // namespace

LinesOfStep linesOfStep(const LessonStep &step, const Evaluation &evaluation) {
  LinesOfStep shown;
  std::unordered_set<std::string> added;
  for (const StepBlock &block : step.blocks)
    if (const auto *lines = std::get_if<StepLines>(&block)) {
      const std::size_t before = shown.working.lines.size();
      addLines(*lines, evaluation, shown.working, added);
      shown.linesIn.push_back(shown.working.lines.size() - before);
    }
  return shown;
}

Shown shownIn(const LessonStep &step, const Evaluation &evaluation, Figure figure, Question question) {
  Shown shown{linesOfStep(step, evaluation), {}, {}};
  const Names lines = lineNamesOf(step);
  const std::unordered_set<std::string> spokenOf = entriesSpokenOf(lines, shown.working);
  for (std::size_t i = lines.empty() ? firstShown(evaluation) : 0; i < evaluation.entries.size(); ++i) {
    const EvaluatedEntry &entry = evaluation.entries[i];
    if (spokenOf.contains(entry.name) || (lines.empty() && entry.isConstruction()))
      addCase(*entry.outcome->told, shown);
  }
  const EvaluatedEntry *last = evaluation.lastConstruction();
  if (last && shown.description.empty() && !step.drawsAllResults)
    addCase(*last->outcome->told, shown);
  if (question == Question::Open) {
    keepNamed({}, figure);
    letRaysRunOn(figure);
  } else if (step.drawsAllResults) {
    keepResults(spokenOf, figure);
  } else if (!lines.empty()) {
    Marks named = marksNamedIn(shown.working);
    named.merge(marksDrawn(step.drawn, figure));
    keepNamed(named, figure);
  }
  hide(step.hidden, figure);
  shown.figure = std::move(figure);
  return shown;
}

} // namespace halfspace
