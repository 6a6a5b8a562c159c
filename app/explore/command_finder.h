// What the menus can do, found by its words.
#pragma once

#include <QString>

#include <vector>

class QAction;
class QMenuBar;

namespace halfspace {

/// An item of the menus that can be chosen now.
struct Command {
  QString title; ///< with the menus above it: “View: Theme: Dark”
  QAction *action;
};

/// The commands in whose titles each of the words occurs, at the beginning of a word; in the order of the
/// menus. None for no words.
[[nodiscard]] std::vector<Command> commandsMatching(const QMenuBar &menus, const QString &words);

} // namespace halfspace
