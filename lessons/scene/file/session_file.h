// Sessions as text: the .halfspace format (JSON), and values given on the command line.
#pragma once

#include "lessons/result.h"
#include "lessons/scene/session.h"

#include <string>
#include <string_view>

namespace halfspace {

/// Version 2 lets a construction look at what another one makes, version 3 may say where the scene is looked
/// at from, version 4 what colour an object has, version 5 where labels were put, version 6 formulas in the
/// place of coordinates, version 7 what is hidden or locked, and `stroke` and `label`; older files are read
/// all the same.
inline constexpr int sessionFileVersion = 7;
inline constexpr std::size_t maxSessionBytes = 16u << 20;
inline constexpr int maxSessionDepth = 32;

/// The text of a .halfspace file: {"format":"halfspace","version":7,"lesson":…,"step":…,"scene":[…]};
/// coordinates are exact texts ("-10/3"). With a view also {"view":{"from":[…],"at":[…],"height":…,
/// "orthographic":…}}, in decimals, and with labels that were moved or hidden what label_fields.h says.
/// Without the meshes that are too large for it (`withoutLargeMeshes`).
[[nodiscard]] std::string writeSession(const Session &session);

/// Reads what writeSession wrote, from a stranger's hands: bounded in size and depth, every field checked.
[[nodiscard]] Result<Session> readSession(std::string_view text, const std::string &file);

/// A session after `name=value`, as --set takes it: Q=11,15,8, E.n=0,0,1.
[[nodiscard]] Result<Session> withValue(Session session, std::string_view assignment);

} // namespace halfspace
