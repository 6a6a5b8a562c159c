// What is typed into the bar above the scene: entries of the scene, and what the menus do.
#pragma once

#include "widgets/explore/entry_bar.h"
#include "widgets/session_model.h"

#include <functional>

class QMenuBar;

namespace halfspace {

class EntryEdits;
class GoOnInExplore;
class SceneSelection;
struct LineWithName;

/// Reads what is entered as an entry of the scene, which it adds or changes; says what is wrong with it,
/// where, and what was perhaps meant. While somebody types it suggests how the line could go on, and what of
/// the menus has such words. In lessons, whose scenes are theirs, lines are taken to Explore.
class FieldPresenter : public QObject {
  Q_OBJECT
public:
  /// All must outlive it.
  FieldPresenter(SessionModel &model, GoOnInExplore &goOn, EntryBar &bar, EntryEdits &edits,
                 SceneSelection &selection, const QMenuBar &menus, QObject *parent = nullptr);

  /// Lets the user type.
  void open();
  /// Begins with a key that nobody else wanted.
  void begin(const QString &key);
  /// A line to be changed and entered.
  void propose(const QString &line);
  /// The line of an entry, to be edited.
  void edit(const QString &name);

signals:
  void openChanged(bool isOpen);
  void left(); ///< the scene has the keys again

private:
  /// Something that can be taken instead of what is typed.
  struct Offer {
    Suggestion shown;
    std::function<void()> take;
    QString line{}; ///< that Tab puts into the field; empty for what is no line
  };

  void show();
  void suggest();
  void addCompletions(std::vector<Offer> &offers);
  void addCommands(std::vector<Offer> &offers);
  void offer(std::vector<Offer> offers, bool isFirstChosen);
  void enter();
  void accept(const Entry &entry);
  /// Adds all of several lines, or none.
  void enterAll(const QString &lines);
  void refuse(const QString &sentence, EntryField::Part part);
  [[nodiscard]] std::vector<Offer> mends();
  void recall(int lines);
  /// Keeps what is typed, to be recalled.
  void remember();
  void leave();
  /// What the line is to stand below: all of the scene, or what is above the entry that is edited.
  [[nodiscard]] Scene above() const;
  /// The line in the field, under the name of the entry that is edited, or a free one, where it has none.
  [[nodiscard]] LineWithName namedLine() const;
  void putLine(const QString &line);

  SessionModel &m_model;
  GoOnInExplore &m_goOn;
  EntryBar &m_bar;
  EntryEdits &m_edits;
  SceneSelection &m_selection;
  const QMenuBar &m_menus;
  std::vector<Offer> m_offers;
  std::string m_edited;         ///< the entry whose line is edited; empty for a new one
  std::vector<QString> m_lines; ///< that were entered
  std::size_t m_recalled = 0;   ///< of those; their number: none
  bool m_isOpen = false;        ///< in a lesson too
};

} // namespace halfspace
