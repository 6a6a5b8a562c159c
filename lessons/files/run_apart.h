// Work for which libraries of others read what a stranger has made, in a process of its own.
#pragma once

#include "lessons/files/bound_process.h"

#include <functional>
#include <optional>
#include <string>

namespace halfspace {

/// What the work comes to, which is done by a copy of this process within bounds. Nothing where it does not
/// end by itself (it crashes, throws, or takes longer), and where it comes to more than so many bytes. What
/// it changes, it changes for itself alone. The copy
/// has this thread and no others, so the work must wait for nothing that another one does or holds.
[[nodiscard]] std::optional<std::string> runApart(const std::function<std::string()> &work,
                                                  const ProcessBounds &bounds, std::size_t mostBytes);

} // namespace halfspace
