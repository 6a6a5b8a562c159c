#include "lessons/scene/scene_reader.h"

#include "lessons/construction/construction.h"
#include "lessons/scene/session_file.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

std::string indexed(const std::string &path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

/// Reads [x, y, z].
void readVector(const DocumentNode &node, const std::string &path, FieldReader &fields, ExactVec3 &vector) {
  if (node.kind != DocumentNode::Kind::List || node.children.size() != 3)
    return fields.complain(node, path, words("Here three numbers are expected, as [1, 2, 3]."));
  for (int i = 0; i < 3; ++i) {
    const DocumentNode &number = node.children[static_cast<std::size_t>(i)];
    if (!number.spellsNumber())
      return fields.complain(number, path, words("Here a number is expected, not a list or a map."));
    const auto value = readCoordinate(number.text);
    if (!value)
      return fields.complain(number, path, value.problem().sentence);
    vector[i] = *value;
  }
}

/// Reads an object's coordinates: of a point its three numbers, else a map by the coordinates' names.
void readObject(const DocumentNode &node, const std::string &path, FieldReader &entry, Object &object) {
  const auto &specs = coordinatesOf(object);
  if (specs.front().name.empty())
    return readVector(node, path, entry, coordinate(object, 0));
  FieldReader fields(node, entry.file(), path);
  for (std::size_t index = 0; index < specs.size(); ++index)
    if (const DocumentNode *vector = fields.required(specs[index].name))
      readVector(*vector, fields.pathOf(specs[index].name), fields, coordinate(object, index));
  for (const DocumentNode &child : node.children)
    if (std::none_of(specs.begin(), specs.end(),
                     [&](const CoordinateSpec &spec) { return spec.name == child.key; }))
      fields.complain(child, fields.pathOf(shortened(child.key)),
                      words("A {kind} has no such coordinate. Remove it or mend its name.",
                            {{"kind", std::string(kindOf(object))}}));
  if (fields.problem())
    entry.keep(*fields.problem());
}

ConstructionUse readUse(FieldReader &fields) {
  fields.allowOnly({"name", "construction", "of"});
  ConstructionUse use;
  use.id = fields.text("construction");
  const DocumentNode *roles = fields.required("of");
  if (!roles)
    return use;
  if (roles->kind != DocumentNode::Kind::Map)
    fields.complain(*roles, fields.pathOf("of"),
                    words("Here names of objects are expected, as {E: E, Q: Q}."));
  for (const DocumentNode &role : roles->children)
    if (role.kind == DocumentNode::Kind::Text)
      use.roles[role.key] = role.text;
    else
      fields.complain(role, fields.pathOf("of." + role.key),
                      words("Here the name of an object is expected."));
  return use;
}

/// Reads one entry into `fields`' problem or an entry.
Entry readEntry(const DocumentNode &node, FieldReader &fields) {
  Entry entry;
  entry.name = fields.text("name");
  if (fields.optional("construction")) {
    entry.content = readUse(fields);
    return entry;
  }
  for (const std::string_view kind : objectKinds())
    if (const DocumentNode *coordinates = fields.optional(kind)) {
      fields.allowOnly({"name", kind});
      Object object = *makeObject(kind);
      readObject(*coordinates, fields.pathOf(kind), fields, object);
      entry.content = object;
      return entry;
    }
  std::string kinds;
  for (const std::string_view kind : objectKinds())
    kinds += std::string(kind) + ", ";
  fields.complain(node, fields.pathOf(""),
                  words("It does not say what it is: one of {kinds}construction.", {{"kinds", kinds}}));
  return entry;
}

bool isNameCharacter(char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; }

std::optional<Problem> checkName(const Scene &scene, std::size_t index) {
  const std::string &name = scene.entries[index].name;
  if (name.empty() || name.size() > maxNameLength || !isLetter(name.front()) ||
      !std::all_of(name.begin(), name.end(), isNameCharacter))
    return Problem{
        words("“{name}” cannot be a name: names are at most {limit} letters A–Z, digits, - and _, and begin "
              "with a letter.",
              {{"name", shortened(name)}, {"limit", std::to_string(maxNameLength)}}),
        "", 0, "name"};
  const auto here = scene.entries.begin() + static_cast<std::ptrdiff_t>(index);
  if (std::any_of(scene.entries.begin(), here, [&](const Entry &above) { return above.name == name; }))
    return Problem{
        words("The name “{name}” is taken by an entry above. Every name may stand once.", {{"name", name}}),
        "", 0, "name"};
  return {};
}

std::optional<Problem> checkObject(const Object &object) {
  for (std::size_t index = 0; index < coordinatesOf(object).size(); ++index)
    for (int i = 0; i < 3; ++i)
      if (const auto refused = refuseCoordinate(coordinate(object, index)[i]))
        return Problem{*refused, "", 0, std::string(coordinatesOf(object)[index].name)};
  return {};
}

/// The object above the entry that goes by this name, or null.
const Object *objectAbove(const Scene &scene, std::size_t index, std::string_view name) {
  for (std::size_t i = 0; i < index; ++i)
    if (scene.entries[i].name == name)
      return std::get_if<Object>(&scene.entries[i].content);
  return nullptr;
}

std::optional<Problem> checkUse(const Scene &scene, std::size_t index, const ConstructionUse &use) {
  const Construction *construction = findConstruction(use.id);
  if (!construction)
    return Problem{
        words("There is no construction “{id}”. Mend the name, or use a newer version of Halfspace.",
              {{"id", shortened(use.id)}}),
        "", 0, "construction"};
  for (const ConstructionRole &role : construction->roles) {
    const std::string field = "of." + role.name;
    const auto bound = use.roles.find(role.name);
    if (bound == use.roles.end())
      return Problem{words("This construction looks at a {kind} {role}: name one.",
                           {{"kind", std::string(role.kind)}, {"role", role.name}}),
                     "", 0, field};
    const Object *object = objectAbove(scene, index, bound->second);
    if (!object)
      return Problem{
          words("Above this entry there is no object “{name}”.", {{"name", shortened(bound->second)}}), "", 0,
          field};
    if (kindOf(*object) != role.kind)
      return Problem{words("Here a {kind} is expected, but “{name}” is a {other}.",
                           {{"kind", std::string(role.kind)},
                            {"name", bound->second},
                            {"other", std::string(kindOf(*object))}}),
                     "", 0, field};
  }
  for (const auto &[role, name] : use.roles)
    if (std::none_of(construction->roles.begin(), construction->roles.end(),
                     [&role = role](const ConstructionRole &known) { return known.name == role; }))
      return Problem{
          words("This construction looks at nothing by the name “{role}”.", {{"role", shortened(role)}}), "",
          0, "of." + shortened(role)};
  return {};
}

/// What is wrong with an entry; the field is counted from the entry.
std::optional<Problem> checkEntry(const Scene &scene, std::size_t index) {
  if (auto problem = checkName(scene, index))
    return problem;
  const Entry &entry = scene.entries[index];
  if (const auto *object = std::get_if<Object>(&entry.content))
    return checkObject(*object);
  return checkUse(scene, index, std::get<ConstructionUse>(entry.content));
}

std::optional<Problem> checkCount(std::size_t count) {
  if (count <= maxSceneEntries)
    return {};
  return Problem{words("The scene is too large: at most {limit} entries are read.",
                       {{"limit", std::to_string(maxSceneEntries)}}),
                 "", 0, "scene"};
}

} // namespace

