#include "app/explore/command_finder.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>

#include <algorithm>

namespace halfspace {
namespace {

QString titleOf(const QAction &action) {
  QString title = action.text();
  return title.remove('&').remove("…");
}

void addCommands(const QList<QAction *> &actions, const QString &above, std::vector<Command> &commands) {
  for (QAction *action : actions) {
    if (action->isSeparator() || !action->isVisible() || !action->isEnabled())
      continue;
    const QString title = above.isEmpty() ? titleOf(*action) : above + ": " + titleOf(*action);
    if (const QMenu *menu = action->menu())
      addCommands(menu->actions(), title, commands);
    else
      commands.push_back({title, action});
  }
}

bool hasWord(const QString &title, const QString &word) {
  for (int at = title.indexOf(word, 0, Qt::CaseInsensitive); at >= 0;
       at = title.indexOf(word, at + 1, Qt::CaseInsensitive))
    if (at == 0 || !title.at(at - 1).isLetterOrNumber())
      return true;
  return false;
}

} // namespace

std::vector<Command> commandsMatching(const QMenuBar &menus, const QString &words) {
  const QStringList wanted = words.split(QRegularExpression("\\s+"), Qt::SkipEmptyParts);
  std::vector<Command> commands;
  if (wanted.isEmpty())
    return commands;
  addCommands(menus.actions(), {}, commands);
  std::erase_if(commands, [&](const Command &command) {
    return !std::all_of(wanted.begin(), wanted.end(),
                        [&](const QString &word) { return hasWord(command.title, word); });
  });
  return commands;
}

} // namespace halfspace
