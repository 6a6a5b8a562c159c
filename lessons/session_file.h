// Sessions as text: the .halfspace format (JSON), and values given on the command line.
#pragma once

#include "lessons/problem.h"
#include "lessons/session.h"

namespace halfspace {

inline constexpr int sessionFileVersion = 1;
inline constexpr std::size_t maxSessionBytes = 16u << 20;
inline constexpr int maxSessionDepth = 32;
inline constexpr std::size_t maxSceneEntries = 1000;

/// The text of a .halfspace file: {"format":"halfspace","version":1,"lesson":…,"step":…,"scene":[…]};
/// coordinates are exact texts ("-10/3").
[[nodiscard]] std::string writeSession(const Session &session);

/// Reads what writeSession wrote, from a stranger's hands: bounded in size and depth, every field checked.
[[nodiscard]] Result<Session> readSession(std::string_view text, const std::string &file);

/// A session after `name=value`, as --set takes it: Q=11,15,8, E.n=0,0,1.
[[nodiscard]] Result<Session> withValue(Session session, std::string_view assignment);

/// Whether a scene can be evaluated: unique names, known constructions, roles that name entries above of the
/// right kind. If not, what is wrong.
[[nodiscard]] std::optional<Problem> checkScene(const Scene &scene);

} // namespace halfspace
