#include "lessons/typed/typed_use.h"

#include "lessons/construction/construction.h"
#include "lessons/object/kind.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Puts arguments into the roles of one construction.
class RoleFiller {
public:
  RoleFiller(const Construction &construction, const std::vector<Argument> &arguments,
             const SceneNames &names)
      : m_construction(construction), m_arguments(arguments), m_names(names), m_isTaken(arguments.size()) {}

  std::variant<ConstructionUse, TypedFault> fill(const std::string &word, std::size_t at) {
    const std::vector<ConstructionRole> &roles = m_construction.roles;
    const bool hasList =
        std::any_of(roles.begin(), roles.end(), [](const ConstructionRole &role) { return role.isList; });
    if (m_arguments.size() < roles.size() || (!hasList && m_arguments.size() > roles.size()))
      return TypedFault{words("This looks at {objects}.", {{"objects", objectsWantedBy(m_construction)}}), at,
                        word.size()};
    ConstructionUse use{std::string(m_construction.id), {}};
    for (const ConstructionRole &role : roles)
      for (std::size_t left = countIn(role, roles.size(), m_arguments.size()); left > 0; --left)
        if (!fillOne(role, use))
          return misfit(m_arguments[firstMisfit()], role.kind, m_names);
    return use;
  }

private:
  [[nodiscard]] std::string idOf(const Argument &argument, const ConstructionRole &role) const {
    return m_names.find(argument.formula.name, role.kind);
  }

  /// The first argument that fits goes there; false where none does.
  bool fillOne(const ConstructionRole &role, ConstructionUse &use) {
    for (std::size_t i = 0; i < m_arguments.size(); ++i)
      if (const std::string id = m_isTaken[i] ? "" : idOf(m_arguments[i], role); !id.empty()) {
        m_isTaken[i] = true;
        use.roles[role.name].ids.push_back(id);
        return true;
      }
    return false;
  }

  /// Of what is left over the first that fits nowhere, or else the first.
  [[nodiscard]] std::size_t firstMisfit() const {
    const auto fitsSomewhere = [&](const Argument &argument) {
      return std::any_of(m_construction.roles.begin(), m_construction.roles.end(),
                         [&](const ConstructionRole &role) { return !idOf(argument, role).empty(); });
    };
    for (std::size_t i = 0; i < m_arguments.size(); ++i)
      if (!m_isTaken[i] && !fitsSomewhere(m_arguments[i]))
        return i;
    return static_cast<std::size_t>(std::find(m_isTaken.begin(), m_isTaken.end(), false) - m_isTaken.begin());
  }

  const Construction &m_construction;
  const std::vector<Argument> &m_arguments;
  const SceneNames &m_names;
  std::vector<bool> m_isTaken;
};

} // namespace

std::string objectsWantedBy(const Construction &construction) {
  std::string list;
  for (const ConstructionRole &role : construction.roles)
    list += (list.empty() ? "" : ", ") + nounOf(role.kind) + (role.isList ? " …" : "");
  return list;
}

TypedFault misfit(const Argument &argument, std::string_view needed, const SceneNames &names) {
  if (argument.formula.kind != FormulaKind::Name)
    return faultAt(argument, words("Here the name of {kind} is needed.", {{"kind", nounOf(needed)}}));
  const std::string &name = argument.formula.name;
  if (const std::string_view kind = names.kindOf(name); !kind.empty())
    return faultAt(argument, words("“{name}” is {kind}: {needed} is needed here.",
                                   {{"name", name}, {"kind", nounOf(kind)}, {"needed", nounOf(needed)}}));
  if (names.isTaken(name))
    return faultAt(argument,
                   words("“{name}” is a construction: {needed} is needed here, perhaps one of what it "
                         "makes, as {name}.F.",
                         {{"name", name}, {"needed", nounOf(needed)}}));
  return faultAt(argument, words("There is no “{name}”: {needed} is needed here.",
                                 {{"name", name}, {"needed", nounOf(needed)}}));
}

std::variant<ConstructionUse, TypedFault> useOf(const std::string &word, std::size_t at,
                                                const std::vector<Argument> &arguments,
                                                const SceneNames &names) {
  std::optional<TypedFault> nearest;
  for (const Construction &construction : constructions()) {
    if (construction.id != word && construction.word != word)
      continue;
    auto use = RoleFiller(construction, arguments, names).fill(word, at);
    const auto *fault = std::get_if<TypedFault>(&use);
    if (!fault)
      return use;
    if (!nearest || fault->at > nearest->at) // what fits farther is likelier meant
      nearest = *fault;
  }
  return nearest.value();
}

} // namespace halfspace
