#include "lessons/construction/reference.h"

#include "lessons/construction/construction.h"

namespace halfspace {
namespace {

std::string code(const std::string &name) { return "`" + name + "`"; }

/// What `text` makes of each, between commas.
template <class Each, class Text> std::string listed(const std::vector<Each> &all, Text text) {
  std::string list;
  for (const Each &each : all)
    list += (list.empty() ? "" : ", ") + text(each);
  return list;
}

std::string listedRoles(const std::vector<ConstructionRole> &roles) {
  return listed(roles, [](const ConstructionRole &role) {
    return code(role.name) + ": " + (role.isList ? "list of " : "") + std::string(role.kind);
  });
}

std::string textOf(const ValueName &value) {
  switch (value.shape) {
  case ValueShape::Number:
    break;
  case ValueShape::List:
    return code(value.name) + " (" + std::to_string(value.length) + " numbers)";
  case ValueShape::Word:
    return code(value.name) + " (" + listed(value.words, code) + ")";
  case ValueShape::Index:
    return code(value.name) + " (counted from 0)";
  case ValueShape::Group:
    return code(value.name) + " (a group: " + listed(value.members, textOf) + ")";
  }
  return code(value.name);
}

std::string row(const std::string &what, const std::string &names) {
  return names.empty() ? std::string() : "| " + what + " | " + names + " |\n";
}

std::string sectionOf(const Construction &construction) {
  const ConstructionNames &names = construction.names;
  return "## " + std::string(construction.id) + "\n\n| | |\n| --- | --- |\n" +
         row("what comes of it", construction.title()) + row("of", listedRoles(construction.roles)) +
         row("makes", listedRoles(construction.makes)) + row("cases", listed(names.cases, code)) +
         row("values", listed(names.values, textOf)) + row("lines", listed(names.lines, code)) +
         row("marks", listed(names.marks, code)) + "\n";
}

} // namespace

std::string referenceOfConstructions() {
  std::string text =
      "# Constructions\n\n"
      "What each looks at (`of`), what it makes for entries below it, and all names that it can "
      "come to. Not every case has every\nvalue, line and mark. A list's numbers are named as "
      "`foot.z` or `coefficients.0`, those in a group as `perp.uu`. Where several\nentries of a "
      "scene have a name, say whose: `distance.f`.\n\n"
      "An entry that looks at what another makes has one more case, `missing-object`: there is no such "
      "object in the present case of\nthe other.\n\n"
      "This page is what `halfspace constructions` prints.\n\n";
  for (const Construction &construction : constructions())
    text += sectionOf(construction);
  text.pop_back();
  return text;
}

} // namespace halfspace