std::string sentenceForNotRead(std::string_view text) {
  switch (whyNotRead(text)) {
  case NotRead::TooLarge:
    return sentenceForTooLarge();
  case NotRead::TooLong:
    return sentenceForTooLong();
  case NotRead::NoNumber:
    break;
  }
  return words("“{text}” is not a number: write it as 3, -1.5 or -10/3.", {{"text", shortened(text)}});
}

Result<Rational> readCoordinate(std::string_view text) {
  const auto value = parseRational(text);
  if (!value)
    return Problem{sentenceForNotRead(text), "", 0, ""};
  if (const auto refused = refuseCoordinate(*value))
    return Problem{*refused, "", 0, ""};
  return *value;
}

Result<Scene> readScene(const DocumentNode &list, const std::string &file, const std::string &path) {
  if (list.kind != DocumentNode::Kind::List)
    return Problem{words("Here a list of objects and constructions is expected."), file, list.line, path};
  if (auto problem = checkCount(list.children.size())) {
    problem->file = file;
    problem->line = list.line;
    return *problem;
  }
  Scene scene;
  for (std::size_t index = 0; index < list.children.size(); ++index) {
    const DocumentNode &node = list.children[index];
    FieldReader fields(node, file, indexed(path, index));
    scene.entries.push_back(readEntry(node, fields));
    if (const auto problem = fields.problem() ? std::nullopt : checkEntry(scene, index))
      fields.complain(node, fields.pathOf(problem->field), problem->sentence);
    if (fields.problem())
      return *fields.problem();
  }
  return scene;
}

} // namespace halfspace
