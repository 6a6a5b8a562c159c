#include "lessons/scene/file/scene_reader.h"

#include "lessons/formula/read_formula.h"
#include "lessons/guess.h"
#include "lessons/object/kind.h"
#include "lessons/reading/typed_number.h"
#include "lessons/scene/file/shape_text.h"
#include "lessons/scene/scene_checker.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

std::string indexed(const std::string &path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

void readNumber(const DocumentNode &node, const std::string &path, FieldReader &fields, Rational &number) {
  if (!node.spellsNumber())
    return fields.complain(node, path, words("Here a number is expected, not a list or a map."));
  const auto value = readCoordinate(node.text);
  if (!value)
    return fields.complain(node, path, value.problem().sentence);
  number = *value;
}

/// Reads [x, y, z], or a single number.
void readCoordinate(const DocumentNode &node, const std::string &path, FieldReader &fields,
                    CoordinateRole role, ExactVec3 &coordinate) {
  if (numbersIn(role) == 1)
    return readNumber(node, path, fields, coordinate.x);
  if (node.kind != DocumentNode::Kind::List || node.children.size() != 3)
    return fields.complain(node, path, words("Here three numbers are expected, as [1, 2, 3]."));
  for (int i = 0; i < 3; ++i)
    readNumber(node.children[static_cast<std::size_t>(i)], path, fields, coordinate[i]);
}

/// Makes room for the vertices that are written down.
void addVertices(const DocumentNode &node, Object &object) {
  const auto &all = object.kind().coordinates;
  while (object.size() < all.size() && node.find(all[object.size()].name))
    object.addVertex();
}

/// Reads what a mesh is made of.
void readShapeOf(Object &object, FieldReader &fields) {
  const DocumentNode *corners = fields.required(cornersField);
  const DocumentNode *faces = fields.required(facesField);
  if (!corners || !faces)
    return;
  for (const DocumentNode *node : {corners, faces})
    if (node->kind != DocumentNode::Kind::Text)
      return fields.complain(*node, fields.pathOf(node->key),
                             words("Here a text is expected, in quotes where the file is JSON."));
  auto shape = readShape(corners->text, faces->text);
  if (shape)
    return object.setShape(std::move(*shape));
  const Problem &problem = shape.problem();
  fields.complain(problem.field == facesField ? *faces : *corners, fields.pathOf(problem.field),
                  problem.sentence);
}

void complainOfCoordinate(const DocumentNode &node, const Kind &kind, FieldReader &fields) {
  fields.complain(node, fields.pathOf(shortened(node.key)),
                  words("This is {kind}: it has no such coordinate. Remove it or mend its name.",
                        {{"kind", kind.noun()}}));
}

/// Whether a coordinate is written as a formula: a text that is no number, where numbers stand in lists.
bool isFormula(const DocumentNode &node, CoordinateRole role) {
  return node.kind == DocumentNode::Kind::Text &&
         (numbersIn(role) == 3 || !halfspace::readCoordinate(node.text));
}

/// Whether some coordinate of an object follows others.
bool followsOthers(const DocumentNode &node, const Kind &kind) {
  if (kind.binding || kind.shape)
    return false;
  if (node.kind == DocumentNode::Kind::Text)
    return kind.coordinates.front().goesByObject();
  return std::any_of(kind.coordinates.begin(), kind.coordinates.end(), [&](const CoordinateSpec &spec) {
    const DocumentNode *written = spec.name.empty() ? nullptr : node.find(spec.name);
    return written && isFormula(*written, spec.role);
  });
}

/// Reads a formula, or numbers, which are one too.
Formula readFormula(const DocumentNode &node, const std::string &path, FieldReader &fields,
                    CoordinateRole role, const IsName &isName) {
  if (node.kind != DocumentNode::Kind::Text) {
    ExactVec3 numbers(0);
    readCoordinate(node, path, fields, role, numbers);
    return formulaOf(numbers);
  }
  auto formula = halfspace::readFormula(node.text, '.', isName);
  if (const auto *fault = std::get_if<FormulaFault>(&formula)) {
    fields.complain(node, path,
                    words("{sentence} (at character {column})",
                          {{"sentence", fault->sentence}, {"column", std::to_string(fault->at + 1)}}));
    return {};
  }
  return std::get<Formula>(std::move(formula));
}

DerivedObject readDerived(const DocumentNode &node, const std::string &path, FieldReader &entry,
                          const Kind &kind, const IsName &isName) {
  DerivedObject derived{&kind, {}};
  if (node.kind == DocumentNode::Kind::Text) {
    derived.coordinates.push_back(readFormula(node, path, entry, kind.coordinates.front().role, isName));
    return derived;
  }
  FieldReader fields(node, entry.file(), path);
  std::vector<std::string_view> names;
  for (std::size_t index = 0; index < kind.coordinates.size(); ++index) {
    const CoordinateSpec &spec = kind.coordinates[index];
    names.push_back(spec.name);
    if (index >= kind.fewestCoordinates() && !node.find(spec.name))
      break;
    if (const DocumentNode *written = fields.required(spec.name))
      derived.coordinates.push_back(
          readFormula(*written, fields.pathOf(spec.name), fields, spec.role, isName));
  }
  for (const DocumentNode &child : node.children)
    if (std::find(names.begin(), names.end(), child.key) == names.end())
      complainOfCoordinate(child, kind, fields);
  if (fields.problem())
    entry.keep(*fields.problem());
  return derived;
}

/// Whether a field of an object is not one of its coordinates.
bool isBesideCoordinates(const Object &object, std::string_view field) {
  return (object.kind().binding && field == hostRole) ||
         (object.shape() && (field == cornersField || field == facesField));
}

/// Reads an object's coordinates: of a point its three numbers, else a map by the coordinates' names, and of
/// a bound one what it lies on.
void readObject(const DocumentNode &node, const std::string &path, FieldReader &entry, Object &object,
                std::string &on) {
  addVertices(node, object);
  const auto specs = coordinatesOf(object);
  if (specs.front().name.empty())
    return readCoordinate(node, path, entry, specs.front().role, coordinate(object, 0));
  FieldReader fields(node, entry.file(), path);
  if (object.kind().binding)
    on = fields.text(hostRole);
  if (object.shape())
    readShapeOf(object, fields);
  for (std::size_t index = 0; index < specs.size(); ++index)
    if (const DocumentNode *written = fields.required(specs[index].name))
      readCoordinate(*written, fields.pathOf(specs[index].name), fields, specs[index].role,
                     coordinate(object, index));
  for (const DocumentNode &child : node.children)
    if (!isBesideCoordinates(object, child.key) &&
        std::none_of(specs.begin(), specs.end(),
                     [&](const CoordinateSpec &spec) { return spec.name == child.key; }))
      complainOfCoordinate(child, object.kind(), fields);
  if (fields.problem())
    entry.keep(*fields.problem());
}

/// Reads the name of an object, or a list of names.
RoleObjects readRole(const DocumentNode &role, FieldReader &fields) {
  const auto read = [&](const DocumentNode &name, const std::string &path) {
    if (name.kind != DocumentNode::Kind::Text)
      fields.complain(name, path, words("Here the name of an object is expected."));
    return name.text;
  };
  const std::string path = fields.pathOf("of." + role.key);
  if (role.kind != DocumentNode::Kind::List)
    return read(role, path);
  std::vector<std::string> names;
  for (std::size_t index = 0; index < role.children.size(); ++index)
    names.push_back(read(role.children[index], indexed(path, index)));
  return names;
}

ConstructionUse readUse(FieldReader &fields) {
  fields.allowOnly({"name", "construction", "of", colorField, strokeField, labelField, hiddenField});
  ConstructionUse use;
  use.id = fields.text("construction");
  const DocumentNode *roles = fields.required("of");
  if (!roles)
    return use;
  if (roles->kind != DocumentNode::Kind::Map)
    fields.complain(*roles, fields.pathOf("of"),
                    words("Here names of objects are expected, as {E: E, Q: Q}."));
  for (const DocumentNode &role : roles->children)
    use.roles[role.key] = readRole(role, fields);
  return use;
}

/// Complains of an entry that says neither a kind nor a construction.
void complainOfKind(const DocumentNode &node, FieldReader &fields) {
  std::vector<std::string> known;
  std::string list;
  for (const Kind &kind : kinds()) {
    known.emplace_back(kind.word);
    list += known.back() + ", ";
  }
  known.emplace_back("construction");
  std::string sentence =
      words("It does not say what it is: one of {known}.", {{"known", list + known.back()}});
  for (const DocumentNode &field : node.children)
    if (field.key != "name")
      sentence = withGuess(sentence, field.key, known);
  fields.complain(node, fields.pathOf(""), sentence);
}

/// Reads one of several names, which `find` knows; nothing where the field is not there.
template <class Named>
std::optional<Named> readOneOf(FieldReader &fields, const char *field,
                               std::optional<Named> (*find)(std::string_view),
                               const std::vector<std::string> &known) {
  const DocumentNode *node = fields.optional(field);
  if (!node)
    return {};
  const auto named = node->kind == DocumentNode::Kind::Text ? find(node->text) : std::nullopt;
  if (!named) {
    std::string list;
    for (const std::string &name : known)
      list += (list.empty() ? "" : ", ") + name;
    fields.complain(*node, fields.pathOf(field),
                    withGuess(words("“{text}” is none of these: {known}.",
                                    {{"text", shortened(node->text)}, {"known", list}}),
                              node->text, known));
  }
  return named;
}

/// Reads how the entry is drawn; a construction has no hand that moves it.
void readLook(FieldReader &fields, Entry &entry) {
  entry.color = readOneOf<Hue>(fields, colorField, findHue, hueNames());
  entry.line = readOneOf<LineStyle>(fields, strokeField, findLineStyle, lineStyleNames());
  if (kindOf(entry))
    entry.isLocked = fields.truth(lockedField, false);
  entry.label = readOneOf<LabelText>(fields, labelField, findLabelText, labelTextNames());
  entry.isHidden = fields.truth(hiddenField, false);
}

/// Reads one entry into `fields`' problem or an entry.
Entry readEntry(const DocumentNode &node, FieldReader &fields, const IsName &isName) {
  Entry entry;
  entry.name = fields.text("name");
  if (fields.optional("construction")) {
    entry.content = readUse(fields);
    readLook(fields, entry);
    return entry;
  }
  for (const Kind &kind : kinds())
    if (const DocumentNode *coordinates = fields.optional(kind.word)) {
      fields.allowOnly({"name", kind.word, colorField, strokeField, labelField, hiddenField, lockedField});
      if (followsOthers(*coordinates, kind)) {
        entry.content = readDerived(*coordinates, fields.pathOf(kind.word), fields, kind, isName);
      } else {
        Object object(kind);
        readObject(*coordinates, fields.pathOf(kind.word), fields, object, entry.on);
        entry.content = object;
      }
      readLook(fields, entry);
      return entry;
    }
  complainOfKind(node, fields);
  return entry;
}

} // namespace

Result<Scene> readScene(const DocumentNode &list, const std::string &file, const std::string &path) {
  if (list.kind != DocumentNode::Kind::List)
    return Problem{words("Here a list of objects and constructions is expected."), file, list.line, path};
  if (list.children.size() > maxSceneEntries)
    return Problem{tooManyEntries().sentence, file, list.line, path};
  Scene scene;
  SceneChecker checker;
  for (std::size_t index = 0; index < list.children.size(); ++index) {
    const DocumentNode &node = list.children[index];
    FieldReader fields(node, file, indexed(path, index));
    Entry entry =
        readEntry(node, fields, [&](std::string_view name) { return scene.entries.find(ownerOf(name)); });
    for (std::string *object : referencesIn(entry))
      *object = checker.idOf(*object);
    if (const auto problem = fields.problem() ? std::nullopt : checker.check(entry))
      fields.complain(node, fields.pathOf(problem->field), problem->sentence);
    if (fields.problem())
      return *fields.problem();
    scene.entries.push_back(std::move(entry));
  }
  return scene;
}

} // namespace halfspace
