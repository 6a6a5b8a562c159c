// The tools that make objects, in words.
#pragma once

#include "widgets/picture/hand/object_tool.h"

#include <QString>

namespace halfspace {

/// What a menu needs of a tool.
struct ObjectToolWords {
  ToolObject object;
  QString id;          ///< for names of actions, in small letters: plane-through-points
  QString title;       ///< “Plane through three points”
  QString description; ///< a sentence
};

/// All tools, in the order of a menu.
[[nodiscard]] std::vector<ObjectToolWords> objectTools();

/// What the tool wants next, as words to whoever has it in the hand; empty where it wants nothing.
[[nodiscard]] QString promptOf(const ObjectTool &tool);

/// What is said where the tool wants a height, and the camera looks along it; or a place in a plane that is
/// seen from its side.
[[nodiscard]] QString endOnPrompt();

} // namespace halfspace
