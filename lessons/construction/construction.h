// A construction: one thing taught. Each stands in one file of lessons/construction/, and its file's name in
// the list of lessons/CMakeLists.txt, from which the table is generated.
#pragma once

#include "lessons/construction/outcome.h"
#include "lessons/object/object.h"

#include <functional>
#include <span>

namespace halfspace {

/// A role: the name by which a construction knows an object that it looks at, and that object's kind.
struct ConstructionRole {
  std::string name;
  std::string_view kind;
};

/// A construction as the table holds it, with the types of its input and output erased.
struct Construction {
  std::string_view id;
  std::vector<ConstructionRole> roles;
  /// Evaluates the objects in the order of the roles; their kinds are those of the roles.
  std::function<Outcome(std::span<const Object *const>)> evaluate;
};

/// The case of an outcome.
struct CaseWords {
  std::string name;
  std::string description;
  bool degenerate = false;
};

/// Cases that several constructions have.
[[nodiscard]] CaseWords zeroNormalWords();
[[nodiscard]] CaseWords zeroDirectionWords();

/// A role typed: its name and the member of In that holds it.
template <class In, class Kind> struct TypedRole {
  const char *name;
  Kind In::*member;
};

/// Puts a construction together from its pure functions:
///   Out compute(const In &), CaseWords tell(const In &, const Out &), std::vector<NamedValue> list(const Out
///   &), Working explain(const Out &), Figure draw(const In &, const Out &).
/// Out has the letters of the lines, as terms that know their numbers.
template <class In, class Out, class... Kinds>
[[nodiscard]] Construction
makeConstruction(std::string_view id, Out (*compute)(const In &), CaseWords (*tell)(const In &, const Out &),
                 std::vector<NamedValue> (*valuesOf)(const Out &), Working (*explain)(const Out &),
                 Figure (*draw)(const In &, const Out &), TypedRole<In, Kinds>... roles) {
  Construction construction;
  construction.id = id;
  construction.roles = {ConstructionRole{roles.name, kindOf(Kinds{})}...};
  construction.evaluate = [=](std::span<const Object *const> objects) {
    In in;
    std::size_t next = 0;
    ((in.*roles.member = std::get<Kinds>(*objects[next++])), ...);
    const Out out = compute(in);
    CaseWords words = tell(in, out);
    return Outcome{std::move(words.name),        valuesOf(out),   explain(out), draw(in, out),
                   std::move(words.description), words.degenerate};
  };
  return construction;
}

/// All constructions, in the order of the CMake list.
[[nodiscard]] const std::vector<Construction> &constructions();

/// The construction with this id, or null.
[[nodiscard]] const Construction *findConstruction(std::string_view id);

} // namespace halfspace
