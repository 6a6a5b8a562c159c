#include "lessons/lesson/entry_names.h"

#include "lessons/construction/construction.h"
#include "lessons/lesson/condition.h"
#include "lessons/object/kind.h"
#include "lessons/scene/formula_names.h"

#include <algorithm>
#include <map>

namespace halfspace {
namespace {

/// The cases of a construction as a value. What looks at the objects that others make may miss them.
ValueName caseOf(const Construction &construction, const Entry &entry) {
  ValueName cases = named::word("case", construction.names.cases);
  const std::vector<std::string> objects = referencesIn(entry);
  if (std::any_of(objects.begin(), objects.end(), [](const std::string &id) { return id != ownerOf(id); }))
    cases.words.emplace_back("missing-object");
  return cases;
}

/// The values of an object that follows others.
void addCoordinates(const Kind &kind, std::vector<ValueName> &values) {
  for (std::size_t i = 0; i < kind.coordinates.size(); ++i)
    if (const std::string name = valueNameOf(kind, i); !name.empty())
      values.push_back(numbersIn(kind.coordinates[i].role) == 1 ? named::number(name) : named::vector(name));
}

/// Those of the values that can be compared, behind a beginning.
void addComparable(const std::vector<ValueName> &values, const std::string &before,
                   std::vector<OfferedValue> &offered) {
  for (const ValueName &value : values) {
    const std::string name = before + value.name;
    if (value.shape == ValueShape::Group)
      addComparable(value.members, name + ".", offered);
    else if (value.shape != ValueShape::List)
      offered.push_back({name, value});
    else if (value.length == 3)
      for (const char *axis : {".x", ".y", ".z"})
        offered.push_back({name + axis, named::number(name + axis)});
  }
}

} // namespace

EntryNames namesOf(const Entry &entry) {
  EntryNames names{entry.name};
  if (const Kind *kind = kindOf(entry)) {
    if (isBound(entry))
      names.values.push_back(named::vector("at"));
    else if (std::holds_alternative<DerivedObject>(entry.content))
      addCoordinates(*kind, names.values);
    names.marks.push_back(entry.name);
    for (const CoordinateSpec &spec : kind->coordinates)
      if (!spec.name.empty())
        names.marks.push_back(coordinateId(entry.name, spec));
    return names;
  }
  const auto &use = std::get<ConstructionUse>(entry.content);
  const Construction &construction = *findConstruction(use.id);
  names.values = construction.names.values;
  names.values.push_back(caseOf(construction, entry));
  names.lines = construction.names.lines;
  for (const std::string &mark : construction.names.marks)
    names.marks.push_back(entry.name + "." + mark);
  return names;
}

std::optional<ValueName> findValueName(const std::vector<ValueName> &values, std::string_view path) {
  const auto dot = path.find('.');
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const ValueName &each) { return each.name == path.substr(0, dot); });
  if (found == values.end())
    return {};
  if (dot == std::string_view::npos)
    return *found;
  const std::string_view rest = path.substr(dot + 1);
  if (found->shape == ValueShape::Group)
    return findValueName(found->members, rest);
  const auto index = componentIndex(rest);
  if (found->shape != ValueShape::List || !index || *index >= found->length)
    return {};
  return named::number(std::string(path));
}

void addPaths(const std::vector<ValueName> &values, const std::string &before,
              std::vector<std::string> &paths) {
  for (const ValueName &value : values) {
    paths.push_back(before + value.name);
    addPaths(value.members, before + value.name + ".", paths);
  }
}

std::vector<OfferedValue> comparableValues(const Scene &scene) {
  std::vector<std::vector<OfferedValue>> ofEntries;
  std::map<std::string, int> bearers;
  for (const Entry &entry : scene.entries) {
    addComparable(namesOf(entry).values, "", ofEntries.emplace_back());
    for (const OfferedValue &value : ofEntries.back())
      ++bearers[value.name];
  }
  std::vector<OfferedValue> all;
  for (std::size_t place = 0; place < ofEntries.size(); ++place)
    for (OfferedValue &value : ofEntries[place]) {
      if (bearers[value.name] > 1 || scene.entries.find(qualified(value.name).entry))
        value.name = scene.entries[place].name + "." + value.name;
      all.push_back(std::move(value));
    }
  return all;
}

} // namespace halfspace
