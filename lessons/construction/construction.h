// A construction: one thing taught. Each stands in one file of lessons/construction/, and its file's name in
// the list of lessons/CMakeLists.txt, from which the table is generated.
#pragma once

#include "lessons/construction/construction_names.h"
#include "lessons/construction/naming.h"
#include "lessons/construction/outcome.h"
#include "lessons/object/given.h"

#include <array>
#include <functional>
#include <span>

namespace halfspace {

/// A role: the name by which a construction knows an object that it looks at or makes, and that object's
/// kind.
struct ConstructionRole {
  std::string name;
  std::string_view kind;
};

using GivenObjects = std::span<const std::shared_ptr<const Given<Object>>>;

/// A construction as the table holds it, with the types of its input and output erased.
struct Construction {
  std::string_view id;
  std::vector<ConstructionRole> roles; ///< what it looks at
  std::vector<ConstructionRole> makes; ///< what later entries can look at, where the case has it
  std::vector<std::string> ownLetters; ///< of what else stands in its lines: w, f, t
  ConstructionNames names;             ///< of all that it can come to
  /// Evaluates objects in the order of the roles; their kinds are those of the roles. Of the naming all but
  /// the letters for sentences is needed.
  std::function<std::shared_ptr<const Outcome>(Naming, GivenObjects)> evaluate;
};

/// Cases that several constructions have.
[[nodiscard]] CaseWords zeroNormalWords(const Naming &naming);
[[nodiscard]] CaseWords zeroDirectionWords(const Naming &naming);

/// The naming with its letters for sentences.
[[nodiscard]] Naming withLetters(Naming naming, const std::vector<ConstructionRole> &roles,
                                 GivenObjects objects);

/// The pure functions of a construction. In is a Naming with the objects of the roles, each a Given<Kind>, in
/// their order; Out has the letters of the lines, as terms that know their numbers.
template <class In, class Out> struct ConstructionFunctions {
  Out (*compute)(const In &);
  CaseWords (*tell)(const In &, const Out &);
  std::vector<NamedValue> (*valuesOf)(const In &, const Out &);
  std::vector<MadeObject> (*make)(const In &, const Out &);
  Explanation (*explain)(const In &, const Out &);
  Figure (*draw)(const In &, const Out &);
  /// The nearest special cases, one change of one object each; none that holds already.
  std::vector<SpecialCase> (*nearby)(const In &, const Out &);
};

/// Puts a construction together: its id, the roles' names, what it makes, its own letters, the names of all
/// that it can come to, its functions.
template <class In, class Out, class... Kinds>
[[nodiscard]] Construction
makeConstruction(std::string_view id, std::array<const char *, sizeof...(Kinds)> roles,
                 std::vector<ConstructionRole> makes, std::vector<std::string> ownLetters,
                 ConstructionNames names, ConstructionFunctions<In, Out> functions) {
  Construction construction{id, {}, std::move(makes), std::move(ownLetters), std::move(names), {}};
  std::size_t next = 0;
  (construction.roles.push_back({roles.at(next++), Kinds::kind}), ...);
  construction.evaluate = [=, roles = construction.roles](Naming naming, GivenObjects objects) {
    struct Computed {
      In in;
      Out out;
    };
    std::size_t index = 0;
    In in{withLetters(std::move(naming), roles, objects), as<Kinds>(*objects[index++])...};
    Out out = functions.compute(in);
    const auto computed = std::make_shared<const Computed>(Computed{std::move(in), std::move(out)});
    const auto later = [&computed = *computed](auto function) {
      return [&computed, function] { return function(computed.in, computed.out); };
    };
    return std::make_shared<const Outcome>(
        Outcome{functions.make(computed->in, computed->out), Lazy<CaseWords>(later(functions.tell)),
                Lazy<std::vector<NamedValue>>(later(functions.valuesOf)),
                Lazy<Explanation>(later(functions.explain)), Lazy<Figure>(later(functions.draw)),
                Lazy<std::vector<SpecialCase>>(later(functions.nearby)), computed});
  };
  return construction;
}

/// All constructions, in the order of the CMake list.
[[nodiscard]] const std::vector<Construction> &constructions();

/// The construction with this id, or null.
[[nodiscard]] const Construction *findConstruction(std::string_view id);

} // namespace halfspace
