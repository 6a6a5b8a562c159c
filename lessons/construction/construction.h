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
  bool isList = false; ///< of several objects of the kind
};

/// A list role has one to so many objects.
inline constexpr std::size_t maxListedObjects = 8;

/// Whether so many objects can stand in the role.
[[nodiscard]] inline bool isCountOf(const ConstructionRole &role, std::size_t objects) {
  return objects >= 1 && objects <= (role.isList ? maxListedObjects : 1);
}

/// How many of the objects that a construction looks at stand in one of its roles: one; in its list role all
/// that the others leave over.
[[nodiscard]] inline std::size_t countIn(const ConstructionRole &role, std::size_t roles,
                                         std::size_t objects) {
  return role.isList ? objects + 1 - roles : 1;
}

using GivenObjects = std::span<const std::shared_ptr<const Given<Object>>>;

/// A construction as the table holds it, with the types of its input and output erased.
struct Construction {
  std::string_view id;
  std::vector<ConstructionRole> roles; ///< what it looks at
  std::vector<ConstructionRole> makes; ///< what later entries can look at, where the case has it
  std::vector<std::string> ownLetters; ///< of what else stands in its lines: w, f, t
  ConstructionNames names;             ///< of all that it can come to
  bool hasCrossings;                   ///< it looks at a ray and many triangles
  /// Evaluates objects in the order of the roles, those of a list one after the other; their kinds are those
  /// of the roles. Of the naming all but
  /// the letters for sentences is needed.
  std::function<std::shared_ptr<const Outcome>(Naming, GivenObjects)> evaluate;
};

/// Cases that several constructions have.
[[nodiscard]] CaseWords zeroNormalWords(const Naming &naming);
[[nodiscard]] CaseWords zeroDirectionWords(const Naming &naming);

/// The naming with its letters for sentences.
[[nodiscard]] Naming withLetters(Naming naming, const std::vector<ConstructionRole> &roles,
                                 GivenObjects objects);

/// In the place of a kind: a role that is a list of such objects. A construction has at most one.
template <class Kind> struct Several;

namespace detail {
/// How the objects of a role are taken from the front of those that are left; `listed` are in a list.
template <class Kind> struct RoleOf {
  static constexpr std::string_view kind = Kind::kind;
  static constexpr bool isList = false;
  static Given<Kind> take(GivenObjects &left, std::size_t /*listed*/) {
    const auto &first = *left.front();
    left = left.subspan(1);
    return as<Kind>(first);
  }
};
template <class Kind> struct RoleOf<Several<Kind>> {
  static constexpr std::string_view kind = Kind::kind;
  static constexpr bool isList = true;
  static std::vector<Given<Kind>> take(GivenObjects &left, std::size_t listed) {
    std::vector<Given<Kind>> all;
    for (const auto &object : left.first(listed))
      all.push_back(as<Kind>(*object));
    left = left.subspan(listed);
    return all;
  }
};
} // namespace detail

/// The pure functions of a construction. In is a Naming with the objects of the roles, each a Given<Kind>, of
/// a list role a vector of them, in their order; Out has the letters of the lines, as terms that know their
/// numbers.
template <class In, class Out> struct ConstructionFunctions {
  Out (*compute)(const In &);
  CaseWords (*tell)(const In &, const Out &);
  std::vector<NamedValue> (*valuesOf)(const In &, const Out &);
  std::vector<MadeObject> (*make)(const In &, const Out &);
  Explanation (*explain)(const In &, const Out &);
  Figure (*draw)(const In &, const Out &);
  /// The nearest special cases, one change of one object each; none that holds already.
  std::vector<SpecialCase> (*nearby)(const In &, const Out &);
  /// Of a construction that looks at a ray and many triangles; null for all others.
  Crossings (*cross)(const In &, const Out &) = nullptr;
};

/// Puts a construction together: its id, the roles' names, what it makes, its own letters, the names of all
/// that it can come to, its functions.
template <class In, class Out, class... Kinds>
[[nodiscard]] Construction
makeConstruction(std::string_view id, std::array<const char *, sizeof...(Kinds)> roles,
                 std::vector<ConstructionRole> makes, std::vector<std::string> ownLetters,
                 ConstructionNames names, ConstructionFunctions<In, Out> functions) {
  static_assert((0 + ... + (detail::RoleOf<Kinds>::isList ? 1 : 0)) <= 1, "at most one role is a list");
  Construction construction{
      id, {}, std::move(makes), std::move(ownLetters), std::move(names), functions.cross != nullptr, {}};
  std::size_t next = 0;
  (construction.roles.push_back(
       {roles.at(next++), detail::RoleOf<Kinds>::kind, detail::RoleOf<Kinds>::isList}),
   ...);
  construction.evaluate = [=, roles = construction.roles](Naming naming, GivenObjects objects) {
    struct Computed {
      In in;
      Out out;
    };
    GivenObjects left = objects;
    const std::size_t listed = objects.size() + 1 - sizeof...(Kinds);
    In in{withLetters(std::move(naming), roles, objects), detail::RoleOf<Kinds>::take(left, listed)...};
    Out out = functions.compute(in);
    const auto computed = std::make_shared<const Computed>(Computed{std::move(in), std::move(out)});
    const auto later = [&computed = *computed](auto function) {
      return [&computed, function] { return function(computed.in, computed.out); };
    };
    return std::make_shared<const Outcome>(Outcome{
        functions.make(computed->in, computed->out), Lazy<CaseWords>(later(functions.tell)),
        Lazy<std::vector<NamedValue>>(later(functions.valuesOf)), Lazy<Explanation>(later(functions.explain)),
        Lazy<Figure>(later(functions.draw)), Lazy<std::vector<SpecialCase>>(later(functions.nearby)),
        functions.cross ? Lazy<Crossings>(later(functions.cross))
                        : Lazy<Crossings>([] { return Crossings(); }),
        computed});
  };
  return construction;
}

/// All constructions, in the order of the CMake list.
[[nodiscard]] const std::vector<Construction> &constructions();

/// The construction with this id, or null.
[[nodiscard]] const Construction *findConstruction(std::string_view id);

} // namespace halfspace
