#include "lessons/lesson/name_check.h"

#include "lessons/guess.h"
#include "lessons/lesson/condition.h"
#include "lessons/lesson/entry_names.h"
#include "lessons/lesson/lesson_markup.h"
#include "lessons/lesson/lesson_words.h"
#include "lessons/lesson/live_values.h"
#include "lessons/object/kinds/number.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

using Names = std::vector<std::string>;

std::string quotedList(const Names &names) {
  std::string list;
  for (const std::string &name : names)
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::string saysNotWhose(const std::string &name, const std::string &first, const std::string &second) {
  return words("“{name}” can be {first} or {second}: say which.",
               {{"name", name}, {"first", first + "." + name}, {"second", second + "." + name}});
}

bool isNumber(const ValueName &value) {
  return value.shape == ValueShape::Number || value.shape == ValueShape::Index;
}

/// Why a value can never be compared like this; empty where it can.
std::string whyIncomparable(const ValueName &value, const Condition &condition) {
  const bool againstNumber = parseRational(condition.against).has_value();
  switch (value.shape) {
  case ValueShape::Number:
  case ValueShape::Index:
    return againstNumber ? std::string()
                         : words("“{value}” is a number, and never “{against}”.",
                                 {{"value", condition.value}, {"against", condition.against}});
  case ValueShape::List:
    return words("“{value}” has several numbers: name one of them, as {value}.x or {value}.0.",
                 {{"value", condition.value}});
  case ValueShape::Group:
    return words("“{value}” is a group of values: name one of them, as {value}.{first}.",
                 {{"value", condition.value}, {"first", value.members.front().name}});
  case ValueShape::Word:
    break;
  }
  if (std::find(value.words.begin(), value.words.end(), condition.against) != value.words.end())
    return {};
  return withGuess(
      words("“{value}” is never “{against}”. It can be: {words}.",
            {{"value", condition.value}, {"against", condition.against}, {"words", quotedList(value.words)}}),
      condition.against, value.words);
}

/// Goes through a lesson from top to bottom.
class NameCheck {
public:
  explicit NameCheck(const Lesson &lesson) : m_lesson(lesson), m_start(evaluate(lesson.scene)) {
    for (const Entry &entry : lesson.scene.entries)
      m_entries.push_back(namesOf(entry));
  }

  std::vector<Problem> take() {
    for (const LessonStep &step : m_lesson.steps) {
      for (const StepBlock &block : step.blocks)
        std::visit([this](const auto &each) { check(each); }, block);
      for (std::size_t i = 0; i < step.drawn.size(); ++i)
        complain(whyNoMark(step.drawn[i]), step.drawnLines[i], "draw");
      for (std::size_t i = 0; i < step.hidden.size(); ++i)
        complain(whyNotHidden(step.hidden[i]), step.hiddenLines[i], "hide");
    }
    for (const LessonWords &piece : wordsOf(m_lesson))
      for (const MarkdownFormula &formula : piece.text.markdown().formulas)
        for (const MarkdownFormula::Side &side : formula.sides)
          if (side.isLive)
            complain(piece.fillsInValues ? whyNotLive(side.text) : noLiveHere(side.text),
                     piece.lineAt(side.place), piece.field);
    return std::move(m_problems);
  }

private:
  void complain(const std::string &sentence, int line, const std::string &field) {
    if (!sentence.empty())
      m_problems.push_back({sentence, m_lesson.file, line, field});
  }

  void check(const StepWords &) {}
  void check(const StepNote &) {}
  void check(const StepFlight &flight) {
    complain(whyNoNumber(flight.frame), flight.line, "frame");
    complain(whyNoNumber(flight.seed), flight.line, "seed");
    complain(whyNoCrossings(flight.hits), flight.line, "hits");
  }
  void check(const StepFragments &fragments) {
    complain(whyNoCrossings(fragments.hits), fragments.line, "hits");
  }
  void check(const StepCost &cost) { complain(whyNoCrossings(cost.hits), cost.line, "hits"); }
  void check(const StepLines &lines) {
    if (lines.ids == Names{std::string(noLines)})
      return;
    for (std::size_t i = 0; i < lines.ids.size(); ++i)
      complain(whyNoLine(lines.ids[i]), lines.lines[i], "lines");
  }
  void check(const Task &task) {
    for (const Condition &condition : task.conditions)
      complain(whyNever(condition), task.conditionsLine, "when");
  }
  void check(const Prediction &prediction) {
    if (const std::string sentence = whyNoValue(prediction.value); !sentence.empty())
      return complain(sentence, prediction.valueLine, "answer");
    const std::size_t before = m_problems.size();
    for (const Prediction::Choice &choice : prediction.choices)
      if (choice.word != otherwise)
        complain(whyNever({prediction.value, Condition::Relation::Equal, choice.word}), choice.line,
                 "choices");
    if (m_problems.size() == before) // a choice with a slip was perhaps the right one
      complain(whyNoneIsRight(prediction), prediction.valueLine, "answer");
  }

  /// Why no choice is right for the scene as it is at the start; empty where one is.
  [[nodiscard]] std::string whyNoneIsRight(const Prediction &prediction) const {
    if (!rightChoice(prediction, m_start).empty())
      return {};
    const auto value = findValue(m_start, prediction.value);
    if (!value)
      return words("“{value}” has no value at the start: no choice is right there.",
                   {{"value", prediction.value}});
    const auto *word = std::get_if<Word>(&*value);
    return word ? words("At the start “{value}” is “{word}”, but there is no such choice. Add one.",
                        {{"value", prediction.value}, {"word", word->name}})
                : words("At the start “{value}” is none of these choices. Add one for what it is there.",
                        {{"value", prediction.value}});
  }

  [[nodiscard]] std::string whyNoNumber(const std::string &name) const {
    const Object *object = findObject(m_lesson.scene, name);
    return object && kindOf(*object) == NumberObject::kind
               ? std::string()
               : words("“{name}” is no number of the scene.", {{"name", name}});
  }

  [[nodiscard]] std::string whyNoCrossings(const std::string &name) const {
    for (const Entry &entry : m_lesson.scene.entries)
      if (const auto *use = std::get_if<ConstructionUse>(&entry.content);
          use && entry.name == name && findConstruction(use->id)->hasCrossings)
        return {};
    return words("“{name}” is no construction of the scene that looks at many triangles.", {{"name", name}});
  }

  /// The entry of this name, or null.
  [[nodiscard]] const EntryNames *findEntry(std::string_view name) const {
    const auto found = std::ranges::find(m_entries, name, &EntryNames::name);
    return found == m_entries.end() ? nullptr : &*found;
  }

  [[nodiscard]] std::string whyNoLine(const std::string &name) const {
    const auto hasIt = [](const EntryNames &entry, std::string_view id) {
      return std::find(entry.lines.begin(), entry.lines.end(), id) != entry.lines.end();
    };
    const auto [owner, id] = qualified(name);
    if (const EntryNames *entry = findEntry(owner);
        entry && ((id == "*" && !entry->lines.empty()) || hasIt(*entry, id)))
      return {};
    Names bearers;
    Names known;
    for (const EntryNames &entry : m_entries) {
      if (hasIt(entry, name))
        bearers.push_back(entry.name);
      for (const std::string &line : entry.lines) {
        known.push_back(line);
        known.push_back(entry.name + "." + line);
      }
    }
    return whyNotOne(words("There is no worked line “{name}”.", {{"name", name}}), name, bearers, known);
  }

  /// Marks go by their ids, or by what follows the first dot of one alone.
  [[nodiscard]] std::string whyNoMark(const std::string &name) const {
    Names bearers;
    Names known;
    for (const EntryNames &entry : m_entries)
      for (const std::string &mark : entry.marks) {
        if (mark == name)
          return {};
        const std::string own(qualified(mark).own);
        if (own == name)
          bearers.push_back(entry.name);
        known.push_back(own);
        known.push_back(mark);
      }
    return whyNotOne(words("There is no mark “{name}”.", {{"name", name}}), name, bearers, known);
  }

  /// Entries are hidden as a whole.
  [[nodiscard]] std::string whyNotHidden(const std::string &name) const {
    if (const Entry *entry = m_lesson.scene.entries.find(name))
      return isDrawn(*entry) ? std::string()
                             : words("“{name}” is a number: it is in no picture.", {{"name", name}});
    Names known;
    for (const EntryNames &entry : m_entries)
      known.push_back(entry.name);
    return withGuess(words("There is no entry “{name}” in the scene.", {{"name", shortened(name)}}), name,
                     known);
  }

  /// Why a name does not mean one thing alone; empty where it does.
  [[nodiscard]] static std::string whyNotOne(const std::string &sentence, const std::string &name,
                                             const Names &bearers, const Names &known) {
    if (bearers.size() > 1)
      return saysNotWhose(name, bearers[0], bearers[1]);
    if (!bearers.empty())
      return {};
    // Perhaps it is another entry's: d.F where only distance has an F.
    const std::string own(qualified(name).own);
    const bool isAnothers = nearestOf(name, known).empty() && std::ranges::find(known, own) != known.end();
    return withGuess(sentence, isAnothers ? own : name, known);
  }

  /// What a name means; or why it means no value, a sentence.
  struct Meant {
    std::optional<ValueName> value{};
    std::string whyNone{};
  };

  /// `d.f, d.side, d.signed_distance`
  [[nodiscard]] static std::string pathsIn(const EntryNames &entry) {
    std::string paths;
    for (const ValueName &value : entry.values)
      paths += (paths.empty() ? "" : ", ") + entry.name + "." + value.name;
    return paths;
  }

  [[nodiscard]] Meant valueOf(const std::string &name) const {
    const auto [owner, path] = qualified(name);
    if (const EntryNames *entry = findEntry(owner))
      if (auto value = findValueName(entry->values, path))
        return {std::move(value)};
    Names bearers;
    Names known;
    Meant meant;
    for (const EntryNames &entry : m_entries) {
      addPaths(entry.values, "", known);
      addPaths(entry.values, entry.name + ".", known);
      if (auto value = findValueName(entry.values, name)) {
        meant.value = std::move(value);
        bearers.push_back(entry.name);
      }
    }
    if (const EntryNames *entry = findEntry(name); entry && bearers.empty() && !entry->values.empty())
      meant.whyNone = words("“{name}” has several values: write one of {values}.",
                            {{"name", name}, {"values", pathsIn(*entry)}});
    else if (name != "case") // that of the last construction
      meant.whyNone = whyNotOne(words("There is no value “{name}”.", {{"name", name}}), name, bearers, known);
    return meant;
  }

  [[nodiscard]] std::string whyNoValue(const std::string &name) const { return valueOf(name).whyNone; }

  [[nodiscard]] std::string whyNever(const Condition &condition) const {
    const Meant meant = valueOf(condition.value);
    if (!meant.whyNone.empty())
      return meant.whyNone;
    if (!meant.value)
      return words("No construction of this scene has a case.");
    if (isNumber(*meant.value) && valueOf(condition.against).value)
      return words(
          "“{against}” is a value too, and two values are not compared: compare “{value}” with a number.",
          {{"against", condition.against}, {"value", condition.value}});
    return whyIncomparable(*meant.value, condition);
  }

  static std::string noLiveHere(const std::string &name) {
    return words("No live value is filled in here: {{name}} would stand as it is.", {{"name", name}});
  }

  [[nodiscard]] std::string whyNotLive(const std::string &name) const {
    if (findCoordinate(m_lesson.scene, name) || findValue(m_start, name) || valueMade(name, m_start))
      return {};
    const std::string sentence = whyNoValue(name);
    return !sentence.empty()
               ? sentence
               : words("“{name}” has no value at the start: a dash would stand here.", {{"name", name}});
  }

  const Lesson &m_lesson;
  Evaluation m_start;
  std::vector<EntryNames> m_entries;
  std::vector<Problem> m_problems;
};

} // namespace

std::vector<Problem> problemsWithNames(const Lesson &lesson) { return NameCheck(lesson).take(); }

} // namespace halfspace
