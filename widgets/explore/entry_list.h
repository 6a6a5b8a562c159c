// The list of a scene's entries.
#pragma once

#include "widgets/explore/entry_edits.h"
#include "widgets/explore/entry_rows.h"
#include "widgets/picture/theme.h"

#include <QTreeView>

class QMenu;

namespace halfspace {

class SceneSelection;

/// Shows the rows of a scene, shares its selection, and hands on what is done in it: a double click or Enter
/// asks for the line of an entry, F2 for another name, Delete takes away, Alt with an arrow and dragging a
/// row move; the rest stands in the menu of the right button. What an entry makes stands for the entry.
class EntryList : public QTreeView {
  Q_OBJECT
public:
  /// All must outlive it.
  EntryList(SessionModel &model, SceneSelection &selection, EntryEdits &edits, QWidget *parent = nullptr);

  void setTheme(const Theme &theme);
  /// What can be done with what is selected.
  void fillMenu(QMenu &menu);
  /// … at a place of the screen, if there is anything.
  void showMenu(const QPoint &place);

signals:
  void lineWanted(const QString &name);             ///< an entry is to be edited as it is typed
  void menuShown(QMenu &menu, const QString &name); ///< of one entry: who can do more with it adds that

protected:
  void keyPressEvent(QKeyEvent *event) override;
  void contextMenuEvent(QContextMenuEvent *event) override;
  void selectionChanged(const QItemSelection &selected, const QItemSelection &deselected) override;

private:
  void followSelection();
  /// Those that are selected, or of which something is that they make.
  [[nodiscard]] std::vector<std::string> selectedEntries() const;
  [[nodiscard]] std::string currentEntry() const; ///< empty where none is
  void askForLine(const QModelIndex &index);
  void addToggles(QMenu &menu, const Entry &entry);
  void addLabelMenu(QMenu &menu, const Entry &entry);
  void addColorMenu(QMenu &menu, const Entry &entry);
  void addLineMenu(QMenu &menu, const Entry &entry);

  SessionModel &m_model;
  SceneSelection &m_selection;
  EntryEdits &m_edits;
  EntryRows *m_rows;
  Theme m_theme;
  bool m_isFollowing = false; ///< the selection is taken from the scene
};

} // namespace halfspace
